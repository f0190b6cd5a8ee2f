#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What packaging/styling says of a tiny house: of changed lines alone, and what it did not look at."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

STYLING = pathlib.Path(sys.argv.pop())
sys.path[:0] = [str(STYLING), str(STYLING.parent / "mutation")]

from layout import badly_laid_out, ranges  # noqa: E402
from style import changed_sources  # noqa: E402
from tidiness import look_through, sources_to_ask  # noqa: E402

WELL = "double half(int number);\n\nint sum(int a, int b) {\n    return a + b;\n}\n"
HALF = "double half(int number) {\n    return number / 2;\n}\ndouble third(int number) {\n    return number / 3;\n}\n"


class OneRoom:
    """Knows how the files of one room are compiled: two sources, a header, and nothing for Windows."""

    def is_compiled(self, source):
        return source in ("core/a.cpp", "core/b.cpp")

    def parse_flags(self, file):
        if file == "core/a_windows.cpp":
            raise KeyError(file)
        return ["-std=c++20"]


class Style(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        self.write(".clang-format", "BasedOnStyle: LLVM\nIndentWidth: 4\nAllowShortFunctionsOnASingleLine: None\n")
        self.write(".clang-tidy", "Checks: '-*,bugprone-integer-division'\nHeaderFilterRegex: '.*'\n")

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")
        return name

    def test_lines_that_follow_each_other_are_a_range(self):
        self.assertEqual(ranges({7, 2, 3, 4}), [(2, 4), (7, 7)])
        self.assertEqual(ranges(set()), [])

    def test_a_changed_line_is_laid_out_well(self):
        name = self.write("core/a.cpp", WELL)
        self.assertEqual(list(badly_laid_out(self.root, name, {1, 3, 4, 5})), [])

    def test_another_layout_of_a_changed_line_is_shown(self):
        name = self.write("core/a.cpp", WELL.replace("a + b", "a+b"))
        said = list(badly_laid_out(self.root, name, {4}))
        self.assertEqual(len(said), 1)
        self.assertTrue(said[0].startswith("core/a.cpp:4: "), said)
        self.assertIn("        return a + b;", said[0])

    def test_what_was_there_before_is_left_alone(self):
        name = self.write("core/a.cpp", WELL.replace("a + b", "a+b"))
        self.assertEqual(list(badly_laid_out(self.root, name, {1})), [])

    def test_a_mistake_in_a_changed_line_is_told_and_no_other(self):
        name = self.write("core/half.cpp", HALF)
        found, left_out = look_through(self.root, [(name, ["-std=c++20"])], {name: {2}}, 60)
        self.assertEqual(left_out, [])
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith("core/half.cpp:2: "), found)
        self.assertIn("bugprone-integer-division", found[0])

    def test_a_mistake_in_a_header_is_told_once(self):
        self.write("core/half.hpp", "inline double half(int number) { return number / 2; }\n")
        sources = [(self.write(name, '#include "half.hpp"\n'), ["-std=c++20"]) for name in ("core/a.cpp", "core/b.cpp")]
        found, _ = look_through(self.root, sources, {"core/half.hpp": {1}}, 60)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith("core/half.hpp:1: "), found)

    def test_what_there_was_no_time_for_is_named(self):
        name = self.write("core/half.cpp", HALF)
        self.assertEqual(look_through(self.root, [(name, [])], {name: {2}}, 0), ([], [name]))

    def test_a_source_that_cannot_be_compiled_is_told(self):
        name = self.write("core/half.cpp", "double half(int number) { return nothing; }\n")
        found, _ = look_through(self.root, [(name, [])], {name: {1}}, 60)
        self.assertEqual(len(found), 1, found)

    def test_most_changes_come_first_and_a_header_comes_with_its_source_or_alone(self):
        changes = {"core/a.cpp": {1}, "core/b.hpp": {1, 2, 3}, "core/alone.hpp": {1, 2}, "core/a_windows.cpp": {1},
                   "core/b_windows.hpp": {1},
                   "tests/core/a_test.cpp": {1, 2, 3}}
        sources, unseen = sources_to_ask(OneRoom(), changes)
        self.assertEqual([name for name, _ in sources], ["core/b.cpp", "core/alone.hpp", "core/a.cpp"])
        self.assertEqual(sources[0][1], ["-std=c++20", "-fPIC", "-xc++"])
        self.assertEqual(unseen, ["core/a_windows.cpp", "core/b_windows.hpp"])

    def test_sources_that_changed_and_are_there(self):
        def git(*words):
            subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True,
                           capture_output=True)
        for name in ("core/a.cpp", "core/gone.cpp", "core/data.inc", "core/same.hpp"):
            self.write(name, "int a;\n")
        git("init", "-q")
        git("add", ".")
        git("commit", "-qm", "a")
        (self.root / "core/gone.cpp").unlink()
        self.write("core/a.cpp", "int a;\nint b;\n")
        self.write("core/data.inc", "int  b;\n")
        self.assertEqual(changed_sources(self.root, "HEAD"), {"core/a.cpp": {2}})


if __name__ == "__main__":
    unittest.main()
