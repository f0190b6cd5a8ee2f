#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds what has grown beyond one purpose: a source file of the house of more than 400 lines, a page's session of more than
250 (its header and its source together), and a class of more than 15 properties (Q_PROPERTY).

Tests and what scripts make are not looked at. DATA lists the files that may be longer, with the reason; one that is there
without need is a fault too. Usage: sizes.py ROOT
"""

import pathlib
import re
import sys

ROOMS = ["app", "core", "device", "audio", "faces"]
SOURCES = {".cpp", ".hpp", ".qml", ".py", ".S"}
LINES, SESSION, PROPERTIES = 400, 250, 15
DATA = {"audio/sentences/sentence_list.cpp": "every sentence of the rooms below app; sentences.py writes it"}
OF_SESSION = re.compile(r"(app/pages/\w+/\w+_session)\.[ch]pp$")
CLASS = re.compile(r"^\s*(?:class|struct)\s+(?:alignas\(\w+\)\s+)?(\w+)(?:\s+final)?\s*(?:$|[:{])")


def properties(lines):
    """(class, number of its properties) of a header, in order."""
    found, name = {}, ""
    for line in lines:
        declared = CLASS.match(line)
        if declared:
            name = declared[1]
        elif line.lstrip().startswith("Q_PROPERTY("):
            found[name] = found.get(name, 0) + 1
    return list(found.items())


def faults(root, data=None):
    """Sentences, one for each file or class that is too large."""
    data = DATA if data is None else data
    sessions = {}
    for room in ROOMS:
        for path in sorted(path for path in (root / room).rglob("*") if path.suffix in SOURCES):
            name = path.relative_to(root).as_posix()
            lines = path.read_text(encoding="utf-8").splitlines()
            if len(lines) > LINES and name not in data:
                yield f"{name}: has {len(lines)} lines; at most {LINES} have one purpose"
            if session := OF_SESSION.match(name):
                sessions[session[1]] = sessions.get(session[1], 0) + len(lines)
            for owner, count in properties(lines):
                if count > PROPERTIES:
                    yield f"{name}: {owner} has {count} properties; at most {PROPERTIES} have one reason to change"
    for name, count in sorted(sessions.items()):
        if count > SESSION:
            yield f"{name}: has {count} lines with its header; at most {SESSION} are a small root of named parts"
    for name in sorted(data):
        path = root / name
        if not path.is_file() or len(path.read_text(encoding="utf-8").splitlines()) <= LINES:
            yield f"{name}: is in the list of long files without need"


def main():
    found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    for fault in found:
        print(fault)
    print(f"{len(found)} files and classes that are too large")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
