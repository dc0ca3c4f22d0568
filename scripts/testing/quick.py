"""Chooses the tests of `./test --quick`: the tests that failed last time, and as many tests of the changed files as fit into
the time.

A test concerns a changed file if its source is that file, is compiled with it, or shares a word with its name; if the kernel
of its technique is compiled from it; or if it has the label of the file's folder."""

import re
import subprocess
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from testing.schedule import SECONDS_OF_AN_UNKNOWN_TEST
from testing.suites import Program, Suite

ALL_LABELS = ("unit", "property", "golden", "gui", "bench", "lint", "web")
LABELS_OF_FOLDERS = (("shaders/shared/", ("property", "golden", "lint")), ("shaders/", ("golden", "lint")),
                     ("core/render/", ("golden",)), ("core/gl/", ("golden",)), ("core/", ("unit",)), ("ui/", ("gui",)),
                     ("app/", ("unit", "gui")), ("docs/", ("unit", "gui")), ("scripts/", ("lint",)), ("tests/", ("lint",)))
# Words in file names that do not tell what a file is about.
COMMON_WORDS = frozenset("test cpp explorer panel core ui app moments".split())


def git_files(project: Path, *options: str) -> list[str]:
    listing = subprocess.run(["git", "ls-files", "-z", *options], cwd=project, capture_output=True, text=True)
    if listing.returncode != 0:
        raise SystemExit(f"--quick asks git what changed, and git says: {listing.stderr.strip()}")
    return [path for path in listing.stdout.split("\0") if path]


def changed_files(project: Path, since: float) -> list[str]:
    """Files of the project that were written, renamed or deleted since then, except files that git ignores."""
    changed = git_files(project, "--deleted")
    for path in git_files(project, "--cached", "--others", "--exclude-standard"):
        file = project / path
        if file.is_file() and max(file.stat().st_mtime, file.stat().st_ctime) > since:
            changed.append(path)
    return changed


def read_dependencies(build: Path, project: Path) -> dict[str, set[str]]:
    """The object files that were compiled from each file of the project, according to ninja's records."""
    users: dict[str, set[str]] = {}
    log = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True).stdout
    of = ""
    for line in log.splitlines():
        if line and not line.startswith(" "):
            of = line.split(":")[0]
        elif line.strip().startswith(f"{project}/"):
            users.setdefault(line.strip().removeprefix(f"{project}/"), set()).add(of)
    return users


def words_of(path: str) -> frozenset[str]:
    return frozenset(re.split(r"[_\W]+", Path(path).stem)) - COMMON_WORDS


def share_a_word(a: str, b: str) -> bool:
    """Also "peel" and "peeling"."""
    return any(one == other or (min(len(one), len(other)) >= 4 and (one.startswith(other) or other.startswith(one)))
               for one in words_of(a) for other in words_of(b))


@dataclass(frozen=True)
class Change:
    """One changed file, and the object files that were compiled from it or from the header beside it."""
    path: str
    objects: frozenset[str]

    @property
    def labels(self) -> tuple[str, ...]:
        """The labels of the tests that depend on such a change, whatever they include."""
        if self.path.endswith(".md") and "/" not in self.path:
            return ("unit",)
        return next((labels for folder, labels in LABELS_OF_FOLDERS if self.path.startswith(folder)), ALL_LABELS)

    @property
    def test_objects(self) -> frozenset[str]:
        return frozenset(name for name in self.objects if name.startswith("tests/"))

    @property
    def kernels(self) -> frozenset[str]:
        """Techniques whose kernels were compiled from it, with names as in tests: power4_32."""
        return frozenset(Path(name).name.removesuffix(".cpp.o") for name in self.objects if "/kernels/" in name)


def changes_of(paths: list[str], users: dict[str, set[str]]) -> list[Change]:
    def objects(path: str) -> frozenset[str]:
        header = re.sub(r"\.(cpp|inl)$", ".hpp", path)
        return frozenset(users.get(path, set()) | users.get(header, set()))
    return [Change(path, objects(path)) for path in paths]


def programs_to_build(changes: list[Change], programs: list[Program]) -> list[Program]:
    """Programs with tests that may concern the changes."""
    labels = {label for change in changes for label in change.labels}
    compiled = {name.split("/")[2].removesuffix(".dir") for change in changes for name in change.test_objects}
    return [program for program in programs if program.label in labels or program.name in compiled]


class Relevance:
    """Scores how much tests concern the changes."""

    def __init__(self, changes: list[Change], users: dict[str, set[str]], project: Path):
        self.changes = changes
        self.users = users
        self.source_of_suite = {}  # "ShadowTest": tests/gl/shadow_test.cpp
        for source in project.glob("tests/*/*.cpp"):
            for suite in re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),", source.read_text(), re.MULTILINE):
                self.source_of_suite[suite] = str(source.relative_to(project))

    def of(self, suite: Suite, test: str) -> float:
        return max((self.of_change(suite, test, change) for change in self.changes), default=0)

    def of_change(self, suite: Suite, test: str, change: Change) -> float:
        score = 1.0 if suite.program.label in change.labels else 0.0
        if suite.program.is_command:
            return score
        source = next((self.source_of_suite[part] for part in suite.name.split("/") if part in self.source_of_suite), "")
        parameter = test.split("/")[-1]
        score += 16 if source == change.path else 0
        score += 8 if share_a_word(source, change.path) else 0
        score += 2 if any(f"{parameter}_".startswith(f"{kernel}_") for kernel in change.kernels) else 0
        if self.users.get(source, set()) & change.test_objects:
            score += 1 + 4 / len(change.test_objects)  # a file that every test includes scores less
        return score


def choose(suites: list[Suite], relevance: Relevance, failed: set[str], seconds: dict[str, float], wall: float,
           jobs: int) -> tuple[list[Suite], int]:
    """The most relevant tests that `jobs` workers can run in `wall` seconds, and how many tests were left out. Parametrised
    tests take turns, one technique at a time, so that many kinds of tests are included."""
    rank: Counter[str] = Counter()
    candidates = []
    for suite in suites:
        for test in suite.tests:
            name = suite.full_name(test)
            score = 1000 if name in failed else relevance.of(suite, test)
            if score > 0:
                kind = f"{suite.program.name}.{test.rsplit('/', 1)[0]}" if "/" in suite.name else name
                rank[kind] += 1
                candidates.append((-score / rank[kind], seconds.get(name, SECONDS_OF_AN_UNKNOWN_TEST), suite, test))
    budget = jobs * wall
    chosen: dict[int, Suite] = {}
    for _, needed, suite, test in sorted(candidates, key=lambda candidate: candidate[:2]):
        if needed <= min(budget, wall):
            budget -= needed
            chosen.setdefault(id(suite), Suite(suite.program, suite.name)).tests.append(test)
    suites = list(chosen.values())
    return suites, len(candidates) - sum(len(suite.tests) for suite in suites)
