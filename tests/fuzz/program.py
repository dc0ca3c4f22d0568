"""Runs command lines in a folder, and makes the files that they read."""

import json
import os
import queue
import re
import subprocess

RAY = '{"fragments": [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": 0.7}]}'


def as_bytes(word):
    return word if isinstance(word, bytes) else word.encode()


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


def make_files(program):
    (program.folder / "ray.json").write_text(RAY)
    program.run(["render", "--scene", "planes", "--size", "8x8", "-o", "one.png"])
    program.run(["stress", "--rays", "1", "--technique", "power4-32", "--condition", "random-3", "-o", "one.csv"])
