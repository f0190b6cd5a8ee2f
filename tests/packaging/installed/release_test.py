#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""packaging/release makes sources, packages and checksums out of the last commit, and made twice they have the same bytes."""
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

from installed import BUILD, ROOT, SKIPPED, needs

needs("dh", "dpkg-buildpackage")
if subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True).returncode != 0:
    print("needs a clone: a release is made out of the last commit")
    sys.exit(SKIPPED)


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name)
        quickly = {**os.environ, "DPKG_DEB_COMPRESSOR_TYPE": "gzip"}  # how small packages are is deb_test.py's
        cls.made = subprocess.run([ROOT / "packaging/release", "--from", BUILD, "--twice", "--out", cls.out], env=quickly,
                                  capture_output=True, text=True)
        if cls.made.returncode != 0:
            raise AssertionError(cls.made.stderr)

    def test_it_was_made_twice_with_the_same_bytes(self):
        self.assertIn("Made twice, the same bytes", self.made.stderr)

    def test_the_checksums_are_those_of_all_files(self):
        subprocess.run(["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=self.out, check=True, capture_output=True)
        listed = {line.split()[1] for line in (self.out / "SHA256SUMS").read_text().splitlines()}
        self.assertEqual(listed | {"SHA256SUMS"}, {file.name for file in self.out.iterdir()})
        self.assertEqual(len(listed), 3)

    def test_the_sources_are_those_of_the_commit(self):
        number = re.search(r"^project\(TouchPhoto VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
        listed = subprocess.run(["git", "-C", ROOT, "ls-tree", "-r", "-z", "--name-only", "HEAD"], capture_output=True,
                                check=True).stdout.decode().split("\0")
        with tarfile.open(self.out / f"touchphoto-{number}.tar.gz") as sources:
            held = {member.name for member in sources.getmembers() if not member.isdir()}
            commit = sources.extractfile(f"touchphoto-{number}/cmake/commit.txt").read().decode()
        self.assertEqual(held, {f"touchphoto-{number}/{name}" for name in listed if name})
        head = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, check=True, text=True).stdout.strip()
        self.assertIn(head[:12], commit)


if __name__ == "__main__":
    sys.exit(unittest.main())
