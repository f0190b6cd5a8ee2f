# SPDX-License-Identifier: Apache-2.0
"""Whether changed lines are laid out as .clang-format says."""

import difflib
import subprocess


def ranges(lines):
    """Numbers as (first, last) of those that follow each other."""
    found = []
    for number in sorted(lines):
        if found and number == found[-1][1] + 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return [tuple(pair) for pair in found]


def badly_laid_out(root, name, lines):
    """A sentence for each place where clang-format would change one of these lines, with what it would make of it."""
    text = (root / name).read_text(encoding="utf-8")
    made = subprocess.run(["clang-format-14", f"--assume-filename={root / name}",
                           *(f"--lines={first}:{last}" for first, last in ranges(lines))],
                          input=text, capture_output=True, text=True, check=True).stdout
    ours, theirs = text.splitlines(), made.splitlines()
    for kind, first, last, begin, end in difflib.SequenceMatcher(None, ours, theirs, autojunk=False).get_opcodes():
        if kind != "equal":
            yield "\n".join([f"{name}:{first + 1}: is laid out otherwise than .clang-format says; it should be",
                             *(f"    {line}" for line in theirs[begin:end])])
