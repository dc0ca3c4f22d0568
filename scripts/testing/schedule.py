"""Decides which test a worker runs next."""

import threading
import time

from testing.suites import Program, Suite

SECONDS_OF_AN_UNKNOWN_TEST = 0.5


class Schedule:
    """Hands out tests one by one. A worker stays with a suite, and then with a program, because its process has already
    loaded and compiled what the tests need. When all suites are taken, it helps where most work is left. The longest
    tests come first, by the times of the last run. No test begins after the deadline, a time of time.monotonic()."""

    def __init__(self, suites: list[Suite], seconds: dict[str, float], deadline: float):
        self.deadline = deadline
        self.seconds = seconds
        self.lock = threading.Lock()
        self.waiting = sorted(suites, key=self.left, reverse=True)  # not taken by a worker yet
        self.taken: list[Suite] = []

    def left(self, suite: Suite) -> float:
        return sum(self.seconds.get(suite.full_name(test), SECONDS_OF_AN_UNKNOWN_TEST) for test in suite.tests)

    def take(self, last: Suite | None) -> tuple[Suite, str] | None:
        """The next test for a worker whose last test belonged to suite `last`; None if there are no more."""
        with self.lock:
            suite = self.choose(last)
            if suite is None or time.monotonic() > self.deadline:
                return None
            if suite in self.waiting:
                self.waiting.remove(suite)
                self.taken.append(suite)
            test = suite.tests.pop(0)
            if not suite.tests:
                self.taken.remove(suite)
            return suite, test

    def choose(self, last: Suite | None) -> Suite | None:
        if last is not None:
            if last.tests:
                return last
            for suite in self.waiting:
                if suite.program is last.program:
                    return suite
        if self.waiting:
            program = max((suite.program for suite in self.waiting), key=self.urgency)
            return next(suite for suite in self.waiting if suite.program is program)
        return max(self.taken, key=self.left, default=None)

    def urgency(self, program: Program) -> tuple[bool, bool, float]:
        """Commands come first, because several workers cannot share them; then programs without a worker."""
        busy = any(suite.program is program for suite in self.taken)
        return program.is_command, not busy, sum(self.left(suite) for suite in self.waiting if suite.program is program)
