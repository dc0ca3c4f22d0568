"""Runs suites on several workers at once."""

import math
import threading
import time
from pathlib import Path

from testing.report import Report
from testing.schedule import Schedule
from testing.sessions import Outcome, Session
from testing.suites import Suite


class Worker(threading.Thread):
    """Runs tests until the schedule is empty. Consecutive tests of the same program share a process."""

    def __init__(self, project: Path, schedule: Schedule, report: Report, stop: threading.Event, seconds: float):
        super().__init__(daemon=True)
        self.project = project
        self.schedule = schedule
        self.report = report
        self.stop = stop
        self.seconds = seconds  # limit for one test
        self.session: Session | None = None

    def run(self) -> None:
        suite = None
        while not self.stop.is_set() and (task := self.schedule.take(suite)) is not None:
            suite, test = task
            try:
                outcome, note = self.run_test(suite, test)
            except OSError as error:  # a program that cannot be started
                outcome, note = Outcome("failed", str(error), 0), ""
            if not self.stop.is_set():
                self.report.add(suite, test, outcome, note)
        self.close()

    def run_test(self, suite: Suite, test: str) -> tuple[Outcome, str]:
        if self.session is None or self.session.program is not suite.program:
            self.close()
            self.session = Session(suite.program, self.project)
        outcome = self.session.run(test, self.seconds)
        if not outcome.is_fault or suite.program.is_command or self.stop.is_set():
            return outcome, ""
        return outcome, self.note_on_failure(suite, test)

    def note_on_failure(self, suite: Suite, test: str) -> str:
        """Runs the test alone, to see whether only the tests before it make it fail."""
        self.close()
        self.session = Session(suite.program, self.project)
        passes = self.session.run(test, self.seconds).status == "passed"
        return "It passes alone: a test before it, or chance, made it fail.\n" if passes else ""

    def close(self) -> None:
        if self.session is not None:
            if self.stop.is_set():
                self.session.kill()
            elif (outcome := self.session.close()).is_fault:
                self.report.add_end_of_process(self.session.program, outcome)
            self.session = None

    def kill(self) -> None:
        """Ends the worker at once. Called from another thread."""
        if (session := self.session) is not None:
            session.kill()


def run_suites(suites: list[Suite], project: Path, times: dict[str, float], report: Report, jobs: int,
               seconds: float, deadline: float = math.inf) -> None:
    """Runs all tests, or those that begin before the deadline, and returns when they have ended. Ctrl+C ends the running
    tests and leaves out the rest."""
    schedule = Schedule(suites, times, deadline)
    stop = threading.Event()
    workers = [Worker(project, schedule, report, stop, seconds) for _ in range(max(jobs, 1))]
    for worker in workers:
        worker.start()
    try:
        while any(worker.is_alive() for worker in workers):
            time.sleep(0.05)
    except KeyboardInterrupt:
        stop.set()
        for worker in workers:
            worker.kill()
        for worker in workers:
            worker.join(10)
