"""Runs suites on several workers at once."""

import threading
from pathlib import Path

from testing.report import Report
from testing.schedule import Schedule
from testing.sessions import Session, run_command
from testing.suites import Suite


class Worker(threading.Thread):
    """Runs tests until the schedule has no more, in one process as long as they are of one program."""

    def __init__(self, project: Path, schedule: Schedule, report: Report, stop: threading.Event, seconds: float):
        super().__init__()
        self.project = project
        self.schedule = schedule
        self.report = report
        self.stop = stop
        self.seconds = seconds  # that a test may take
        self.session: Session | None = None

    def run(self) -> None:
        suite = None
        while not self.stop.is_set() and (task := self.schedule.take(suite)) is not None:
            suite, test = task
            if suite.program.is_command:
                self.report.add(suite, test, run_command(suite.program, self.project, self.seconds))
            else:
                self.run_test(suite, test)
        self.close()

    def run_test(self, suite: Suite, test: str) -> None:
        if self.session is None or self.session.program is not suite.program:
            self.close()
            self.session = Session(suite.program, self.project)
        outcome = self.session.run(test, self.seconds)
        note = self.note_on_failure(suite, test) if outcome.status == "failed" else ""
        self.report.add(suite, test, outcome, note)

    def note_on_failure(self, suite: Suite, test: str) -> str:
        """Tells a test that fails from one that its neighbours make fail."""
        alone = Session(suite.program, self.project)
        passes = alone.run(test, self.seconds).status == "passed"
        alone.end()
        return "In a process of its own it passes: look at what ran before it, or at chance.\n" if passes else ""

    def close(self) -> None:
        if self.session is not None:
            if self.stop.is_set():
                self.session.end()
            elif (outcome := self.session.close()).is_fault:
                self.report.add_end_of_process(self.session.program, outcome)
            self.session = None


def run_suites(suites: list[Suite], project: Path, times: dict[str, float], report: Report, jobs: int,
               seconds: float) -> None:
    """Returns when all tests are done, or after Ctrl+C the tests that were running."""
    schedule = Schedule(suites, times)
    stop = threading.Event()
    workers = [Worker(project, schedule, report, stop, seconds) for _ in range(max(jobs, 1))]
    for worker in workers:
        worker.start()
    while any(worker.is_alive() for worker in workers):
        try:
            for worker in workers:
                worker.join()
        except KeyboardInterrupt:
            print("Stopping after the tests that run now.", flush=True)
            stop.set()
