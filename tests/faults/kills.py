#!/usr/bin/env python3
"""Kills render, chart, figure and the saving of a session by SIGKILL, SIGTERM and SIGINT.

Half of the kills come at a random time, the others as soon as a file is being written. Kills that come too late do not count.
Afterwards the old or the new file must be complete. No unfinished file may be left, except by SIGKILL, which a program cannot
handle. Finally, SIGINT ends `figure all`, which must say how many pictures it has written.

usage: kills.py MOMENTSCOPE [--kills N] [--seed N] [--short]
"""

import argparse
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from faults import is_whole_png, unfinished  # noqa: E402

SIGNALS = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT]
SMALL = ["--scene", "planes", "--size", "96x54"]
SAVE = "key L\nkey Ctrl+S\nclick @file.name\nkey Ctrl+A\ntype session.json\nclick @file.accept\nclick @file.accept\n"


def is_whole_table(data):
    text = data.decode()
    lines = [line for line in text.splitlines() if not line.startswith("# ")]
    return text.endswith("\n") and len(lines) > 1 and all(line.count(",") == lines[0].count(",") for line in lines)


def is_whole_session(data):
    try:
        return "momentscope_session" in json.loads(data) and data.endswith(b"}\n")
    except ValueError:
        return False


# The commands to run, the files that each one writes, and the check that a file is complete.
COMMANDS = {
    "render": (["render", *SMALL, "-o", "picture.png"], ["picture.png"], is_whole_png),
    "chart": (["chart", *SMALL, "--repeat", "1", "--technique", "unsorted,wboit,hashed,power4-32,power6-32,trig2-32,at:nodes=8,"
               "sorted", "-o", "chart.csv"], ["chart.csv", "chart.csv.partial"], is_whole_table),
    "figure": (["figure", "fig3", "-o", "."], ["fig3.png"], is_whole_png),
    "session": (["--headless", *SMALL[:2], "--size", "640x400", "--events", "save.events"], ["session.json"], is_whole_session),
}


class Killer:
    def __init__(self, program, seed):
        self.program, self.rng = program, random.Random(seed)
        self.seconds = {}  # time of an undisturbed run
        self.left = self.inside = self.finished = 0

    def start(self, words):
        return subprocess.Popen([self.program, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                env={**os.environ, "DISPLAY": "", "WAYLAND_DISPLAY": ""},
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))

    def make(self, name):
        """Makes the old file and measures the time."""
        if name == "session":
            pathlib.Path("session.json").write_text("old")  # so that every save asks whether to replace it
        begun = time.monotonic()
        process = self.start(COMMANDS[name][0])
        _, said = process.communicate()
        if process.returncode != 0:
            sys.exit(f"{name} fails undisturbed: {said.decode()}")
        self.seconds[name] = time.monotonic() - begun

    def wait(self, process, seconds, aimed):
        """Waits this long, or until a file is being written."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and process.poll() is None:
            if not aimed:
                time.sleep(min(0.01, max(end - time.monotonic(), 0)))
            elif any(entry.name.startswith(".momentscope-") for entry in os.scandir(".")):
                self.inside += 1
                return

    def fault_of(self, name, by, aimed):
        words, files, is_whole = COMMANDS[name]
        before = {file: pathlib.Path(file).exists() for file in files}
        process = self.start(words)
        self.wait(process, self.seconds[name] * (3 if aimed else self.rng.uniform(0, 1.1)), aimed)
        process.send_signal(by)
        _, said = process.communicate()
        self.finished += process.returncode == 0
        if process.returncode not in (0, -by):
            return f"exit code {process.returncode}, {said.decode()}"
        left = unfinished(".")
        self.left += len(left)
        for file in left:
            file.unlink()
        if left and by != signal.SIGKILL:
            return f"leaves {left[0].name}"
        for file in files:
            path = pathlib.Path(file)
            if before[file] and not file.endswith(".csv.partial") and not path.exists():
                return f"loses {file}"
            if path.exists() and not is_whole(path.read_bytes()):
                return f"leaves a part of {file}"
        return None

    def fault_of_all_figures(self):
        process = self.start(["figure", "all", "-o", "figures"])
        while process.poll() is None and not list(pathlib.Path("figures").glob("*.png")):
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        said = process.communicate()[1].decode()
        written = len(list(pathlib.Path("figures").glob("*.png")))
        if process.returncode != -signal.SIGINT or not re.search(rf"\b{written} of \d+ pictures are in", said):
            return f"exit code {process.returncode}, {written} pictures, '{said}'"
        return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--short", action="store_true")
    options = parser.parse_args()
    names = ["session"] if options.short else list(COMMANDS)
    kills = 3 if options.short else options.kills
    killer, failed = Killer(pathlib.Path(options.program).resolve(), options.seed), 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pathlib.Path("save.events").write_text(SAVE * 6)
        for name in names:
            killer.make(name)
        runs = 0
        while runs - killer.finished < kills:
            i, runs = runs, runs + 1
            name, by, aimed = names[i % len(names)], SIGNALS[i // len(names) % 3], i // (3 * len(names)) % 2 == 0
            if fault := killer.fault_of(name, by, aimed):
                failed += 1
                print(f"{name} by {by.name}, {'while it wrote' if aimed else 'at a random time'}: {fault}", flush=True)
        if not options.short:
            if fault := killer.fault_of_all_figures():
                failed += 1
                print(f"figure all by SIGINT: {fault}")
        os.chdir("/")
    print(f"{kills} kills of {', '.join(names)}: {killer.inside} while a file was written, {killer.finished} more came too late; "
          f"SIGKILL left {killer.left} unfinished files; {failed} faults")
    return 1 if failed or kills == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
