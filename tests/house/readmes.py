#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds READMEs that a newcomer cannot read in two minutes.

- Every room (a folder whose CMakeLists.txt calls tp_room) has a README.md.
- A README has at most 60 lines. A line of prose has at most 100 characters, a row of a table or a line of a code
  block 120. A line that is one unbroken word, picture or link may be longer.
- A room's README has its title, what the room is for, and then these sections in this order: How it works, which
  begins with a picture in a code block; Files; To add one more; Not here. Others may stand between and after them.
  Folders with headers, or with Python programs, that have a README count as rooms.
- FIGURES.md and other pages beside a README keep the lengths of lines, not the number of lines.
- docs/decisions holds NNNN-title.md, numbered from 0001 without a gap, of at most 60 lines, with Context, Choice
  and Consequences.
- A link to a file of the house leads to a file that is there.

The README of the root may be longer, and rows of its tables and of the lists in docs may be wider. Usage: readmes.py ROOT
"""

import pathlib
import re
import sys

LINES, PROSE, FIXED = 60, 100, 120
ROOM = ["How it works", "Files", "To add one more", "Not here"]
DECISION = ["Context", "Choice", "Consequences"]
ROOT_README = "README.md"
WIDE_TABLES = {ROOT_README, "docs/dependencies.md", "docs/features.md"}
# Pages of their own form.
OTHER = {"SECURITY.md", "THREATS.md", "tests/foreign_bytes.md", "device/force_pad/PROTOCOL.md",
         "device/recording/FORMAT.md"}
SKIPPED = {"build", "out"}  # what the scripts make
LINK = re.compile(r"\[[^\]]*\]\(([^)#\s]+)[^)]*\)")


def sections(lines):
    """The headings of level 2 with the lines below each; what stands before the first has the heading ''."""
    found, code = [("", [])], False
    for line in lines:
        code ^= line.startswith("```")
        if line.startswith("## ") and not code:
            found.append((line[3:].strip(), []))
        else:
            found[-1][1].append(line)
    return found


def wide_lines(lines, wide_tables=False):
    """(number, length, limit) of the lines that are too long."""
    code = False
    for number, line in enumerate(lines, 1):
        code ^= line.startswith("```")
        row = line.startswith("|")
        limit = FIXED if code or row else PROSE
        unbroken = line.startswith("![") or (not row and " " not in line.strip().removeprefix("- "))
        if len(line) > limit and not unbroken and not (row and wide_tables):
            yield number, len(line), limit


def form_faults(lines, wanted, picture=False):
    """What is missing of the title, of the first paragraph and of the sections `wanted`, in their order."""
    if not lines or not lines[0].startswith("# "):
        yield "has no title: its first line should be '# folder'"
    parts = sections(lines)
    if picture and not any(line and not line.startswith("#") for line in parts[0][1]):
        yield "does not say below its title what the room is for"
    names = [name for name, _ in parts]
    for name in wanted:
        if name not in names:
            yield f"lacks the section '## {name}'"
    order = [name for name in names if name in wanted]
    if order != [name for name in wanted if name in order]:
        yield f"has its sections in another order than {', '.join(wanted)}"
    for name, below in parts:
        if name in wanted and not any(line.strip() for line in below):
            yield f"says nothing in the section '## {name}'"
        if picture and name == wanted[0] and not any(line.startswith("```") for line in below):
            yield f"has no picture in a code block in '## {name}'"


def makes_room(folder):
    made = folder / "CMakeLists.txt"
    return made.is_file() and re.search(r"^\s*tp_room\(", made.read_text(encoding="utf-8"), re.M) is not None


def is_room(folder):
    return makes_room(folder) or any(folder.glob("*.hpp")) or any(folder.glob("*.py"))


def dead_links(path, text):
    """Links of the page to files that are not there."""
    for target in LINK.findall(re.sub(r"```.*?```", "", text, flags=re.S)):
        if "://" not in target and not (path.parent / target).exists():
            yield f"points to {target}, which is not there"


def files(root):
    """Every file of the house, in order."""
    for folder in sorted(path for path in root.iterdir() if path.is_dir()):
        if folder.name not in SKIPPED and not folder.name.startswith("."):
            yield from sorted(path for path in folder.rglob("*") if path.suffix in (".md", ".txt"))
    yield from sorted(root.glob("*.md"))


def faults(root):
    """Sentences, one for each fault of the house."""
    house = list(files(root))
    for path in (path for path in house if path.suffix == ".md"):
        name = path.relative_to(root).as_posix()
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for fault in dead_links(path, text):
            yield f"{name}: {fault}"
        if name in OTHER:
            continue
        for number, length, limit in wide_lines(lines, name in WIDE_TABLES):
            yield f"{name}:{number}: has {length} characters; at most {limit} can be read"
        decision = path.parent == root / "docs" / "decisions" and path.name != "README.md"
        if (path.name == "README.md" and name != ROOT_README or decision) and len(lines) > LINES:
            yield f"{name}: has {len(lines)} lines; at most {LINES} are read in two minutes"
        if decision:
            for fault in form_faults(lines, DECISION):
                yield f"{name}: {fault}"
        elif path.name == "README.md" and is_room(path.parent):
            for fault in form_faults(lines, ROOM, picture=True):
                yield f"{name}: {fault}"
    for folder in (path.parent for path in house if path.name == "CMakeLists.txt"):
        if makes_room(folder) and not (folder / "README.md").is_file():
            yield f"{folder.relative_to(root).as_posix()}: is a room without a README.md"
    for number, path in enumerate(sorted((root / "docs" / "decisions").glob("[0-9]*.md")), 1):
        if not re.fullmatch(rf"{number:04}-[a-z0-9-]+\.md", path.name):
            yield f"docs/decisions/{path.name}: should be called {number:04}-title.md"


def main():
    found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    for fault in found:
        print(fault)
    print(f"{len(found)} faults in READMEs and their pages")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
