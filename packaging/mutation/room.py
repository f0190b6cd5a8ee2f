# SPDX-License-Identifier: Apache-2.0
"""A room with the mutants of it that are asked for, and what became of them."""

from __future__ import annotations

import argparse
import hashlib
import os
import pathlib
import random

import equivalents
from changes import changed_lines
from mutant import Mutant
from places import mutants_of
from program import Program
from record import Record


class Room:
    def __init__(self, program: Program, name: str, listed: list[equivalents.Equivalent], files: set[str] | None):
        """`files`: only those of them, where not None."""
        self.name = name
        self.contents = {file: (program.root / file).read_bytes() for file in program.sources(name)
                         if files is None or file in files}
        self.mutants: list[Mutant] = []
        for file, content in self.contents.items():
            self.mutants += mutants_of(str(program.root / file), file, content, program.parse_flags(file))
        self.stale = equivalents.stale(listed, self.mutants, self.contents)
        self.work = program.root / "build/mutants" / name.replace("/", ".")
        self.record = Record(self.work.with_name(self.work.name + ".jsonl"), _digest(program.root / program.tests_folder(name)))
        self.entries: list[dict] = []
        self.not_tried = 0

    def content(self, mutant: Mutant) -> bytes:
        return self.contents[mutant.file]

    def results(self) -> list[str]:
        return [entry["result"] for entry in self.entries]


def rooms_with_mutants(program: Program, options: argparse.Namespace, listed: list[equivalents.Equivalent]) -> list[Room]:
    """The rooms that have mutants of those that are asked for."""
    changed = changed_lines(program.root, options.changed_since) if options.changed_since else None
    rooms = []
    candidates = []
    for name in options.rooms:
        files = None
        if changed is not None or options.file:
            files = {file for file in program.sources(name) if (changed is None or file in changed)
                     and (not options.file or os.path.basename(file) in options.file)}
        room = Room(program, name, listed, files)
        rooms.append(room)
        mutants = [mutant for mutant in room.mutants
                   if changed is None or changed[mutant.file] & set(mutant.lines(room.content(mutant)))]
        if options.each is not None and options.each < len(mutants):
            mutants = random.Random(options.seed).sample(mutants, options.each)
        candidates += [(room, mutant) for mutant in mutants]
    if options.sample is not None and options.sample < len(candidates):
        candidates = random.Random(options.seed).sample(candidates, options.sample)
    for room in rooms:
        room.mutants = [mutant for of, mutant in candidates if of is room]
    return [room for room in rooms if room.mutants or room.stale]


def _digest(tests: pathlib.Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(tests.iterdir()):
        if path.is_file():
            digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]
