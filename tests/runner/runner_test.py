#!/usr/bin/env python3
"""Tests scripts/testing with a program whose tests crash, hang and fail as their names say."""

import contextlib
import io
import sys
import tempfile
import textwrap
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "scripts"))
from testing import quick  # noqa: E402
from testing.report import Report  # noqa: E402
from testing.run import run_suites  # noqa: E402
from testing.suites import Program, list_suites, parse_list  # noqa: E402

FAKE = """\
    import os, signal, subprocess, sys, time
    if "--gtest_list_tests" in sys.argv:
        print("a library warns\\nFirst.\\n  Passes\\n  Crashes\\n  Fails\\nSecond/0.  # TypeParam = int\\n  Hangs\\n  Passes\\n"
              "  DISABLED_Never\\n  Skips  # GetParam() = 3")
        sys.exit(0)
    for line in sys.stdin:
        name = line.strip().split(".")[1]
        print("output of", name, flush=True)
        if name == "Crashes": os.kill(os.getpid(), signal.SIGSEGV)
        if name == "Hangs":
            subprocess.Popen(["sleep", "1000"])
            time.sleep(1000)
        if name == "Skips": print("file:3: Skipped\\nfor a reason")
        print("\\n\\x1e" + {"Fails": "failed", "Skips": "skipped"}.get(name, "passed"), flush=True)
    sys.exit(EXIT_CODE)
"""


class Runner(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def program(self, name="fake_test", exit_code=0):
        path = Path(self.folder.name) / f"{name} with a space.py"
        path.write_text(textwrap.dedent(FAKE).replace("EXIT_CODE", str(exit_code)))
        return Program(name, "unit", (sys.executable, str(path)), (name,), False)

    def run_all(self, programs, jobs=2):
        suites = list_suites(programs, PROJECT, None)
        report = Report(suites, False)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            run_suites(suites, PROJECT, {}, report, jobs, 2)
            well = report.print_end(1, 2)
        return {result.name: result.outcome.status for result in report.results}, well, said.getvalue()

    def test_a_list_has_no_warnings_and_no_disabled_tests(self):
        self.assertEqual(parse_list("warning: x\nA.\n  One\n  DISABLED_Two\nP/B.\n  Three/4  # GetParam() = (1, 2)\n    #0 0x1\n"),
                         {"A": ["A.One"], "P/B": ["P/B.Three/4"]})

    def test_crashes_and_hangs_hide_no_other_test(self):
        statuses, well, said = self.run_all([self.program()])
        self.assertFalse(well)
        self.assertEqual(statuses, {"fake_test.First.Passes": "passed", "fake_test.First.Crashes": "crashed (signal 11)",
                                    "fake_test.First.Fails": "failed", "fake_test.Second/0.Hangs": "timed out",
                                    "fake_test.Second/0.Passes": "passed", "fake_test.Second/0.Skips": "skipped"})
        self.assertIn("output of Crashes", said)
        self.assertIn("--gtest_filter=First.Fails", said)
        self.assertIn("fake_test.Second/0.Skips: for a reason", said)
        self.assertTrue(said.endswith("2 passed, 3 failed, 1 skipped\n"), said)

    def test_a_program_that_ends_badly_fails(self):
        suites = list_suites([self.program(exit_code=3)], PROJECT, None)
        suites = [suite for suite in suites if suite.name == "First"]
        suites[0].tests = ["First.Passes"]
        report = Report(suites, False)
        with contextlib.redirect_stdout(io.StringIO()):
            run_suites(suites, PROJECT, {}, report, 1, 10)
            self.assertFalse(report.print_end(0, 0))
        self.assertEqual(report.failed(), ["the end of fake_test"])

    def test_a_program_that_cannot_be_listed_or_started_is_one_failure(self):
        missing = Program("missing", "unit", ("/nowhere/missing",), (), True)
        broken = Program("broken", "unit", ("false",), (), False)
        statuses, well, _ = self.run_all([missing, broken])
        self.assertFalse(well)
        self.assertEqual(set(statuses), {"missing", "broken.lists its tests"})

    def test_commands_are_tests(self):
        def command(name, text):
            return Program(name, "lint", ("bash", "-c", text), (), True)
        statuses, _, said = self.run_all([command("good", "true"), command("bad", "echo why; exit 7"),
                                          command("slow", "sleep 1000")])
        self.assertEqual(statuses, {"good": "passed", "bad": "failed (exit code 7)", "slow": "timed out"})
        self.assertIn("why", said)

    def test_quick_chooses_by_source_word_and_kernel_and_keeps_the_time(self):
        suites = list_suites([self.program()], PROJECT, None)
        change = quick.Change("ui/shadow_panel.cpp", frozenset({"core/kernels/Passes.cpp.o"}))
        relevance = quick.Relevance([change], {}, PROJECT)
        relevance.source_of_suite = {"First": "tests/gl/shadow_test.cpp"}
        chosen, left_out = quick.choose(suites, relevance, {"fake_test.Second/0.Hangs"}, {"fake_test.First.Crashes": 99}, 10, 2)
        names = {test for suite in chosen for test in suite.tests}
        self.assertEqual(names, {"First.Passes", "First.Fails", "Second/0.Hangs"})
        self.assertEqual(left_out, 1)

    def test_changed_files_are_those_written_since(self):
        self.assertIn("README.md", quick.changed_files(PROJECT, 0))
        self.assertEqual(quick.changed_files(PROJECT, time.time() + 60), quick.git_files(PROJECT, "--deleted"))


if __name__ == "__main__":
    unittest.main()
