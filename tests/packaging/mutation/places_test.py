#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each operator finds the places that it should, and makes of them what it should."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop())
from places import mutants_of  # noqa: E402


def mutated(source, operator):
    """The source with each of the operator's mutants in it."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "tiny.cpp"
        path.write_text(source, encoding="utf-8")
        content = source.encode()
        return sorted(mutant.applied(content).decode() for mutant in mutants_of(str(path), "tiny.cpp", content, ["-std=c++20"])
                      if mutant.operator == operator)


class Places(unittest.TestCase):
    def makes(self, operator, before, *after, around="{}"):
        self.assertEqual(mutated(around.format(before), operator), sorted(around.format(text) for text in after))

    def in_function(self, operator, before, *after):
        self.makes(operator, before, *after, around="int g(); void f(int a, int b, bool c, double d) {{ {} }}")

    def test_a_boundary_is_moved_by_its_equality(self):
        self.in_function("boundary", "c = a < b;", "c = a <= b;")
        self.in_function("boundary", "c = d >= /* > */ 2.0;", "c = d > /* > */ 2.0;")
        self.in_function("boundary", "c = a == b;", "c = a != b;")

    def test_within_what_libclang_has_no_name_for(self):
        self.in_function("arithmetic", "d = __builtin_bit_cast(double, 1L + a);", "d = __builtin_bit_cast(double, 1L - a);")

    def test_signs_of_arithmetic(self):
        self.in_function("arithmetic", "a = (a + b) * a;", "a = (a - b) * a;", "a = (a + b) / a;")
        self.in_function("arithmetic", "a %= b; a <<= b;", "a %= b; a >>= b;")
        self.in_function("arithmetic", "a = -b;", "a = +b;")
        self.in_function("arithmetic", "a = a & ~b;", "a = a | ~b;")

    def test_signs_of_vectors_but_not_of_texts(self):
        vectors = "struct V {{ V& operator+=(V); }}; V operator*(double, V); void f(V v, double d) {{ {} }}"
        self.makes("arithmetic", "v += d * v;", "v -= d * v;", "v += d / v;", around=vectors)
        texts = "struct QString {{}}; QString operator+(QString, QString); QString f(QString t) {{ return {}; }}"
        self.makes("arithmetic", "t + t", around=texts)

    def test_constants_are_doubled_and_halved(self):
        self.makes("constant", "0.25", "(0.25 * 2)", "(0.25 / 2)", around="struct S {{ double limit = {}; }};")
        self.makes("constant", "0x10u", "(0x10u * 2)", "(0x10u / 2)", around="unsigned a = {};")
        self.makes("constant", "0", "(0 + 1)", around="int a = {};")
        self.makes("constant", "true", "false", around="bool a = {};")
        self.makes("constant", "static_assert(1 < 2);")

    def test_conditions_are_negated(self):
        self.in_function("condition", "if (a < b) g();", "if (!(a < b)) g();")
        self.in_function("condition", "if (!c) g();", "if (c) g();")
        self.in_function("condition", "a = c ? a : b;", "a = !(c) ? a : b;")
        self.in_function("condition", "c = c && a;", "c = c || a;")
        self.in_function("condition", "if (int i = g(); i) g();", "if (int i = g(); !(i)) g();")
        self.in_function("condition", "if (int i = g()) g();")

    def test_statements_are_removed(self):
        self.in_function("statement", "g(); int i = 0; a = i;", "; int i = 0; a = i;", "g(); int i = 0; ;")
        self.in_function("statement", "for (;;) { if (c) break; else g(); }", "for (;;) { if (c) ; else g(); }",
                         "for (;;) { if (c) break; else ; }")
        self.in_function("statement", "if (c) return; static_cast<void>(a);", "if (c) ; static_cast<void>(a);")
        self.makes("statement", "if (c) return 1; return 2;", "if (c) ; return 2;", around="int f(bool c) {{ {} }}")

    def test_what_is_returned_is_another(self):
        self.makes("return", "c && d", "!(c && d)", around="bool f(bool c, bool d) {{ return {}; }}")
        self.makes("return", "a + 1.0", "0.0", around="double f(double a) {{ return {}; }}")
        self.makes("return", "a", "nullptr", around="int* f(int* a) {{ return {}; }}")
        self.makes("return", "v", "{}", around="struct V {{ int x; }}; V f(V v) {{ return {}; }}")
        self.makes("return", "V{}", around="struct V {{ int x; }}; V f() {{ return {}; }}")

    def test_only_the_file_itself_is_looked_at(self):
        self.assertEqual(mutated("#include <cmath>\nint a;\n", "arithmetic"), [])


if __name__ == "__main__":
    unittest.main()
