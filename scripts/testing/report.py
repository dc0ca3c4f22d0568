"""The report of a test run: a line for each suite, failures at once, and the total with the slowest tests."""

import shlex
import threading
from dataclasses import dataclass

from testing.sessions import Outcome
from testing.suites import Program, Suite


@dataclass(frozen=True)
class Result:
    suite: Suite
    name: str  # full
    outcome: Outcome


class Report:
    """Collects the results of all workers."""

    def __init__(self, suites: list[Suite], verbose: bool):
        self.left = {id(suite): len(suite.tests) for suite in suites}
        self.missing = {suite.full_name(test) for suite in suites for test in suite.tests}
        self.total = len(self.missing)
        self.results: list[Result] = []
        self.verbose = verbose
        self.lock = threading.Lock()

    def add(self, suite: Suite, test: str, outcome: Outcome, note: str) -> None:
        with self.lock:
            name = suite.full_name(test)
            self.results.append(Result(suite, name, outcome))
            self.missing.discard(name)
            if outcome.is_fault:
                how = f"{note}Run it alone: {how_to_repeat(suite.program, test)}"
                print(f"\n--- {name} {outcome.status} ---\n{outcome.output.strip()}\n{how}\n", flush=True)
            elif self.verbose:
                print(f"--- {name}\n{outcome.output.strip()}\n", flush=True)
            self.left[id(suite)] -= 1
            if self.left[id(suite)] == 0:
                self.print_suite(suite)

    def add_end_of_process(self, program: Program, outcome: Outcome) -> None:
        """Reports a failure at the end of a test program, such as a leak."""
        with self.lock:
            self.results.append(Result(Suite(program, program.name), f"the end of {program.name}", outcome))
            print(f"\n--- {program.name} {outcome.status} after its last test ---\n{outcome.output.strip()}\n", flush=True)

    def print_suite(self, suite: Suite) -> None:
        own = [result for result in self.results if result.suite is suite]
        seconds = sum(result.outcome.seconds for result in own)
        faults = sum(result.outcome.is_fault for result in own)
        share = 100 * (self.total - len(self.missing)) // self.total
        said = f", {faults} failed" if faults else ""
        print(f"[{share:3}%] {seconds:6.1f} s  {suite.program.name}  {suite.name}: {count(len(own), 'test')}{said}",
              flush=True)

    def failed(self) -> list[str]:
        return [result.name for result in self.results if result.outcome.is_fault]

    def print_end(self, seconds: float, built: float, has_deadline: bool = False) -> bool:
        """Prints the slowest tests, the failures again, the times, and the counts as the last line. True if all tests passed."""
        faults = [result for result in self.results if result.outcome.is_fault]
        skipped = [result for result in self.results if result.outcome.status == "skipped"]
        print("\nThe ten slowest tests:")
        for result in sorted(self.results, key=lambda result: -result.outcome.seconds)[:10]:
            print(f"  {result.outcome.seconds:6.1f} s  {result.name}")
        if skipped:
            print("Skipped:")
            for result in skipped:
                print(f"  {result.name}: {reason_of(result.outcome.output)}")
        if faults:
            print("Failed:")
            for result in faults:
                print(f"  {result.name} {result.outcome.status}")
        if self.missing:
            print(f"{count(len(self.missing), 'test')} did not {'fit into the time' if has_deadline else 'run'}.")
        print(f"{built:.0f} s of building and {seconds:.0f} s of testing: {minutes(built + seconds)} in all.")
        passed = len(self.results) - len(faults) - len(skipped)
        print(f"{passed} passed, {len(faults)} failed, {len(skipped)} skipped", flush=True)
        return not faults and (has_deadline or not self.missing)


def how_to_repeat(program: Program, test: str) -> str:
    return shlex.join(program.command if program.is_command else [*program.command, f"--gtest_filter={test}"])


def reason_of(output: str) -> str:
    """The message that was passed to GTEST_SKIP."""
    lines = output.splitlines()
    for line, following in zip(lines, lines[1:]):
        if line.endswith(": Skipped"):
            return following
    return "no reason given"


def count(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def minutes(seconds: float) -> str:
    return f"{int(seconds) // 60} min {int(seconds) % 60:02} s"
