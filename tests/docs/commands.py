#!/usr/bin/env python3
"""Runs every command that a document names, in the order of the documents, in an empty folder.

Usage: commands.py MOMENTSCOPE [--as-written]

A command is an indented line with `momentscope` in a .md file, or such a text between backticks. Each must end with exit code 0.
What takes long is made small: fewer pixels, rays and rounds, and of commands with the same options the first one is run.
--as-written runs all commands and changes nothing but what needs a display; its charts take many minutes.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ["README.md", "CONTRIBUTING.md", "docs/guide/README.md", *sorted(
    str(path.relative_to(PROJECT)) for path in (PROJECT / "docs").glob("*.md"))]
PROGRAM = re.compile(r"(?:build/release/)?momentscope(?= )")
FIRST_WORD = re.compile(r" +((build/release/)?momentscope|parallel|printf) .*")
PLACEHOLDER = re.compile(r"\b(FILE|LOG|PICTURE\.png)\b")   # of a synopsis, which is no command

# What makes a command quick: options that are set, or added where the command has none.
SMALLER = {
    "chart": ["--size 32x18", "--repeat 1", "--technique wboit", "--scene planes,ties"],
    "advise": ["--size 32x18", "--repeat 1", "--technique wboit,power6-32", "--scene planes"],
    "explore": ["--size 800x500"],
    "render": ["--size 96x54"],
    "stress": ["--rays 2"],
    "needed": ["--size 32x18"],
    "check-gpu": ["--seconds 1"],
}


def commands_of(path):
    """The commands of a document in their order, with the lines that a backslash continues."""
    text = (PROJECT / path).read_text().replace("\\\n", "")
    for line in text.splitlines():
        if line.startswith("    ") and FIRST_WORD.match(line):
            yield line.split(" #")[0].strip()
        elif not line.startswith("    "):
            yield from re.findall(r"`(momentscope [^`]+ -[^`]+)`", line)   # others only name a command


def is_synopsis(command):
    return PLACEHOLDER.search(command) is not None


def headless(command):
    """A command that opens a window draws it into a picture."""
    words = command.split()
    opens = words[1] == "explore" or words[1].startswith("--")
    return command + " --headless --screenshot opened.png" if opens and "--headless" not in words else command


def smaller(command):
    name = re.search(r"momentscope ([\w-]+)", command)
    options = list(SMALLER.get(name[1], [])) if name else []
    if "--shadows" in command:
        options = [o for o in options if not o.startswith("--technique")] + ["--shadow-size 64"]
    if "--compare" in command:
        options += ["--scene planes"]
    for option in options:
        key, value = option.split()
        command = re.sub(rf" {key} \S+", "", command)   # each time that it stands there
        command = re.sub(r"(momentscope [\w-]+)", rf"\1 {key} {value}", command, count=1)
    command = re.sub(r"check-lessons$", "check-lessons my-course/", command)   # the test `lessons` checks all
    command = re.sub(r"--random \d+", "--random 50", command)
    command = re.sub(r" --shard \S+", "", command)   # tests/shards runs shards
    return re.sub(r"figure \w+ -o \S+", "figure fig4 -o figures", command)


def options_of(command):
    """The command with the names of its options and without their values."""
    return re.search(r"momentscope(?: \w+)?", command)[0], frozenset(re.findall(r" (--?[a-z][\w-]*)", command))


def prepare(folder, program):
    """Files that the examples read and that no example before them writes."""
    (folder / "docs").mkdir()
    shutil.copytree(PROJECT / "docs/guide", folder / "docs/guide")
    (folder / "build/release").mkdir(parents=True)
    (folder / "build/release/momentscope").symlink_to(program)
    fragments = [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": 0.7, "color": [1, 0.5, 0]}]
    (folder / "ray.json").write_text(json.dumps({"fragments": fragments}))
    lesson = re.search(r"```json\n(.*?)```", (PROJECT / "docs/lessons.md").read_text(), re.S)[1]
    (folder / "my-course").mkdir()
    for path in ("my-lesson.json", "my-course/1.json"):
        (folder / path).write_text(lesson)
    for run in ("advise --scene planes --max-error 1 --size 16x9 --repeat 1 --technique wboit -o momentscope.json",
                "chart --scene planes --size 16x9 --repeat 1 --technique wboit -o chart-1.csv"):
        subprocess.run([program, *run.split()], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    as_written = "--as-written" in sys.argv
    failed = count = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prepare(folder, program)
        seen = set()
        for document in DOCUMENTS:
            for written in commands_of(document):
                if is_synopsis(written):
                    continue
                command = PROGRAM.sub("build/release/momentscope", written)
                if command.startswith("build/"):
                    command = headless(command)
                elif not as_written:
                    continue   # shards side by side
                if not as_written:
                    command = smaller(command)
                kind = command if as_written else options_of(command)
                if kind in seen:
                    continue
                seen.add(kind)
                count += 1
                begin = time.monotonic()
                result = subprocess.run(["bash", "-c", command], cwd=folder, capture_output=True, text=True, check=False)
                if time.monotonic() - begin > 5 or as_written or result.returncode != 0:
                    print(f"{time.monotonic() - begin:6.1f} s  {document}: {command}")
                if result.returncode != 0:
                    failed += 1
                    print(f"ends with exit code {result.returncode}: {result.stderr.strip() or result.stdout.strip()}")
    print(f"{count} commands of {len(DOCUMENTS)} documents, {failed} failed")
    return 1 if failed or count < 25 else 0


if __name__ == "__main__":
    sys.exit(main())
