#!/usr/bin/env python3
"""Writes every kind of output to a full disk. Each time there must be exit code 1, a sentence, and the complete old file.

As root, the disk is a tmpfs of 64 KiB, which is filled so that at most half of the output fits. Otherwise, or with --limit,
no file may grow beyond half of the output (RLIMIT_FSIZE). Printed text goes to /dev/full and to a closed standard output.

usage: full_disk.py COMMAND_LINE_SERVER [--short] [--limit]
"""

import argparse
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from faults import RAY, Server, unfinished  # noqa: E402

PAGE, DISK = 4096, 65536
OLD = b"old\n" * (PAGE // 4)

SMALL = ["--scene", "planes", "--size", "64x36"]
CHART = [*SMALL, "--repeat", "1", "--technique", "wboit,power4-32"]
STRESS = ["stress", "--rays", "5", "--technique", "power4-32,trig3-16"]
WINDOW = ["--headless", "--scene", "planes", "--technique", "power4-32", "--size", "960x600"]
ASKED = "click @file.name\nkey Ctrl+A\ntype OUT\nclick @file.accept\nclick @file.accept\nwait 1\n"
EXPORT = "key Ctrl+E\nclick @file.kind\nclick @file.kind.{}\n" + ASKED + "expect-message Written to\n"
CHARTED = ("key Ctrl+8\nclick @chart.size\nclick @chart.size.160\nclick @chart.standards_only\nclick @chart.measure\n"
           "click @chart.save\nclick @file.kind\nclick @file.kind.{}\n" + ASKED + "expect-message Written to\n")
EVENTS = {
    "window.png": "screenshot OUT\n",
    "session.json": "key Ctrl+S\n" + ASKED + "expect-message The session was saved\n",
    **{f"export.{kind}": EXPORT.format(name) for kind, name in
       {"curves.csv": "curves_csv", "curves.json": "curves_json", "fragments.csv": "fragments_csv", "ray.json": "ray_json",
        "picture.png": "picture_png", "picture.exr": "picture_exr", "window.png": "window_png"}.items()},
    **{f"panel.{kind}": CHARTED.format(f"chart_{kind}") for kind in ["csv", "html", "svg", "md"]},
}

# Each output file and the command that writes it. OUT is the path of the file, DISK its folder.
FILES = {
    "render.png": ["render", *SMALL, "-o", "OUT"],
    "render.exr": ["render", *SMALL, "-o", "OUT"],
    "inspect.json": ["inspect", "--ray", "ray.json", "-o", "OUT"],
    "inspect.csv": ["inspect", "--ray", "ray.json", "--format", "csv", "-o", "OUT"],
    "inspect.txt": ["inspect", "--ray", "ray.json", "--format", "table", "-o", "OUT"],
    "map.png": ["compare", "one.png", "wboit", "--metric", "flip", *SMALL, "-o", "OUT"],
    "needed.png": ["needed", *SMALL, "-o", "OUT"],
    "needed.json": ["needed", *SMALL, "-o", "OUT"],
    "stress.csv": [*STRESS, "-o", "OUT"],
    "stress.html": [*STRESS, "-o", "OUT"],
    "stress.png": [*STRESS, "-o", "OUT"],
    **{f"chart.{kind}": ["chart", *CHART, "-o", "OUT"] for kind in ["csv", "md", "svg", "html", "png"]},
    **{f"shadows.{kind}": ["chart", *SMALL, "--shadows", "--shadow-size", "64", "--repeat", "1", "-o", "OUT"]
       for kind in ["csv", "md"]},
    "merge-stress.csv": ["merge", "stress.csv", "-o", "OUT"],
    **{f"merge.{kind}": ["merge", "chart.csv", "-o", "OUT"] for kind in ["csv", "md", "svg", "html", "png"]},
    "recipe.json": ["advise", *CHART, "--max-error", "0.9", "-o", "OUT"],
    "fig3.png": ["figure", "fig3", "-o", "DISK"],
    "screenshot.png": [*WINDOW, "--screenshot", "OUT"],
    "frames.log": [*WINDOW, "--events", "frames.log.events", "--log", "OUT"],
    **{name: [*WINDOW, "--events", f"{name}.events"] for name in EVENTS},
}
SHORT = ["render.png", "inspect.json", "merge.svg", "session.json", "frames.log"]

PRINTED = {
    "--help": ["--help"],
    **{f"{command} --help": [command, "--help"] for command in
       ["explore", "render", "inspect", "compare", "figure", "needed", "stress", "tune", "chart", "advise", "merge", "list"]},
    **{f"list {what}": ["list", what] for what in ["techniques", "scenes", "parameters", "conditions", "figures", "commands"]},
    "inspect": ["inspect", "--ray", "ray.json"],
    "compare": ["compare", "one.png", "one.png"],
    "stress": ["stress", "--rays", "1", "--technique", "power4-32"],
    "stress -o": ["stress", "--rays", "1", "--technique", "power4-32", "-o", "printed.csv"],
    "tune": ["tune", "--ray", "ray.json", "--technique", "power4-32"],
    "merge": ["merge", "chart.csv", "-o", "printed.csv"],
    "needed": ["needed", *SMALL],
    "chart": ["chart", *CHART],
    "chart --shadows": ["chart", *SMALL, "--shadows", "--shadow-size", "64", "--repeat", "1"],
    "advise": ["advise", *CHART, "--max-error", "0.9"],
    "figure": ["figure", "fig3"],
}
SHORT_PRINTED = ["--help", "chart --help", "list techniques", "inspect", "merge"]


def words_of(name, path):
    words = [str(path) if word == "OUT" else str(path.parent) if word == "DISK" else word for word in FILES[name]]
    for word in words:
        if word.endswith(".events"):
            pathlib.Path(word).write_text(EVENTS.get(name, "key L\n" * 20).replace("OUT", str(path)))
    return words


class Disk:
    """A folder with an old file and space for a limited number of further bytes."""

    def __init__(self, server, limit):
        self.server, self.limit = server, limit
        self.folder = pathlib.Path(tempfile.mkdtemp())
        if not limit:
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK}", "tmpfs", self.folder], check=True)

    def fill(self, path, room):
        for file in self.folder.iterdir():
            file.unlink()
        path.write_bytes(OLD)
        if self.limit:
            self.set_limit(max(room, 400))  # the error sentence is also written to a file
        else:
            pages = min(room // PAGE, DISK // PAGE // 2)
            (self.folder / "filler").write_bytes(b"x" * (DISK - PAGE * (1 + pages)))

    def set_limit(self, most):
        hard = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
        resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE, (most, hard))

    def close(self):
        if not self.limit:
            subprocess.run(["umount", self.folder], check=True)
        self.folder.rmdir() if not self.limit else shutil.rmtree(self.folder)


