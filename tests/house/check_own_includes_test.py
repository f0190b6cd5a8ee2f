#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check of forgotten includes finds them, and only them."""

import pathlib
import tempfile
import unittest

from check_own_includes import House


def forgotten(**files):
    """What the check says of app/one.cpp in a house of these files, named with __ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "app").mkdir()
        for name, text in files.items():
            (root / "app" / name.replace("__", ".")).write_text(text, encoding="utf-8")
        return House(root).forgotten("app/one.cpp")


class CheckOwnIncludes(unittest.TestCase):
    def test_a_class_of_qt_that_another_header_brings_along_is_forgotten(self):
        self.assertEqual(forgotten(one__cpp="#include <QDir>\nQFileInfo f;"), {"<QFileInfo>": "QFileInfo"})

    def test_a_name_of_the_standard_library_is_forgotten(self):
        self.assertEqual(forgotten(one__cpp="#include <vector>\nstd::vector<std::string> s;"), {"<string>": "std::string"})

    def test_what_our_own_headers_include_is_reached(self):
        self.assertEqual(forgotten(one__cpp='#include "app/one.hpp"\nQFile f; std::set<int> s;',
                                   one__hpp='#include "app/two.hpp"\n#include <QFile>', two__hpp="#include <set>"), {})

    def test_a_ring_of_includes_ends(self):
        self.assertEqual(forgotten(one__cpp='#include "app/one.hpp"\nQFile f;', one__hpp='#include "app/two.hpp"',
                                   two__hpp='#include "app/one.hpp"'), {"<QFile>": "QFile"})

    def test_what_is_declared_forward_or_only_spoken_of_is_not_used(self):
        self.assertEqual(forgotten(one__cpp='class QUrl;\nQUrl* u; // a QFile\n/* std::map */ auto t = "QDir";'), {})

    def test_the_basic_types_come_with_every_header_of_qt(self):
        self.assertEqual(forgotten(one__cpp="#include <QTimer>\nQString s; QByteArray b; QObject* o;"), {})
        self.assertEqual(forgotten(one__cpp="QString s;"), {"<QString>": "QString"})


if __name__ == "__main__":
    unittest.main()
