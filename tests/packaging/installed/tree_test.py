#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` makes is whole: both parts run without the build, find what they start, and hold what a desktop, a
shell and udev look for."""
import re
import subprocess
import sys
import unittest

from installed import BUILD, NAME, ROOT, Installed, needs

needs("readelf", "desktop-file-validate", "appstreamcli", "xmllint")

FOR_EACH = ["bin/{0}", "lib/udev/rules.d/70-{0}.rules", "libexec/{0}/touchphoto-decoder",
            "libexec/{0}/touchphoto-force-guard", "share/bash-completion/completions/{0}", "share/man/man1/{0}.1"]
FOR_DESKTOP = [f"share/applications/{NAME}.desktop", f"share/metainfo/{NAME}.metainfo.xml",
               f"share/mime/packages/{NAME}.xml", f"share/icons/hicolor/scalable/apps/{NAME}.svg",
               "share/man/man8/touchphoto-decoder.8", "share/man/man8/touchphoto-force-guard.8"]
SIZES = (16, 22, 24, 32, 48, 64, 96, 128, 256, 512)


def files(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def needed(program):
    return re.findall(r"\(NEEDED\).*\[(.+)\]", subprocess.run(["readelf", "-d", program], check=True, capture_output=True,
                                                             text=True).stdout)


class Tree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.installed = Installed()
        cls.program = cls.installed.parts["touchphoto"]
        cls.lab = cls.installed.parts["touchphoto-lab"]

    def test_each_part_holds_what_is_its_own_and_no_more(self):
        icons = [f"share/icons/hicolor/{size}x{size}/apps/{NAME}.png" for size in SIZES]
        self.assertEqual(files(self.program), {name.format("touchphoto") for name in FOR_EACH} | {*FOR_DESKTOP, *icons})
        studies = {f"share/touchphoto-lab/studies/{file.name}" for file in (ROOT / "resources/studies").glob("*.study")}
        self.assertEqual(files(self.lab), {name.format("touchphoto-lab") for name in FOR_EACH} | studies)

    def test_a_png_is_decoded_by_the_installed_helper(self):
        picture = self.program / f"share/icons/hicolor/512x512/apps/{NAME}.png"
        said = self.installed.run("touchphoto-lab", "album", "show", str(picture), "--json")
        self.assertIn('"width":512', said.stdout.replace(" ", ""), said.stderr)
        self.assertNotIn('"seen":null', said.stdout.replace(" ", ""), said.stderr)

    def test_without_its_helper_it_says_what_to_do(self):
        helper = self.lab / "libexec/touchphoto-lab/touchphoto-decoder"
        away = helper.rename(helper.with_name("away"))
        self.addCleanup(away.rename, helper)
        said = self.installed.run("touchphoto-lab", "faces", str(
            self.program / f"share/icons/hicolor/512x512/apps/{NAME}.png"))
        self.assertEqual(said.returncode, 1)
        self.assertRegex(said.stderr, "touchphoto-decoder.* install TouchPhoto again")

    def test_every_program_says_the_same_version(self):
        lines = {self.installed.run(part, "--version").stdout.splitlines()[0].split(" ", 1)[1] for part in self.installed.parts}
        for helper in ("touchphoto-decoder", "touchphoto-force-guard"):
            said = self.installed.run("touchphoto", helper, "--version", path="libexec/touchphoto").stdout
            self.assertTrue(said.startswith(helper + " "), said)
            lines.add(said.strip().split(" ", 1)[1])
        self.assertEqual(len(lines), 1, lines)

    def test_no_program_looks_for_libraries_where_it_was_built(self):
        for part, below in self.installed.parts.items():
            for program in [below / "bin" / part, *(below / "libexec" / part).iterdir()]:
                said = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True).stdout
                self.assertNotRegex(said, "RPATH|RUNPATH", program)
                self.assertNotIn(str(BUILD).encode(), program.read_bytes(), program)

    def test_the_shell_needs_no_qt_quick(self):
        libraries = needed(self.lab / "bin/touchphoto-lab")
        self.assertIn("libQt6Core.so.6", libraries)
        self.assertFalse([name for name in libraries if re.search("Quick|Qml|Multimedia|Speech", name)])

    def test_icons_have_the_size_that_their_folder_says(self):
        for size in SIZES:
            head = (self.program / f"share/icons/hicolor/{size}x{size}/apps/{NAME}.png").read_bytes()[:24]
            self.assertEqual([int.from_bytes(head[at:at + 4], "big") for at in (16, 20)], [size, size])

    def test_desktop_file_and_appstream_are_valid(self):
        for check in (["desktop-file-validate", self.program / f"share/applications/{NAME}.desktop"],
                      ["appstreamcli", "validate", "--no-net", self.program / f"share/metainfo/{NAME}.metainfo.xml"],
                      ["xmllint", "--noout", self.program / f"share/mime/packages/{NAME}.xml"]):
            done = subprocess.run(check, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("hint", done.stdout + done.stderr)

    def test_what_the_desktop_file_opens_is_what_software_centres_are_told(self):
        desktop = (self.program / f"share/applications/{NAME}.desktop").read_text(encoding="utf-8")
        opened = re.search("^MimeType=(.*);$", desktop, re.M)[1].split(";")
        metainfo = (self.program / f"share/metainfo/{NAME}.metainfo.xml").read_text(encoding="utf-8")
        self.assertEqual(opened, re.findall("<mediatype>(.*)</mediatype>", metainfo))
        self.assertIn("Exec=touchphoto %f\n", desktop)
        mime = (self.program / f"share/mime/packages/{NAME}.xml").read_text(encoding="utf-8")
        self.assertIn(re.search('<mime-type type="(.*)">', mime)[1], opened)

    def test_software_centres_know_the_usb_devices_of_the_udev_rules(self):
        rules = (self.program / "lib/udev/rules.d/70-touchphoto.rules").read_text(encoding="utf-8")
        devices = {f"usb:v{vendor}p{product}d*".upper() for vendor, product in
                   re.findall(r'ATTRS?\{idVendor\}=="(\w+)", ATTRS?\{idProduct\}=="(\w+)"', rules)}
        metainfo = (self.program / f"share/metainfo/{NAME}.metainfo.xml").read_text(encoding="utf-8")
        self.assertEqual({alias.upper() for alias in re.findall("<modalias>(.*)</modalias>", metainfo)}, devices)

    def test_udev_opens_no_input_device_but_those_that_shake_or_tick(self):
        rules = (self.program / "lib/udev/rules.d/70-touchphoto.rules").read_text(encoding="utf-8")
        of_input = [rule for rule in rules.splitlines() if "event*" in rule or 'SUBSYSTEM=="input"' in rule]
        self.assertEqual(len(of_input), 1)
        self.assertIn('ATTRS{capabilities/ff}!="0"', of_input[0])


if __name__ == "__main__":
    sys.exit(unittest.main())