def fault_of_file(name, server, disk):
    """What is wrong with the program's reaction to a full disk, or None; and the size of the complete file."""
    whole = pathlib.Path("whole") / name
    whole.write_bytes(OLD)
    code, said = server.run(words_of(name, whole.resolve()))
    if code != 0 or whole.read_bytes() == OLD:
        return f"does not even work with room: {code}, {said[:200]}", 0
    size = whole.stat().st_size
    path = disk.folder / name
    disk.fill(path, size // 2)
    code, said = server.run(words_of(name, path))
    if disk.limit:
        disk.set_limit(resource.RLIM_INFINITY)
    if code != 1:
        return f"exit code {code}, '{said}'", size
    if "could not be written" not in said:
        return f"says '{said}'", size
    if path.read_bytes() != OLD:
        return f"{path.stat().st_size} bytes instead of the old file", size
    kept = f"{name}.partial"  # the rows of a chart, if its picture or page did not fit
    if left := [file.name for file in disk.folder.iterdir() if file.name not in (name, "filler", kept)]:
        return f"leaves {left}", size
    return None, size


def make_inputs(server, short):
    pathlib.Path("whole").mkdir()
    pathlib.Path("ray.json").write_text(RAY % 0.7)
    commands = [["chart", *CHART, "-o", "chart.csv"], ["render", *SMALL, "-o", "one.png"], [*STRESS, "-o", "stress.csv"]]
    for words in commands[:1] if short else commands:
        code, said = server.run(words)
        if code != 0:
            sys.exit(f"{' '.join(words)}: {said}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("server")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--limit", action="store_true")
    options = parser.parse_args()
    program, failed = pathlib.Path(options.server).resolve(), 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        server = Server(program, folder)
        make_inputs(server, options.short)
        disk = Disk(server, options.limit or os.geteuid() != 0)
        names = SHORT if options.short else FILES
        for name in names:
            fault, size = fault_of_file(name, server, disk)
            failed += fault is not None
            if fault or not options.short:
                print(f"{name:<22}{size:>9} bytes: {fault or 'refused, and the old file is whole'}", flush=True)
        if unfinished("whole"):
            failed += 1
            print("an unfinished file was left behind")
        disk.close()
        server.close()
        printed = SHORT_PRINTED if options.short else PRINTED
        for place, output in (("/dev/full", "/dev/full"), ("a closed standard output", "")):
            server = Server(program, folder, output)
            for name in printed:
                code, said = server.run(PRINTED[name])
                if code != 1 or "Standard output could not be written" not in said:
                    failed += 1
                    print(f"{name} on {place}: exit code {code}, '{said[:200]}'", flush=True)
            server.close()
        os.chdir("/")
    kind = "files that may not grow" if options.limit or os.geteuid() != 0 else f"a disk of {DISK} bytes"
    print(f"{len(names)} outputs on {kind}, {len(printed)} commands whose output is full or closed: {failed} faults")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
