#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the manual's pages: write_pages.py ROOT PROGRAMS FOLDER [EMULATOR…].

PROGRAMS is the folder of the built programs, which are asked for their --help, by an emulator where they are built for
another machine. Number and day are those of the newest release in CHANGELOG.md.
"""
import os
import pathlib
import re
import subprocess
import sys

import pages

RELEASE = re.compile(r"^## (\d+\.\d+\.\d+), (\d{4}-\d{2}-\d{2})$", re.M)


def main():
    root, programs, folder = (pathlib.Path(word) for word in sys.argv[1:4])
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8", "LANGUAGE": ""}

    def answer(program, *words):
        return subprocess.run([*sys.argv[4:], programs / program, *words], env=environment, check=True,
                              capture_output=True, text=True, encoding="utf-8").stdout

    newest = RELEASE.search((root / "CHANGELOG.md").read_text(encoding="utf-8"))
    if newest is None:
        sys.exit(f"{root / 'CHANGELOG.md'} has no release: a heading such as \"## 0.1.0, 2026-11-26\" begins one.")
    of = newest.groups()
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in {
        "touchphoto.1": pages.touchphoto(root, *of, answer),
        "touchphoto-lab.1": pages.lab(root, *of, answer),
        "touchphoto-force-guard.8": pages.helper(root, *of, "touchphoto-force-guard", "device/guard/process/main.cpp"),
        "touchphoto-decoder.8": pages.helper(root, *of, "touchphoto-decoder", "app/decoder/main.cpp"),
    }.items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
