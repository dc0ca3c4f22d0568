"""Runs single tests: in a process that runs one test after another (tests/serve_main.cpp), or as a command."""

import contextlib
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
    status: str  # passed, skipped; failed, crashed, timed out
    output: str
    seconds: float

    @property
    def is_fault(self) -> bool:
        return self.status not in ("passed", "skipped")


def how_it_ended(code: int) -> str:
    return f"crashed (signal {-code})" if code < 0 else f"crashed (exit code {code})"


class Session:
    """The process of a program or a command. It has a process group of its own, so everything that it started ends with it."""

    def __init__(self, program: Program, project: Path):
        self.program = program
        self.project = project
        self.process: subprocess.Popen | None = None

    def start(self, *arguments: str) -> subprocess.Popen:
        return subprocess.Popen([*self.program.command, *arguments], cwd=self.project, stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, test: str, seconds: float) -> Outcome:
        """Runs one test, in a new process if the last test ended the process."""
        started = time.monotonic()
        if self.process is None:
            self.process = self.start() if self.program.is_command else self.start("--serve")
        if self.program.is_command:
            status, output = self.read_to_end(started + seconds)
        else:
            self.ask_for(test)
            status, output = self.read_answer(started + seconds)
        return Outcome(status, output.decode(errors="replace"), time.monotonic() - started)

    def ask_for(self, test: str) -> None:
        try:
            self.process.stdin.write(test.encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # the process has ended; reading will show that

    def read_answer(self, deadline: float) -> tuple[str, bytes]:
        output = b""
        while not (end := END_OF_TEST.search(output)):
            chunk = self.read_chunk(deadline)
            if chunk is None:
                self.end()
                return "timed out", output
            if not chunk:
                return how_it_ended(self.end()), output
            output += chunk
        return end[1].decode(), output[:end.start()]

    def read_to_end(self, deadline: float) -> tuple[str, bytes]:
        output = b""
        while chunk := self.read_chunk(deadline):
            output += chunk
        code = self.end()
        if chunk is None:
            return "timed out", output
        return "passed" if code == 0 else f"failed (exit code {code})", output

    def read_chunk(self, deadline: float) -> bytes | None:
        """The next output of the process: empty if the process has ended, None if the time is over."""
        process = self.process
        while time.monotonic() < deadline:
            if select.select([process.stdout], [], [], 0.5)[0]:
                return os.read(process.stdout.fileno(), 1 << 16)
            if process.poll() is not None:
                return b""  # a process that it started still holds the output open
        return None

    def end(self) -> int:
        """Ends the process and everything that it started, and returns its exit code. A process that has closed its output gets
        a moment to end by itself."""
        process, self.process = self.process, None
        if process is None:
            return 0
        try:
            process.wait(timeout=5 if has_ended_output(process) else 0)
        except subprocess.TimeoutExpired:
            pass
        kill_group(process)
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        process.stdout.close()
        return process.wait()

    def kill(self) -> None:
        """Ends the process at once. Called from another thread."""
        if (process := self.process) is not None:
            kill_group(process)

    def close(self) -> Outcome:
        """Lets the process end by itself, because sanitizers report leaks at that time."""
        if self.process is None:
            return Outcome("passed", "", 0)
        started = time.monotonic()
        self.process.stdin.close()
        output = b""
        while chunk := self.read_chunk(started + 120):
            output += chunk
        code = self.end()
        status = "timed out" if chunk is None else "passed" if code == 0 else how_it_ended(code)
        return Outcome(status, output.decode(errors="replace"), time.monotonic() - started)


def has_ended_output(process: subprocess.Popen) -> bool:
    """True if reading has reached the end, instead of waiting for more."""
    return bool(select.select([process.stdout], [], [], 0)[0])


def kill_group(process: subprocess.Popen) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it has ended
