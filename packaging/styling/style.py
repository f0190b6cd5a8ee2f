#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges changed lines of C++: laid out by clang-format, looked through by clang-tidy. packaging/style runs it."""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "mutation"))

from changes import changed_lines  # noqa: E402
from layout import badly_laid_out  # noqa: E402
from program import Program  # noqa: E402
from tidiness import look_through, sources_to_ask  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def changed_sources(root, since):
    """Files of C++ as they lie there, with the numbers of their changed lines. What is included as data is none."""
    changes = changed_lines(root, since)
    return {name: lines for name, lines in sorted(changes.items())
            if name.endswith((".cpp", ".hpp")) and lines and (root / name).is_file()}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--since", required=True, metavar="COMMIT")
    options.add_argument("--seconds", type=float, default=150, help="for clang-tidy")
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="a configured one")
    asked = options.parse_args()

    changes = changed_sources(ROOT, asked.since)
    faults = [fault for name, lines in changes.items() for fault in badly_laid_out(ROOT, name, lines)]
    sources, unseen = sources_to_ask(Program(ROOT, asked.build), changes)
    found, left_out = look_through(ROOT, sources, changes, asked.seconds)
    faults += found
    for fault in faults:
        print(fault)
    if unseen:
        print(f"Not compiled here, so not looked through: {', '.join(unseen)}")
    if left_out:
        print(f"Left out for want of time: {', '.join(left_out)}")
    print(f"{len(changes)} changed files; {len(sources) - len(left_out)} of {len(sources)} looked through by clang-tidy; "
          f"{len(faults)} to mend")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
