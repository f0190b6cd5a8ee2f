#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What cmake/repeatable makes of a step of the build."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

REPEATABLE = pathlib.Path(sys.argv.pop())
ONE_WAY = """\
    int lines = 1;
double r2_2;
bool r2_1;
QObject *r2_10;
return r2_1;
QList<QPair<int, double>> r3_0;
"""
ANOTHER_WAY = """\
    int lines = 1;
QObject *r2_10;
bool r2_1;
double r2_2;
return r2_1;
QList<QPair<int, double>> r3_0;
"""


class Repeatable(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, name: str, *lines: str) -> pathlib.Path:
        made = self.folder / name
        made.write_text("\n".join(["#!/bin/sh", *lines, ""]))
        made.chmod(0o755)
        return made

    def compiled(self, text: str) -> str:
        (self.folder / "page.qml").write_text(text)
        compiler = self.program("qmlcachegen", 'cat "$4" >"$3"')
        subprocess.run([REPEATABLE, compiler, "--bare", "-o", self.folder / "a page.cpp", self.folder / "page.qml"], check=True)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a page.cpp", "page.qml", "qmlcachegen"])
        return (self.folder / "a page.cpp").read_text()

    def test_declarations_are_sorted_and_nothing_else_is_moved(self):
        one = self.compiled(ONE_WAY)
        self.assertEqual(one, self.compiled(ANOTHER_WAY))
        self.assertEqual(sorted(one.splitlines()), sorted(ONE_WAY.splitlines()))
        for place in (0, 4, 5):
            self.assertEqual(one.splitlines()[place], ONE_WAY.splitlines()[place])

    def test_a_compiler_that_fails_fails(self):
        compiler = self.program("qmlcachegen", 'echo half >"$2"', "exit 3")
        self.assertEqual(subprocess.run([REPEATABLE, compiler, "-o", self.folder / "page.cpp"]).returncode, 3)

    def test_a_compiler_that_is_told_its_output_in_another_way_is_left_alone(self):
        compiler = self.program("qmlcachegen", 'cat "$1" >made.cpp')
        (self.folder / "page.qml").write_text(ONE_WAY)
        subprocess.run([REPEATABLE, compiler, "page.qml", "@words"], cwd=self.folder, check=True, timeout=60)
        self.assertEqual((self.folder / "made.cpp").read_text(), ONE_WAY)

    def test_other_programs_are_run_as_they_are_with_one_time_for_all_files(self):
        other = self.program("rcc", 'echo "$QT_RCC_SOURCE_DATE_OVERRIDE $1|$2"', "exit 4")
        run = subprocess.run([REPEATABLE, other, "two words", "-o"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (4, "1 two words|-o\n"))


if __name__ == "__main__":
    unittest.main()
