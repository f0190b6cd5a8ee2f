#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An equivalent mutant is known by its file and lines, and told where it is none any more."""

import sys
import unittest

sys.path.insert(0, sys.argv.pop())
from equivalents import BadEntry, is_listed, read_equivalents, stale  # noqa: E402
from mutant import Mutant  # noqa: E402

CONTENT = b"bool f(int a) {\n    return a < 2;\n}\n"
MUTANT = Mutant("f.cpp", 29, 30, "<=", "boundary")
LIST = """# What nobody can tell.
f.cpp
- return a < 2;
+ return a <= 2;
It is never 2.
"""


class Equivalents(unittest.TestCase):
    def test_what_is_shown_of_a_mutant_is_what_is_listed(self):
        self.assertEqual(MUTANT.difference(CONTENT), ("- return a < 2;", "+ return a <= 2;"))
        self.assertTrue(is_listed(MUTANT, CONTENT, read_equivalents(LIST)))
        self.assertFalse(is_listed(Mutant("f.cpp", 29, 30, ">", "boundary"), CONTENT, read_equivalents(LIST)))

    def test_an_entry_for_a_line_that_is_gone_is_stale(self):
        entries = read_equivalents(LIST)
        self.assertEqual(stale(entries, [MUTANT], {"f.cpp": CONTENT}), [])
        self.assertEqual(stale(entries, [], {"f.cpp": b""}), entries)
        self.assertEqual(stale(entries, [], {"another.cpp": b""}), [])

    def test_an_entry_without_a_reason_is_refused(self):
        with self.assertRaises(BadEntry):
            read_equivalents("f.cpp\n- a\n+ b\n")


if __name__ == "__main__":
    unittest.main()
