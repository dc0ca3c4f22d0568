#!/usr/bin/env python3
"""Tries thousands of wrong command lines, which are made from `list parameters`, `list techniques` and --help.

Each one must be refused in time, with exit code 1, one sentence on stderr, nothing on stdout and no file written. The same
command without the fault is accepted first, so the fault must be the reason for the refusal.

usage: command_lines.py COMMAND_LINE_SERVER [--count N] [--seconds S] [--seed N] [--jobs N]
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import signal
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from program import Program, as_bytes, make_files  # noqa: E402
from wrong_lines import BASES, NOT_RUN, wrong_lines  # noqa: E402


def fault_of(program, line):
    """What is wrong with the way in which the program refuses a line, or None."""
    result = program.run(line)
    said = result.stderr
    if result.returncode == -signal.SIGALRM:
        return "hangs"
    if result.returncode != 1:
        return f"exit code {result.returncode}"
    if result.stdout:
        return "writes to stdout"
    if not said.startswith(b"momentscope: ") or said.count(b"\n") != 1 or not said.endswith(b".\n"):
        return "does not say one sentence"
    if b"Something failed" in said:
        return "did not foresee it"
    if any(byte < 32 for byte in said[:-1]) or 127 in said:
        return "writes control characters"
    try:
        text = said.decode()
    except UnicodeDecodeError:
        return "writes bad UTF-8"
    if any(0x80 <= ord(letter) < 0xA0 for letter in text):
        return "writes C1 control characters"
    return None


def shown(line):
    return " ".join(repr(as_bytes(word)[:60])[1:] for word in line)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("server")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    failed, count, begun = 0, 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        program = Program(str(pathlib.Path(options.server).resolve()), pathlib.Path(folder), options.jobs)
        make_files(program)
        rng = random.Random(options.seed)
        condition = program.json("list", "conditions")[0]["id"]
        for command in [] if options.seconds < 60 else sorted(set(BASES) - NOT_RUN):
            line = [command, *(word.replace("CONDITION", condition) for word in BASES[command])]
            result = program.run(line)
            if result.returncode != 0:
                failed += 1
                print(f"{shown(line)}\n  is refused: {result.stderr.decode()}")
        for left_over in program.folder.glob("OUT*"):
            left_over.unlink()
        lines = wrong_lines(program, rng)
        while count < options.count and time.monotonic() - begun < options.seconds:
            batch = [next(lines) for _ in range(min(16, options.count - count))]
            for (line, fault), wrong in zip(batch, pool.map(lambda one: fault_of(program, one[0]), batch)):
                count += 1
                if wrong:
                    failed += 1
                    print(f"{shown(line)}\n  ({fault}) {wrong}", flush=True)
        for written in program.folder.glob("OUT*"):
            failed += 1
            print(f"{written.name} was written")
    print(f"{count} wrong command lines, {failed} of them not refused as they should be, {time.monotonic() - begun:.0f} s")
    return 1 if failed or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
