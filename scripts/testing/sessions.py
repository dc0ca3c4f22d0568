"""Runs single tests: in a process that serves one after another (tests/serve_main.cpp), or as a command."""

import os
import re
import select
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from testing.suites import Program

END_OF_TEST = re.compile(rb"\n\x1e(\w+)\n")


@dataclass(frozen=True)
class Outcome:
    status: str  # passed, failed, skipped; crashed, timed out
    output: str
    seconds: float

    @property
    def is_fault(self) -> bool:
        return self.status not in ("passed", "skipped")

    @property
    def ended_its_process(self) -> bool:
        return self.status.startswith(("crashed", "timed out"))


def how_it_ended(code: int) -> str:
    return f"crashed ({signal.Signals(-code).name})" if code < 0 else f"crashed (exit code {code})"


class Session:
    """A process of a test program. `run` starts it again where the last test ended it."""

    def __init__(self, program: Program, project: Path):
        self.program = program
        self.project = project
        self.process: subprocess.Popen | None = None

    def start(self) -> subprocess.Popen:
        # A session of its own, so that a test that hangs is ended with whatever it started.
        return subprocess.Popen([*self.program.command, "--serve"], cwd=self.project, stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, test: str, seconds: float) -> Outcome:
        started = time.monotonic()
        if self.process is None:
            self.process = self.start()
        try:
            self.process.stdin.write(test.encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # it has ended, which reading tells
        status, output = self.read_outcome(started + seconds)
        text = output.decode(errors="replace")
        return Outcome(status, text, time.monotonic() - started)

    def read_outcome(self, deadline: float) -> tuple[str, bytes]:
        pipe = self.process.stdout.fileno()
        output = b""
        while True:
            if end := END_OF_TEST.search(output):
                return end[1].decode(), output[:end.start()]
            if not select.select([pipe], [], [], max(deadline - time.monotonic(), 0))[0]:
                self.end()
                return "timed out", output
            chunk = os.read(pipe, 1 << 16)
            if not chunk:
                status = how_it_ended(self.process.wait())
                self.end()
                return status, output
            output += chunk

    def end(self) -> None:
        """At once, with whatever the process started."""
        if self.process is not None:
            end_group(self.process)
            self.process = None

    def close(self) -> Outcome:
        """Lets the process end by itself, which is when sanitizers report leaks."""
        if self.process is None:
            return Outcome("passed", "", 0)
        started = time.monotonic()
        try:
            output, _ = self.process.communicate(timeout=120)
            code = self.process.returncode
            self.process = None
        except subprocess.TimeoutExpired:
            self.end()
            return Outcome("timed out", "The process did not end after its last test.", 120)
        status = "passed" if code == 0 else how_it_ended(code)
        return Outcome(status, output.decode(errors="replace"), time.monotonic() - started)


def run_command(program: Program, project: Path, seconds: float) -> Outcome:
    started = time.monotonic()
    process = subprocess.Popen(program.command, cwd=project, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=seconds)
        status = "passed" if process.returncode == 0 else f"failed (exit code {process.returncode})"
    except subprocess.TimeoutExpired:
        end_group(process)
        output, _ = process.communicate()
        status = "timed out"
    return Outcome(status, output.decode(errors="replace"), time.monotonic() - started)


def end_group(process: subprocess.Popen) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it has ended
    process.wait()
