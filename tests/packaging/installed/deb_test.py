#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""packaging/deb packs the finished build of the last commit: lintian finds nothing, and each package is small and whole."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from installed import BUILD, ROOT, SKIPPED, needs

needs("dh", "dpkg-buildpackage", "lintian")
if subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True).returncode != 0:
    print("needs a clone: packages are built out of the last commit")
    sys.exit(SKIPPED)

LARGEST = 20_000_000  # bytes that are downloaded beside dependencies


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name)
        made = subprocess.run([ROOT / "packaging/deb", "--from", BUILD, "--out", cls.out], capture_output=True, text=True)
        if made.returncode != 0:
            raise AssertionError(made.stderr)

    def package(self, name):
        [file] = self.out.glob(f"{name}_*.deb")
        return file

    def test_lintian_finds_nothing(self):
        [changes] = self.out.glob("*.changes")
        said = subprocess.run(["lintian", "--allow-root", "--fail-on", "error,warning", changes], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stdout + said.stderr)

    def test_each_package_is_small(self):
        for name in ("touchphoto", "touchphoto-lab"):
            self.assertLess(self.package(name).stat().st_size, LARGEST)

    def test_no_file_is_in_both(self):
        def held(name):
            listed = subprocess.run(["dpkg-deb", "-c", self.package(name)], check=True, capture_output=True, text=True).stdout
            return {line.split()[5] for line in listed.splitlines() if not line.endswith("/")}

        self.assertIn("./usr/bin/touchphoto", held("touchphoto"))
        self.assertEqual(held("touchphoto") & held("touchphoto-lab"), set())

    def test_every_dependency_has_a_name(self):
        for name in ("touchphoto", "touchphoto-lab"):
            said = subprocess.run(["dpkg-deb", "-f", self.package(name), "Depends", "Recommends"], check=True,
                                  capture_output=True, text=True).stdout
            self.assertRegex(said, r"libopencv-imgcodecs\d+")
            self.assertRegex(said, r"libheif1")
            self.assertRegex(said, r"Recommends: .*libavformat\d+")
            self.assertNotIn("${", said)

    def test_nothing_runs_when_it_is_installed_or_removed(self):
        for name in ("touchphoto", "touchphoto-lab"):
            said = subprocess.run(["dpkg-deb", "-I", self.package(name)], check=True, capture_output=True, text=True).stdout
            self.assertNotRegex(said, r"(?m)(pre|post)(inst|rm)$")


if __name__ == "__main__":
    sys.exit(unittest.main())
