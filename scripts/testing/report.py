"""What a run of tests says: a line for each suite, faults at once, and the total with the slowest tests."""

import shlex
import threading
from dataclasses import dataclass

from testing.sessions import Outcome
from testing.suites import Program, Suite


@dataclass(frozen=True)
class Result:
    suite: Suite
    test: str
    outcome: Outcome


class Report:
    """Collects results of all workers."""

    def __init__(self, suites: list[Suite], verbose: bool):
        self.open = {id(suite): len(suite.tests) for suite in suites}
        self.total = sum(self.open.values())
        self.results: list[Result] = []
        self.verbose = verbose
        self.lock = threading.Lock()

    def add(self, suite: Suite, test: str, outcome: Outcome, note: str = "") -> None:
        with self.lock:
            self.results.append(Result(suite, test, outcome))
            if outcome.is_fault:
                self.print_fault(suite, test, outcome, note)
            elif self.verbose:
                print(f"{outcome.output.strip()}\n", flush=True)
            self.open[id(suite)] -= 1
            if self.open[id(suite)] == 0:
                self.print_suite(suite)

    def add_end_of_process(self, program: Program, outcome: Outcome) -> None:
        """What went wrong when a test program ended, such as a leak."""
        end = Suite(program, program.name)
        with self.lock:
            self.total += 1
            self.results.append(Result(end, f"the end of {program.name}", outcome))
            print(f"\n--- {program.name} {outcome.status} after its last test ---\n{outcome.output.strip()}\n", flush=True)

    def print_suite(self, suite: Suite) -> None:
        own = [result for result in self.results if result.suite is suite]
        seconds = sum(result.outcome.seconds for result in own)
        faults = sum(result.outcome.is_fault for result in own)
        share = 100 * len(self.results) // max(self.total, 1)
        tests = "1 test " if len(own) == 1 else f"{len(own)} tests"
        said = f", {faults} failed" if faults else ""
        print(f"[{share:3}%] {seconds:6.1f} s  {suite.program.name}  {suite.name}: {tests}{said}", flush=True)

    def print_fault(self, suite: Suite, test: str, outcome: Outcome, note: str) -> None:
        print(f"\n--- {test} {outcome.status} ---\n{outcome.output.strip()}\n{note}{self.how_to_repeat(suite, test)}\n",
              flush=True)

    @staticmethod
    def how_to_repeat(suite: Suite, test: str) -> str:
        if suite.program.is_command:
            return f"Run it alone: {shlex.join(suite.program.command)}"
        return f"Run it alone: {suite.program.command[0]} --gtest_filter={shlex.quote(test)}"

    def print_end(self, seconds: float, built: float) -> bool:
        """The slowest tests, the faults again, the times, and the counts as the last line; True if all is well."""
        faults = [result for result in self.results if result.outcome.is_fault]
        skipped = [result for result in self.results if result.outcome.status == "skipped"]
        print("\nThe ten slowest tests:")
        for result in sorted(self.results, key=lambda result: -result.outcome.seconds)[:10]:
            print(f"  {result.outcome.seconds:6.1f} s  {result.test}")
        if skipped:
            print("Skipped:")
            for result in skipped:
                print(f"  {result.test}: {reason_of(result.outcome.output)}")
        if faults:
            print("Failed:")
            for result in faults:
                print(f"  {result.test} {result.outcome.status}")
        missing = self.total - len(self.results)
        if missing > 0:
            print(f"{missing} tests did not run.")
        print(f"{built:.0f} s of building and {seconds:.0f} s of testing: {minutes(built + seconds)} in all.")
        passed = len(self.results) - len(faults) - len(skipped)
        print(f"{passed} passed, {len(faults)} failed, {len(skipped)} skipped", flush=True)
        return not faults and missing <= 0


def reason_of(output: str) -> str:
    """The sentence that GTEST_SKIP was given."""
    lines = output.splitlines()
    for line, following in zip(lines, lines[1:]):
        if line.endswith(": Skipped"):
            return following
    return "no reason given"


def minutes(seconds: float) -> str:
    return f"{int(seconds) // 60} min {int(seconds) % 60:02} s"
