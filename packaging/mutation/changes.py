# SPDX-License-Identifier: Apache-2.0
"""Which lines of which files are others than at some commit."""

from __future__ import annotations

import pathlib
import re
import subprocess


def changed_lines(root: pathlib.Path, since: str) -> dict[str, set[int]]:
    """Of each file as it lies there now, committed or not, the lines that are new or other than at `since`."""
    shown = subprocess.run(["git", "-C", root, "diff", "-U0", "--no-color", "--no-ext-diff", "--no-renames", since, "--"],
                           check=True, capture_output=True, text=True, errors="replace")
    found: dict[str, set[int]] = {}
    lines: set[int] = set()
    for line in shown.stdout.splitlines():
        if line.startswith("+++ "):
            lines = found.setdefault(line.removeprefix("+++ b/"), set())
        elif hunk := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(hunk[1]), int(hunk[2] or 1)
            lines.update(range(first, first + count))
    return found
