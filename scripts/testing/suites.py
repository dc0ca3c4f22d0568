"""The tests of a build: GoogleTest programs, which can list their tests, and commands."""

import json
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Program:
    """A test program, or a command that counts as one test."""
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

    def full_name(self, test: str) -> str:
        """Includes the program, because two programs may have tests with the same name."""
        return test if self.program.is_command else f"{self.program.name}.{test}"


def read_programs(build: Path) -> list[Program]:
    """Reads the list that CMake writes (tests/CMakeLists.txt)."""
    return [Program(row["name"], row["label"], tuple(row["command"]), tuple(row["targets"]), row["is_command"])
            for row in json.loads((build / "tests.json").read_text())]


def parse_list(text: str) -> dict[str, list[str]]:
    """The tests of each suite, from the output of --gtest_list_tests. Other lines, such as warnings of a library, are
    skipped."""
    suites: dict[str, list[str]] = {}
    suite = ""
    for line in text.splitlines():
        if match := re.match(r"([\w/]+\.)(\s+# .*)?$", line):
            suite = match[1]
        elif (match := re.match(r"  ([\w/]+)(\s+# .*)?$", line)) and suite:
            if not re.search(r"(^|[./])DISABLED_", suite + match[1]):
                suites.setdefault(suite.removesuffix("."), []).append(suite + match[1])
    return suites


def suites_of(program: Program, project: Path) -> list[Suite]:
    """A program that cannot list its tests counts as one test, which fails when it is run."""
    if program.is_command:
        return [Suite(program, program.name, [program.name])]
    listing = subprocess.run([*program.command, "--gtest_list_tests"], cwd=project, capture_output=True, text=True)
    suites = [Suite(program, name, tests) for name, tests in parse_list(listing.stdout).items()]
    return suites if listing.returncode == 0 and suites else [Suite(program, program.name, ["lists its tests"])]


def list_suites(programs: list[Program], project: Path, name: re.Pattern | None) -> list[Suite]:
    """All suites with the tests whose full names match (None: all tests). Suites without such tests are left out."""
    with ThreadPoolExecutor() as pool:
        suites = [suite for part in pool.map(lambda program: suites_of(program, project), programs) for suite in part]
    for suite in suites:
        suite.tests = [test for test in suite.tests if name is None or name.search(suite.full_name(test))]
    return [suite for suite in suites if suite.tests]
