# SPDX-License-Identifier: Apache-2.0
"""Mutants that no test can notice, each with the reason, from tests/equivalent_mutants.txt."""

from __future__ import annotations

import dataclasses

from mutant import Mutant


@dataclasses.dataclass(frozen=True)
class Equivalent:
    file: str
    difference: tuple[str, ...]
    reason: str


class BadEntry(Exception):
    pass


def read_equivalents(text: str) -> list[Equivalent]:
    """Blocks between blank lines: the file, the lines taken away and put there, the reason. "#" begins a comment."""
    found = []
    lines = [line.strip() for line in text.splitlines() if not line.startswith("#")]
    for block in "\n".join(lines).split("\n\n"):
        rows = [row for row in block.splitlines() if row]
        if not rows:
            continue
        difference = tuple(row for row in rows[1:] if row.startswith(("- ", "+ ")))
        reason = " ".join(row for row in rows[1:] if not row.startswith(("- ", "+ ")))
        if not difference or not reason:
            raise BadEntry(f"An entry for {rows[0]} lacks its difference or its reason.")
        found.append(Equivalent(rows[0], difference, reason))
    return found


def is_listed(mutant: Mutant, content: bytes, entries: list[Equivalent]) -> bool:
    return any((entry.file, entry.difference) == (mutant.file, mutant.difference(content)) for entry in entries)


def stale(entries: list[Equivalent], mutants: list[Mutant], contents: dict[str, bytes]) -> list[Equivalent]:
    """Those that are none of these mutants, which are all mutants of their files."""
    there = {(mutant.file, mutant.difference(contents[mutant.file])) for mutant in mutants}
    return [entry for entry in entries if entry.file in contents and (entry.file, entry.difference) not in there]
