# SPDX-License-Identifier: Apache-2.0
"""packaging/testing/summary.py, held against reports that CTest itself writes.

summary_test.py SUMMARY    the script
"""

from __future__ import annotations

import pathlib
import subprocess
import sys
import tempfile
import unittest

SUMMARY = pathlib.Path(sys.argv.pop()).resolve()

TESTS = r"""
add_test(good.one "/bin/true")
add_test(good.partly "/bin/printf" "SKIP   : Pages::turned() no sound server\nrest passed\n")
add_test(bad.exit "/bin/false")
add_test(bad.slow "/bin/sleep" "30")
set_tests_properties(bad.slow PROPERTIES TIMEOUT 1)
add_test(bad.missing "/nowhere/program")
add_test(left.out "/bin/sh" "-c" "echo first; echo 'SKIP: no virtual machine: there is no qemu'; exit 77")
set_tests_properties(left.out PROPERTIES SKIP_RETURN_CODE 77)
add_test(left.shared "/bin/sh" "-c" "printf 'SKIP   : Faces::wild() needs ../shared: its photographs\n'; exit 77")
set_tests_properties(left.shared PROPERTIES SKIP_RETURN_CODE 77)
"""


class Summary(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = pathlib.Path(folder.name)
        self.results = self.build / "results"
        self.results.mkdir()

    def run_ctest(self, preset: str, tests: str) -> str:
        (self.build / "CTestTestfile.cmake").write_text(tests, encoding="utf-8")
        ran = subprocess.run(["ctest", "--output-junit", self.results / f"{preset}.xml", "--test-output-size-passed", "200000"],
                             cwd=self.build, capture_output=True, text=True, check=False)
        (self.results / f"{preset}.log").write_text(ran.stdout, encoding="utf-8")
        return next(line for line in ran.stdout.splitlines() if "tests passed" in line)

    def summary(self, status: int, *stages: str) -> list[str]:
        ran = subprocess.run([sys.executable, SUMMARY, self.results, str(status), *stages], capture_output=True, text=True, check=True)
        return ran.stdout.splitlines()

    def began(self, *stages: str) -> None:
        (self.results / "stages").write_text("".join(f"{1000 + 60 * n} {name}\n" for n, name in enumerate(stages)), encoding="utf-8")

    def test_each_test_has_its_verdict_its_command_or_its_reason(self) -> None:
        said_by_ctest = self.run_ctest("release", TESTS)
        self.began("release build", "release tests")
        lines = self.summary(8, "release build", "release tests", "style")
        self.assertIn("release build: passed in 60 s", lines)
        self.assertTrue(any(line.startswith("release tests: FAILED in ") for line in lines), lines)
        self.assertIn("  2 passed, 3 failed, 2 skipped of 7 tests", lines)
        self.assertIn(r"  failed: bad.exit: ctest --preset release -R '^bad\.exit$'", lines)
        self.assertIn(r"  failed: bad.slow: ctest --preset release -R '^bad\.slow$'", lines)
        self.assertIn(r"  not run: bad.missing: ctest --preset release -R '^bad\.missing$'", lines)
        self.assertIn("  skipped: left.out: SKIP: no virtual machine: there is no qemu", lines)
        self.assertIn("  skipped: left.shared: needs ../shared: its photographs", lines)
        self.assertIn("  partly skipped: good.partly: no sound server", lines)
        self.assertFalse(any("good.one" in line for line in lines), lines)
        self.assertIn("style: not reached", lines)
        self.assertEqual(lines[-1], said_by_ctest)

    def test_a_run_without_a_fault_passes(self) -> None:
        said_by_ctest = self.run_ctest("tsan", 'add_test(good.one "/bin/true")\n')
        self.began("release build", "tsan tests")
        lines = self.summary(0, "release build", "tsan tests")
        self.assertIn("  1 passed, 0 failed, 0 skipped of 1 tests", lines)
        self.assertFalse(any("FAILED" in line for line in lines), lines)
        self.assertEqual(lines[-1], said_by_ctest)

    def test_a_stage_that_cannot_run_here_has_its_reason(self) -> None:
        self.run_ctest("release", 'add_test(good.one "/bin/true")\n')
        self.began("release tests")
        (self.results / "left_out").write_text("tsan tests\t/proc is not mounted here\n", encoding="utf-8")
        lines = self.summary(0, "release tests", "tsan tests")
        self.assertIn("tsan tests: skipped: /proc is not mounted here", lines)
        self.assertFalse(any("not reached" in line for line in lines), lines)

    def test_a_run_that_ends_before_its_tests(self) -> None:
        self.began("packages")
        lines = self.summary(130, "packages", "release build")
        self.assertTrue(any(line.startswith("packages: FAILED") for line in lines), lines)
        self.assertEqual(lines[-2], "release build: not reached")
        self.assertTrue(lines[-1].startswith("All: FAILED"), lines)


if __name__ == "__main__":
    unittest.main()
