#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is known of a mutant holds as long as its file, and where it survived the tests, are the same."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop())
from mutant import Mutant  # noqa: E402
from record import NOTICED, SURVIVED, Record  # noqa: E402

CONTENT = b"bool f(int a) { return a < 2; }\n"
MUTANT = Mutant("f.cpp", 25, 26, "<=", "boundary")


class Records(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "room.jsonl"

    def result(self, tests, content=CONTENT):
        entry = Record(self.path, tests).known(MUTANT, content)
        return entry and entry["result"]

    def test_a_later_run_knows_it(self):
        self.assertIsNone(self.result("old"))
        Record(self.path, "old").add(MUTANT, CONTENT, SURVIVED, "", 1.0)
        self.assertEqual(self.result("old"), SURVIVED)

    def test_what_survived_is_judged_again_by_other_tests_and_what_was_noticed_is_not(self):
        Record(self.path, "old").add(MUTANT, CONTENT, SURVIVED, "", 1.0)
        self.assertIsNone(self.result("new"))
        Record(self.path, "new").add(MUTANT, CONTENT, NOTICED, "a test", 1.0)
        self.assertEqual(self.result("newer"), NOTICED)

    def test_another_file_is_another_mutant(self):
        Record(self.path, "old").add(MUTANT, CONTENT, NOTICED, "", 1.0)
        self.assertIsNone(self.result("old", CONTENT + b"\n"))

    def test_a_line_that_was_cut_off_is_passed_over(self):
        Record(self.path, "old").add(MUTANT, CONTENT, NOTICED, "", 1.0)
        with self.path.open("a", encoding="utf-8") as file:
            file.write('{"key": "abc')
        self.assertEqual(self.result("old"), NOTICED)


if __name__ == "__main__":
    unittest.main()
