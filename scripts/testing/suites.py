"""The tests that a build has: programs of GoogleTest, whose tests it lists, and commands."""

import json
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Program:
    """A test program, or a command that is one test."""
    name: str
    label: str
    command: tuple[str, ...]
    targets: tuple[str, ...]  # what to build for it
    is_command: bool


@dataclass
class Suite:
    """Tests that one process should run one after another."""
    program: Program
    name: str
    tests: list[str] = field(default_factory=list)


def read_programs(build: Path) -> list[Program]:
    """Reads the list that CMake writes (tests/CMakeLists.txt); empty before the first configuration."""
    path = build / "tests.json"
    if not path.exists():
        return []
    return [Program(row["name"], row["label"], tuple(row["command"]), tuple(row["targets"]), row["is_command"])
            for row in json.loads(path.read_text())]


def parse_list(text: str) -> dict[str, list[str]]:
    """The tests of each suite, from what --gtest_list_tests prints."""
    suites: dict[str, list[str]] = {}
    suite = ""
    for line in text.splitlines():
        name = line.split("#")[0].rstrip()
        if not name.startswith(" "):
            suite = name
        elif not re.search(r"(^|\.|/)DISABLED_", suite + name.strip()):
            suites.setdefault(suite.rstrip("."), []).append(suite + name.strip())
    return suites


def suites_of(program: Program, project: Path) -> list[Suite]:
    if program.is_command:
        return [Suite(program, program.name, [program.name])]
    listing = subprocess.run([*program.command, "--gtest_list_tests"], cwd=project, capture_output=True, text=True)
    if listing.returncode != 0:
        raise SystemExit(f"{program.name} does not list its tests:\n{listing.stdout}{listing.stderr}")
    # Lines that are not part of the list, such as those of a library that warns, hold no suite's name.
    return [Suite(program, name, tests) for name, tests in parse_list(listing.stdout).items()]


def list_suites(programs: list[Program], project: Path, name: re.Pattern | None) -> list[Suite]:
    """All suites, with the tests whose name matches (None: all); suites without any are left out."""
    with ThreadPoolExecutor() as pool:
        suites = [suite for part in pool.map(lambda program: suites_of(program, project), programs) for suite in part]
    for suite in suites:
        suite.tests = [test for test in suite.tests if name is None or name.search(test)]
    return [suite for suite in suites if suite.tests]
