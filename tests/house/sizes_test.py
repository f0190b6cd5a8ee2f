#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check of sizes finds what is too large, and only that."""

import pathlib
import tempfile
import unittest

from sizes import faults


def found(files, data=()):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return list(faults(root, data))


def page(properties, begin="class Page : public QObject {"):
    return begin + "\n    Q_OBJECT\n" + "    Q_PROPERTY(int a MEMBER a)\n" * properties + "};\n"


class Sizes(unittest.TestCase):
    def test_four_hundred_lines_and_no_more(self):
        self.assertEqual(found({"core/a.cpp": "x\n" * 400, "app/b/c.qml": "x\n" * 400}), [])
        self.assertEqual(found({"core/a.cpp": "x\n" * 401}), ["core/a.cpp: has 401 lines; at most 400 have one purpose"])
        self.assertEqual(len(found({"app/b/c.qml": "x\n" * 401, "faces/d.hpp": "x\n" * 401, "tests/e.cpp": "x\n" * 401})), 2)

    def test_a_session_and_its_header_have_250_together(self):
        header, source = "app/pages/a/a_session.hpp", "app/pages/a/a_session.cpp"
        self.assertEqual(found({header: "x\n" * 100, source: "x\n" * 150, "app/pages/b/b_session.hpp": "x\n" * 250}), [])
        self.assertEqual(found({header: "x\n" * 101, source: "x\n" * 150}),
                         ["app/pages/a/a_session: has 251 lines with its header; at most 250 are a small root of named parts"])
        self.assertEqual(found({"app/pages/a/a_session_words.cpp": "x\n" * 251, "core/a/a_session.cpp": "x\n" * 251}), [])

    def test_data_may_be_longer_and_is_listed_only_then(self):
        self.assertEqual(found({"core/a.cpp": "x\n" * 401}, ["core/a.cpp"]), [])
        self.assertEqual(found({"core/a.cpp": "x\n"}, ["core/a.cpp"]), ["core/a.cpp: is in the list of long files without need"])
        self.assertEqual(found({}, ["core/a.cpp"]), ["core/a.cpp: is in the list of long files without need"])

    def test_fifteen_properties_of_one_class_and_no_more(self):
        self.assertEqual(found({"app/a.hpp": page(15)}), [])
        self.assertEqual(found({"app/a.hpp": page(16)}),
                         ["app/a.hpp: Page has 16 properties; at most 15 have one reason to change"])

    def test_each_class_counts_by_itself(self):
        self.assertEqual(found({"app/a.hpp": page(15) + page(15, "class Other final : public QObject {")}), [])
        self.assertEqual(len(found({"app/a.hpp": "class Forward;\n" + page(16, "class Other\n    : public QObject {")})), 1)


if __name__ == "__main__":
    unittest.main()
