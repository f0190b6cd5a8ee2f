#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the Debian packages say of themselves is what the program is: its version, and what it loads when it runs."""
import datetime
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ET

from installed import BUILD, NAME, ROOT, needs

needs("readelf")
DEBIAN = ROOT / "packaging/debian"


def text(file):
    return (ROOT / file).read_text(encoding="utf-8")


def package(name):
    """The fields Depends and Recommends of a package, as sets of names."""
    paragraph = re.search(rf"^Package: {name}\n((?:.+\n)+)", (DEBIAN / "control").read_text(encoding="utf-8"), re.M)[1]
    return {field: {word.strip() for word in re.search(rf"^{field}:((?:.*\n)(?: .*\n)*)", paragraph, re.M)[1].split(",")}
            for field in ("Depends", "Recommends")}


class Version(unittest.TestCase):
    def test_there_is_one_number(self):
        number = re.search(r"^project\(TouchPhoto VERSION ([\d.]+)", text("CMakeLists.txt"), re.M)[1]
        newest, day = re.search(r"^## ([\d.]+), (\S+)$", text("CHANGELOG.md"), re.M).groups()
        release = ET.parse(ROOT / f"resources/desktop/{NAME}.metainfo.xml").getroot().find("releases/release").attrib
        debian = re.match(r"touchphoto \(([\d.]+)-\d+\)", text("packaging/debian/changelog"))[1]
        self.assertEqual([newest, release["version"], debian], [number] * 3)
        self.assertEqual(release["date"], day)
        datetime.date.fromisoformat(day)


class Loaded(unittest.TestCase):
    def test_libraries_that_are_loaded_when_needed_are_dependencies(self):
        programs = [BUILD / "bin" / name for name in ("touchphoto", "touchphoto-lab", "touchphoto-decoder")]
        linked, named = set(), set()
        for program in programs:
            said = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True).stdout
            linked |= {name.split(".so")[0] for name in re.findall(r"\[(lib.+?\.so\S*)\]", said)}
            named |= {name.decode() for name in re.findall(rb"\0(lib[a-zA-Z_0-9+-]+)\.so(?:\.\d+)+\0", program.read_bytes())}
        loaded = {name.removeprefix("lib") for name in named - linked}
        self.assertIn("opencv_imgcodecs", loaded)
        rules = (DEBIAN / "rules").read_text(encoding="utf-8")
        self.assertEqual(loaded - set(re.findall(r"-l(\w+)", rules)), set())
        for name in ("touchphoto", "touchphoto-lab"):
            self.assertIn("${touchphoto:Loaded}", package(name)["Depends"])
            self.assertIn("${touchphoto:Video}", package(name)["Recommends"])

    def test_qml_modules_that_pages_import_are_dependencies(self):
        imported = set()
        for page in (ROOT / "app").rglob("*.qml"):
            imported |= set(re.findall(r"^import (Qt[\w.]+)", page.read_text(encoding="utf-8"), re.M))
        self.assertIn("QtQuick.Layouts", imported)
        modules = {"qml6-module-" + name.lower().replace(".", "-") for name in imported}
        self.assertEqual(modules - package("touchphoto")["Depends"], set())

    def test_what_people_run_here_comes_with_the_package(self):
        run = {line for line in text("packaging/packages/run.txt").splitlines() if line and not line.startswith("#")}
        has = package("touchphoto")
        by_loaded = {"libheif1"}  # ${touchphoto:Loaded}
        self.assertEqual(run - has["Depends"] - has["Recommends"] - by_loaded, set())

    def test_the_braille_tables_and_the_index_come_with_both(self):
        for name in ("touchphoto", "touchphoto-lab"):
            self.assertLessEqual({"liblouis-data", "libqt6sql6-sqlite"}, package(name)["Depends"])


class Copyright(unittest.TestCase):
    def test_every_net_is_named_with_its_licence(self):
        told = (DEBIAN / "copyright").read_text(encoding="utf-8")
        origins = text("resources/models/ORIGINS.md")
        others = re.findall(r"^- `([\w.]+)`", origins.split("## Ours")[0], re.M)
        self.assertEqual(len(others), 3)
        for net in others:
            self.assertIn(f"Files: resources/models/{net}\n", told)
        for licence in re.findall(r"^License: (.+)$", told, re.M):
            for one in licence.split(" and "):
                self.assertRegex(told, rf"(?m)^License: {re.escape(one)}\n ", one)


if __name__ == "__main__":
    sys.exit(unittest.main())
