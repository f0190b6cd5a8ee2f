#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds tests that never run: FILE_test.cpp that no CMakeLists.txt of its folder, or of one that builds it elsewhere, names.
Usage: named_tests.py ROOT"""
import pathlib
import re
import sys

# Of a folder whose files another one builds: that one.
BUILT_BY = {"tests/windows": "tests/windows/programs", "tests/support": "tests"}


def names(root, folder):
    lists = [root / folder / "CMakeLists.txt", root / BUILT_BY.get(folder, folder) / "CMakeLists.txt"]
    text = "\n".join(re.sub(r"#.*", "", file.read_text(encoding="utf-8")) for file in lists if file.is_file())
    return set(re.findall(r"\w+", text.replace("_test.cpp", " ")))


def faults(root):
    for file in sorted(root.glob("tests/**/*_test.cpp")):
        folder = file.parent.relative_to(root).as_posix()
        if file.name.removesuffix("_test.cpp") not in names(root, folder):
            yield f"{folder}/{file.name}: no CMakeLists.txt names it, so it never runs"


if __name__ == "__main__":
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found))
    sys.exit(1 if found else 0)
