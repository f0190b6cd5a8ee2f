#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A build is packed from whatever folder it lies in: rules_test.py RULES."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

RULES = pathlib.Path(sys.argv.pop(1)).resolve()

# In the place of cmake: says what it was given, a word a line.
CMAKE = """#!/bin/sh
printf '%s\\n' "$DESTDIR" "$@"
"""


class Rules(unittest.TestCase):
    def test_words_of_any_letters_stay_whole(self):
        with tempfile.TemporaryDirectory(suffix=" x y's") as folder:
            programs = pathlib.Path(folder, "programs")
            programs.mkdir()
            cmake = programs / "cmake"
            cmake.write_text(CMAKE, encoding="utf-8")
            cmake.chmod(0o755)
            for built in ("/tmp/x y/touchphoto/build/release", "/a b's \"ä\"/$HOME/`pwd`/build"):
                with self.subTest(built):
                    ran = subprocess.run(
                        ["make", "--silent", "-f", RULES, "override_dh_auto_install"], cwd=folder, text=True, check=True,
                        stdout=subprocess.PIPE,
                        env={**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "TOUCHPHOTO_BUILT": built})
                    expected = [[f"{folder}/debian/{part}", "--install", built, "--prefix", "/usr", "--component", part]
                                for part in ("touchphoto", "touchphoto-lab")]
                    self.assertEqual(ran.stdout.splitlines(), expected[0] + expected[1])


if __name__ == "__main__":
    unittest.main()
