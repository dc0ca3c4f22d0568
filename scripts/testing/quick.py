"""What `./test --quick` runs: of the tests that concern what changed, as many as fit into the time.

A test concerns a changed file if its source is that file, includes it (or the header beside it), has a word of its
name, or is of a technique whose kernel is compiled from it."""

import re
import subprocess
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from testing.suites import Program, Suite

# Which tests see a change of these folders, whatever they include.
LABELS_OF_FOLDERS = (("shaders/shared/", ("property", "golden")), ("shaders/", ("golden",)), ("core/render/", ("golden",)),
                     ("core/gl/", ("golden",)), ("core/", ("unit",)), ("ui/", ("gui",)), ("app/", ("gui",)),
                     ("scripts/", ("lint",)), ("tests/", ("lint",)))
# Words of file names that say nothing of what a file is about.
COMMON_WORDS = frozenset("test cpp explorer panel core ui app moments".split())


def changed_files(project: Path, since: float) -> list[str]:
    """Files of the project that were written since then, without those that git ignores."""
    listing = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=project, capture_output=True, text=True)
    paths = listing.stdout.splitlines()
    return [path for path in paths if (project / path).is_file() and (project / path).stat().st_mtime > since]


def words_of(path: str) -> frozenset[str]:
    return frozenset(re.split(r"[_\W]+", Path(path).stem)) - COMMON_WORDS


def read_dependencies(build: Path, project: Path) -> dict[str, set[str]]:
    """The objects that were compiled from each file of the project, as ninja recorded them."""
    users: dict[str, set[str]] = {}
    log = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True).stdout
    of = ""
    for line in log.splitlines():
        if line and not line.startswith(" "):
            of = line.split(":")[0]
        elif line.strip().startswith(str(project)):
            users.setdefault(str(Path(line.strip()).relative_to(project)), set()).add(of)
    return users


@dataclass(frozen=True)
class Change:
    """One changed file, and what was compiled from it."""
    path: str
    objects: frozenset[str]

    def labels(self) -> tuple[str, ...]:
        return next((labels for folder, labels in LABELS_OF_FOLDERS if self.path.startswith(folder)), ())

    def kernels(self) -> frozenset[str]:
        """Techniques whose kernel was, named as in tests: power4_32."""
        return frozenset(Path(name).name.removesuffix(".cpp.o") for name in self.objects if "/kernels/" in name)


def changes_of(paths: list[str], users: dict[str, set[str]]) -> list[Change]:
    def objects(path: str) -> frozenset[str]:
        header = re.sub(r"\.(cpp|inl)$", ".hpp", path)
        return frozenset(users.get(path, set()) | users.get(header, set()))
    return [Change(path, objects(path)) for path in paths]


class Relevance:
    """How much tests concern the changes."""

    def __init__(self, changes: list[Change], project: Path):
        self.changes = changes
        self.source_of_suite = {}  # "ShadowTest": tests/gl/shadow_test.cpp
        for source in project.glob("tests/*/*.cpp"):
            for suite in re.findall(r"^TEST(?:_[FP])?\((\w+),", source.read_text(), re.MULTILINE):
                self.source_of_suite[suite] = str(source.relative_to(project))

    def of_source(self, source: str, change: Change) -> float:
        score = 16 if source == change.path else 0
        score += 8 if words_of(source) & words_of(change.path) else 0
        tests = [name for name in change.objects if name.startswith("tests/")]
        includes = any(name.endswith(source.removeprefix("tests/") + ".o") for name in tests)
        return score + (1 + 4 / len(tests) if includes else 0)  # less where every test includes it

    def of(self, suite: Suite, test: str) -> float:
        return max((self.of_change(suite, test, change) for change in self.changes), default=0)

    def of_change(self, suite: Suite, test: str, change: Change) -> float:
        score = 1 if suite.program.label in change.labels() else 0
        if suite.program.is_command:
            return score
        source = self.source_of_suite.get(suite.name.split("/")[-1], "")
        parameter = test.split("/")[-1]
        return score + self.of_source(source, change) + (2 if parameter in change.kernels() else 0)


def programs_to_build(changes: list[Change], programs: list[Program]) -> list[Program]:
    """Programs in which a test may concern the changes."""
    labels = {label for change in changes for label in change.labels()}
    folders = {name.split("/")[2].removesuffix(".dir") for change in changes for name in change.objects
               if name.startswith("tests/")}
    return [program for program in programs if program.label in labels or program.name in folders]


def choose(suites: list[Suite], relevance: Relevance, seconds: dict[str, float], budget: float) -> list[Suite]:
    """The most relevant tests within a budget of seconds; of a parametrised test one technique first, then the
    next, so that many kinds of tests are among them."""
    rank: Counter[str] = Counter()
    candidates = []
    for suite in suites:
        for test in suite.tests:
            score = relevance.of(suite, test)
            if score > 0:
                kind = test.rsplit("/", 1)[0] if "/" in suite.name else test
                rank[kind] += 1
                candidates.append((-score / rank[kind], seconds.get(test, 1.0), suite, test))
    chosen: dict[int, Suite] = {}
    for _, needed, suite, test in sorted(candidates, key=lambda candidate: candidate[:2]):
        if needed <= budget:
            budget -= needed
            chosen.setdefault(id(suite), Suite(suite.program, suite.name)).tests.append(test)
    return list(chosen.values())
