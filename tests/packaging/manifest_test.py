#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vcpkg.json names a port for every library that CMakeLists.txt looks for, and no other. Usage: manifest_test.py ROOT"""
import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop())
# What CMakeLists.txt calls it: its ports.
PORTS = {
    "glm": ["glm"], "PkgConfig": ["pkgconf"], "louis": ["liblouis"], "pugixml": ["pugixml"], "exiv2": ["exiv2"],
    "sndfile": ["libsndfile"], "ebur128": ["libebur128"], "soundtouch": ["soundtouch"], "libav": ["ffmpeg"],
    "libheif": ["libheif"], "archive": ["libarchive"], "zlib": ["zlib"], "hidapi": ["hidapi"], "libusb": ["libusb"],
    "turbojpeg": ["libjpeg-turbo"], "png": ["libpng"],
    "OpenCV": ["opencv4"], "Boost": ["boost-math"], "nanoflann": ["nanoflann"],
    "Qt6": ["qtbase", "qtdeclarative", "qtmultimedia", "qtspeech", "qtsvg", "qttools"],
}
NO_PORT = {
    "Threads": "of the system", "seccomp": "of Linux alone", "2geom": "nobody has made one",
}
SOUGHT = re.compile(r"^\s*(?:find_package|pkg_check_modules)\((\w+)", re.M)


class Manifest(unittest.TestCase):
    def test_each_library_has_its_ports(self):
        files = [ROOT / "CMakeLists.txt", *(ROOT / "app").rglob("CMakeLists.txt"), *(ROOT / "core").rglob("CMakeLists.txt"),
                 *(ROOT / "cmake").glob("*.cmake")]
        sought = {name for file in files for name in SOUGHT.findall(file.read_text(encoding="utf-8"))} - set(NO_PORT)
        unknown = sought - set(PORTS)
        self.assertEqual(unknown, set(), "name their ports here and in vcpkg.json, or say here why they have none")
        named = json.loads((ROOT / "vcpkg.json").read_text(encoding="utf-8"))["dependencies"]
        names = [port if isinstance(port, str) else port["name"] for port in named]
        self.assertEqual(sorted(names), sorted(port for name in PORTS for port in PORTS[name]))


if __name__ == "__main__":
    sys.exit(unittest.main())
