#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check of READMEs finds bad ones, and only them."""

import pathlib
import tempfile
import unittest

from readmes import faults

GOOD = """# room (`tp_room`)
This room is an example.

## How it works
```
in ──► out
```

## Files
| you look for | file |
| --- | --- |
| it | `it.hpp` |

## To add one more
Write it.

## Not here
Nothing else.
"""
DECISION = "# 0001: So\n## Context\nWhy.\n\n## Choice\nThis.\n\n## Consequences\nThat.\n"
ROOM = "tp_room(tp_room\n  SOURCES it.cpp)\n"


def found(readme=GOOD, cmake=ROOM, **others):
    """What the check says of a house with one room; `others` are files, with __ for / and _DOT_ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        files = {"room/CMakeLists.txt": cmake, "room/README.md": readme}
        files |= {name.replace("__", "/").replace("_DOT_", ".").replace("_DASH_", "-"): text for name, text in others.items()}
        for name, text in files.items():
            if text is not None:
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
        return list(faults(root))


class Readmes(unittest.TestCase):
    def test_a_good_readme_has_no_faults(self):
        self.assertEqual(found(), [])

    def test_a_room_without_a_readme_is_found(self):
        self.assertEqual(found(readme=None), ["room: is a room without a README.md"])

    def test_a_folder_that_is_no_room_needs_none(self):
        self.assertEqual(found(readme=None, cmake="# tp_room(not this)\nadd_subdirectory(it)\n"), [])

    def test_sixty_lines_are_read_and_no_more(self):
        lines = GOOD.count("\n")
        self.assertEqual(found(GOOD + "x\n" * (60 - lines)), [])
        self.assertEqual(found(GOOD + "x\n" * (61 - lines)),
                         ["room/README.md: has 61 lines; at most 60 are read in two minutes"])

    def test_a_line_of_prose_is_short(self):
        self.assertEqual(found(GOOD + "word " * 20), [])
        self.assertEqual(len(found(GOOD + "a " * 50 + "bc\n")), 1)

    def test_rows_and_code_may_be_a_little_wider(self):
        self.assertEqual(found(GOOD + "| " + "a" * 116 + " |\n"), [])
        self.assertEqual(len(found(GOOD + "| " + "a" * 117 + " |\n")), 1)
        self.assertEqual(found(GOOD + "```\n" + "a " * 60 + "\n```\n"), [])
        self.assertEqual(len(found(GOOD + "```\n" + "a " * 60 + "b\n```\n")), 1)

    def test_what_cannot_be_broken_may_be_longer(self):
        self.assertEqual(found(GOOD + "- https://" + "a" * 120 + "\n"), [])

    def test_each_section_is_there_once_in_order_and_says_something(self):
        for name in ("How it works", "Files", "To add one more", "Not here"):
            self.assertIn(f"room/README.md: lacks the section '## {name}'", found(GOOD.replace(f"## {name}\n", "")))
        self.assertIn("room/README.md: says nothing in the section '## Not here'", found(GOOD.replace("Nothing else.\n", "")))
        swapped = GOOD.replace("## Files", "## X").replace("## To add one more", "## Files").replace("## X", "## To add one more")
        self.assertTrue(any("in another order" in fault for fault in found(swapped)))
        self.assertTrue(any("in another order" in fault for fault in found(GOOD + "\n## Files\nAgain.\n")))

    def test_there_is_a_picture_and_a_first_paragraph(self):
        self.assertEqual(found(GOOD.replace("```\nin ──► out\n```", "In goes out.")),
                         ["room/README.md: has no picture in a code block in '## How it works'"])
        self.assertEqual(found(GOOD.replace("This room is an example.\n", "")),
                         ["room/README.md: does not say below its title what the room is for"])

    def test_headings_in_a_code_block_are_none(self):
        self.assertTrue(found(GOOD.replace("## Not here", "```\n## Not here\n```")))

    def test_folders_with_headers_count_as_rooms_and_floors_do_not(self):
        self.assertEqual(found(floor__README_DOT_md="# floor\nRooms.\n"), [])
        self.assertEqual(len(found(floor__README_DOT_md="# floor\nRooms.\n", floor__it_DOT_hpp="")), 5 - 1)

    def test_a_link_leads_somewhere(self):
        self.assertEqual(found(GOOD + "See [it](gone.md).\n"), ["room/README.md: points to gone.md, which is not there"])
        self.assertEqual(found(GOOD + "See [it](CMakeLists.txt) and [that](https://x.org/y).\n"), [])

    def test_decisions_have_their_numbers_and_sections(self):
        self.assertEqual(found(docs__decisions__0001_DASH_so_DOT_md=DECISION), [])
        self.assertEqual(found(docs__decisions__0002_DASH_so_DOT_md=DECISION),
                         ["docs/decisions/0002-so.md: should be called 0001-title.md"])
        self.assertEqual(found(docs__decisions__0001_DASH_so_DOT_md=DECISION.replace("## Choice\n", "")),
                         ["docs/decisions/0001-so.md: lacks the section '## Choice'"])


if __name__ == "__main__":
    unittest.main()
