#!/usr/bin/env python3
"""Tries thousands of wrong command lines, which are made from `list parameters`, `list techniques` and --help.

Each one must be refused in time, with exit code 1, one sentence on stderr, nothing on stdout and no file written. The same
command without the fault is accepted first, so the fault must be the reason for the refusal.

usage: command_lines.py COMMAND_LINE_SERVER [--count N] [--seconds S] [--seed N] [--jobs N]
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import queue
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

RAY = '{"fragments": [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": 0.7}]}'

# A cheap valid command line for each command. OUT is the file that it writes.
BASES = {
    "explore": ["--headless", "--screenshot", "OUT.png", "--scene", "planes", "--size", "640x400"],
    "render": ["--scene", "planes", "--size", "8x8", "-o", "OUT.png"],
    "inspect": ["--ray", "ray.json"],
    "compare": ["one.png", "one.png"],
    "needed": ["--scene", "planes", "--size", "8x8"],
    "figure": ["fig1", "-o", "OUT"],
    "stress": ["--rays", "1", "--technique", "power4-32", "--condition", "CONDITION", "-o", "OUT.csv"],
    "tune": ["--ray", "ray.json", "--technique", "power4-32"],
    "chart": ["--scene", "planes", "--size", "8x8", "--repeat", "1", "--technique", "hashed", "-o", "OUT.csv"],
    "advise": ["--scene", "planes", "--size", "8x8", "--repeat", "1", "--technique", "hashed", "--max-error", "2"],
    "merge": ["one.csv", "-o", "OUT.csv"],
    "list": ["scenes"],
}
NOT_RUN = {"explore", "figure", "advise", "merge"}  # slow, or lacking input files, so only their faults are tried

NO_NUMBERS = ["nan", "inf", "-inf", "x", "1e999", "-1e999", "0x10", "1,5", " 1", "1 ", "1..2", "--", "٣", "1e", "+-1", "",
              "9" * 400, "1;2", "\t1", "1\n", "%d", "$(1)", "None", "1f", "\u202e1", "\x1b[31m1", b"\xff\xfe"]
NO_WORDS = ["", " ", "nosuch", "POWER4-32", "0.5.1", "../x", "x" * 300, "a,b,,c", ":", "=", "x\ny", "\x1b[2J", b"\xff"]
NO_FILES = ["", "missing/file", "x" * 300, "x" * 5000, ".", "/", "\x1b[2J", b"\xff.json", "ray.json/x"]

# Wrong values for options that are not parameters. Options that accept any text are not listed.
WRONG = {
    "--scene": ["", "nosuch", "missing/file.obj", "x" * 300, "ray.json", ".", "one.csv"],
    "--size": NO_NUMBERS + ["8", "8x", "x8", "0x0", "8x8x8", "-1x5", "1e1x8", "99999x8", "8X8", "8 x 8", "8*8"],
    "--pixel": NO_NUMBERS + ["1", "1,", "1,2,3", "-1,0", "99999,0", "0.5,1", "1;2", "8x8"],
    "--ray": NO_FILES + ["one.png", "one.csv"],
    "--technique": NO_WORDS + ["power4", "power4-32:", "power4-32:beta", "power4-32:beta=2", "power4-32:nodes=4", "at:nodes=1",
                               "at:nodes=", "at:nodes=4:nodes=5", "sorted:beta=1"],
    "--samples": NO_NUMBERS + ["0", "1", "-5", "1000001", "2.5"],
    "--depths": NO_NUMBERS + ["2", "-1.5", "0,,1", "0,", ",0", "0 1"],
    "--format": NO_WORDS + ["JSON", "pdf", "json,csv"],
    "--receiver": NO_WORDS + ["0", "-1", "1.5", "Surface", "99999999"],
    "--metric": NO_WORDS + ["RMSE", "mse", "rmse,flip"],
    "--region": NO_NUMBERS + ["0,0,0,0", "0,0,9,9", "1,2,3", "-1,0,2,2", "0,0,1.5,1", "99999,0,1,1"],
    "--rays": NO_NUMBERS + ["0", "-1", "1.5", "1000001"],
    "--seed": NO_NUMBERS + ["-1", "1.5", "2000000001"],
    "--random": NO_NUMBERS + ["0", "-1", "1.5", "1000001"],
    "--repeat": NO_NUMBERS + ["0", "-1", "1.5", "1001"],
    "--shard": NO_NUMBERS + ["0/1", "2/1", "1", "1/0", "-1/2", "1/2/3", "1/99999", "a/b"],
    "--condition": NO_WORDS,
    "--basis": NO_WORDS + ["trigonometric", "Power"],
    "--max-failures": NO_NUMBERS + ["-0.1", "1.1"],
    "--max-error": NO_NUMBERS + ["0", "-1"],
    "--max-bits": NO_NUMBERS + ["0", "-1", "1.5"],
    "--max-ms": NO_NUMBERS + ["0", "-1"],
    "--chart": NO_FILES + ["one.png", "ray.json"],
    "--compare": NO_WORDS + ["power4"],
    "--session": NO_FILES + ["one.png", "ray.json"],
    "--events": NO_FILES + ["one.png"],
    "--screenshot": ["", "x.jpg", "x", "missing/x.png", "x" * 300 + ".png", "x.png/y.png"],
    "--ui-scale": NO_NUMBERS + ["0", "0.4", "4.1", "-1"],
    "--theme": NO_WORDS + ["Dark", "blue"],
    "--output": ["", "missing/x", "x" * 300, ".", "ray.json/x"],
    "--log": ["", "missing/x", ".", "x" * 300],
}
OTHER_POSITIONALS = {"compare": [["one.png"], ["one.png", "one.png", "one.png"], ["one.png", "missing.png"], ["ray.json", "one.png"],
                                 ["", "one.png"], [b"\xff", "one.png"], ["one.png", "x" * 300]],
                     "figure": [["nosuch"], [""], ["fig1", "fig4"], [b"\xff"]],
                     "merge": [["missing.csv"], ["one.png"], ["ray.json"], [""]],
                     "list": [["nosuch"], [""], ["scenes", "techniques"], ["Scenes"]]}


class Result:
    def __init__(self, returncode, stdout, stderr):
        self.returncode, self.stdout, self.stderr = returncode, stdout, stderr


class Program:
    """Runs several command lines at a time in a folder, each with a server (command_line_server.cpp) that forks."""

    def __init__(self, server, folder, jobs):
        self.folder, self.idle = folder, queue.SimpleQueue()
        for job in range(jobs):
            files = [folder / f".stdout-{job}", folder / f".stderr-{job}"]
            process = subprocess.Popen([server, *files], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       env={**os.environ, "DISPLAY": "", "WAYLAND_DISPLAY": ""})
            self.idle.put((process, files))

    def run(self, arguments):
        words = [as_bytes(word) for word in arguments]
        process, files = self.idle.get()
        process.stdin.write(b"%d\n" % len(words) + b"".join(word + b"\0" for word in words))
        process.stdin.flush()
        code = int(process.stdout.readline())
        result = Result(code, *(file.read_bytes() for file in files))
        self.idle.put((process, files))
        return result

    def json(self, *arguments):
        return json.loads(self.run([*arguments, "--format", "json"]).stdout)

    def options(self, command):
        """The options of a command from its help: {option: whether it takes a value}."""
        text = self.run([command, "--help"]).stdout.decode()
        found = re.findall(r"^  (?:-\w,)?(--[a-z-]+)( TEXT| \[)?", text, re.MULTILINE)
        return {name: bool(value) for name, value in found if name != "--help"}


def wrong_values(row):
    """Wrong values of a parameter."""
    values = list(NO_NUMBERS)
    if row["choices"]:
        return [*NO_WORDS, *(f"{choice}x" for choice in row["choices"]), *(choice.upper() + "!" for choice in row["choices"])]
    below, above = row["minimum"] - 1, row["maximum"] * 2 + 1
    values += [str(below), str(above), "1e30", "-1e30"]
    if row["default"] != "auto":
        values.append("auto")
    if row.get("whole"):
        values += [str(row["minimum"] + 0.5)]
    return values


def replaced(base, option, value):
    """The base command with this value of the option, instead of its own value."""
    short = {"--output": "-o"}
    line, skip = [], False
    for word in base:
        if skip:
            skip = False
        elif word in (option, short.get(option)):
            skip = True
        else:
            line.append(word)
    value = value if isinstance(value, bytes) else value.encode()
    return [*line, option.encode() + b"=" + value if value.startswith(b"-") else option, *([] if value.startswith(b"-") else [value])]


def wrong_lines(program, rng):
    """Yields wrong command lines without an end, each with what is wrong with it."""
    parameters = {"--" + row["key"]: row for row in program.json("list", "parameters")}
    techniques = program.json("list", "techniques")
    condition = program.json("list", "conditions")[0]["id"]
    commands = {command: [condition if word == "CONDITION" else word for word in base] for command, base in BASES.items()}
    options = {command: program.options(command) for command in commands}
    every = sorted({option for known in options.values() for option in known})
    picture = {"opacity", "order", "order-seed", "tone-map", "shadows"}

    def a_wrong_value(command):
        option = rng.choice([name for name, value in options[command].items() if value])
        if option in parameters:
            return replaced(commands[command], option, rng.choice(wrong_values(parameters[option]))), option
        if option not in WRONG:
            return None
        base = commands[command]
        if option == "--pixel":
            base = ["--scene", "planes", "--size", "8x8"]
        if option in ("--scene", "--size") and command in ("inspect", "tune"):
            base = [word for word in base if word not in ("--ray", "ray.json")]
        if option == "--random":
            base = ["--technique", "power4-32"]
        if option == "--seed" and command == "tune":
            base = ["--random", "5", "--technique", "power4-32"]
        if option == "--receiver":
            base = ["--scene", "planes", "--size", "8x8", "--light", "--shadows"]
        if option in ("--scene", "--size") and command == "compare":
            base = ["one.png", "wboit"]
        if option == "--session":
            base = ["--headless", "--screenshot", "OUT.png"]
        return replaced(base, option, rng.choice(WRONG[option])), option

    def an_unknown_option(command):
        option = rng.choice([name for name in every if len(name) > 4])
        place = rng.randrange(3, len(option))
        wrong = option[:place] + rng.choice("xyz") + option[place + rng.randrange(2):]
        if any(known.startswith(wrong) for known in options[command]):
            return None
        return [*commands[command], wrong, "1"], wrong

    def another_commands_option(command):
        option = rng.choice([name for name in every if name not in options[command]])
        return [*commands[command], option, "1"], option

    def an_option_before_the_command(command):
        if command == "explore":
            return None
        option = rng.choice(list(parameters))
        value = parameters[option]["choices"][0] if parameters[option]["choices"] else str(parameters[option]["maximum"])
        return [option, value, command, *commands[command]], option

    def a_missing_value(command):
        option = rng.choice([name for name, value in options[command].items()
                             if value and (name not in parameters or name not in ("--lanczos", "--renormalize", "--shadows"))])
        return [*commands[command], option], option

    def an_option_twice(command):
        option = rng.choice([name for name in options[command] if name in parameters and name != "--shadows"] or ["-x"])
        if option == "-x":
            return None
        row = parameters[option]
        value = row["choices"][0] if row["choices"] else str(row["maximum"])
        return [*commands[command], option, value, option, value], option

    def an_ignored_parameter(command):
        if command not in ("render", "inspect", "stress", "tune"):
            return None
        technique = rng.choice(techniques)
        ignored = [option for option in parameters
                   if option[2:] not in technique["parameters"] and option[2:] not in picture
                   and not option.startswith(("--shadow", "--light", "--opaque"))]
        if not ignored:
            return None
        option = rng.choice(ignored)
        row = parameters[option]
        value = row["choices"][-1] if row["choices"] else str(row["maximum"])
        if command in ("stress", "tune") and "alpha" not in technique["parameters"]:
            return None
        return [*replaced(commands[command], "--technique", technique["id"]), option, value], option

    def wrong_positionals(command):
        if command not in OTHER_POSITIONALS:
            return None
        rest = commands[command][{"compare": 2}.get(command, 1):]
        return [*rng.choice(OTHER_POSITIONALS[command]), *rest], "the arguments"

    kinds = [a_wrong_value] * 5 + [an_unknown_option, another_commands_option, an_option_before_the_command, a_missing_value,
                                   an_option_twice, an_ignored_parameter, an_ignored_parameter, wrong_positionals]
    while True:
        command = rng.choice(list(commands))
        made = rng.choice(kinds)(command)
        if made is None:
            continue
        line, fault = made
        yield line if command in line else [command, *line], fault


def as_bytes(word):
    return word if isinstance(word, bytes) else word.encode()


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


def make_files(program):
    (program.folder / "ray.json").write_text(RAY)
    program.run(["render", "--scene", "planes", "--size", "8x8", "-o", "one.png"])
    program.run(["stress", "--rays", "1", "--technique", "power4-32", "--condition", "random-3", "-o", "one.csv"])


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
