#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts small faults into rooms of the house, one at a time, and tells which of them their tests do not notice."""

from __future__ import annotations

import argparse
import pathlib
import signal
import subprocess
import sys
import time

import equivalents
import report
from judge import Judge, Stopped, TestsFail
from mutant import Mutant
from options import read_options
from program import NoSuchRoom, Program
from record import SURVIVED
from room import Room, rooms_with_mutants
from workers import OtherRun, alone, for_each


def look_up(room: Room, listed: list[equivalents.Equivalent]) -> list[Mutant]:
    """Those of its mutants of which nothing is known yet."""
    unknown = []
    for mutant in room.mutants:
        known = room.record.known(mutant, room.content(mutant))
        if equivalents.is_listed(mutant, room.content(mutant), listed):
            room.entries.append({"result": report.LISTED})
        elif known:
            room.entries.append(known)
        else:
            unknown.append(mutant)
    room.not_tried = len(unknown)
    return unknown


def try_each(program: Program, room: Room, mutants: list[Mutant], jobs: int, deadline: float) -> None:
    build_tests(program, room.name)
    judge = Judge(program, room.name, room.work)

    def try_one(mutant: Mutant, folder: pathlib.Path) -> None:
        if time.monotonic() > deadline:
            return
        begun = time.monotonic()
        content = room.content(mutant)
        result, by = judge.judge(mutant, content, folder)
        entry = room.record.add(mutant, content, result, by, time.monotonic() - begun)
        room.entries.append(entry)
        room.not_tried -= 1
        progress.step(entry)

    for_each(program.replaced_files(room.name), judge.compile_room, jobs, room.work, judge.stop)
    for_each([None], lambda _, folder: judge.run_plain(folder), 1, room.work, judge.stop)
    progress = report.Progress(room.name, len(mutants))
    try:
        for_each(mutants, try_one, jobs, room.work, judge.stop)
    finally:
        progress.end()


def build_tests(program: Program, room: str) -> None:
    targets = [program.target(test) for test in program.tests(room)]
    subprocess.run(["cmake", "--build", program.build, "--target", *targets], check=True, stdout=sys.stderr)


def tell(rooms: list[Room], options: argparse.Namespace) -> int:
    """Prints what came out; the exit status."""
    results = []
    for room in rooms:
        for entry in sorted((entry for entry in room.entries if entry["result"] == SURVIVED),
                            key=lambda entry: (entry["file"], entry["line"])):
            print(report.survivor(entry))
        for entry in room.stale:
            print(f"tests/equivalent_mutants.txt: no such mutant any more:\n{entry.file}", *entry.difference, sep="\n    ")
        results += room.results()
    for room in rooms:
        goal = options.goals[room.name].percent if room.name in options.goals else None
        print(report.summary(room.name, room.results(), room.not_tried, goal))
    if len(rooms) > 1:
        print(report.summary("all", results, sum(room.not_tried for room in rooms)))
    if options.at_least is None or report.is_enough(results, options.at_least):
        return 0
    print(f"The tests notice fewer than {options.at_least:g} %. Write tests that notice what is shown above, saying what a person "
          "would feel,\nor list what no test can notice, with the reason, in tests/equivalent_mutants.txt.")
    return 1


def main() -> int:
    for ending in (signal.SIGINT, signal.SIGTERM):
        signal.signal(ending, signal.default_int_handler)
    options = read_options()
    deadline = time.monotonic() + options.seconds if options.seconds else float("inf")
    program = Program(options.root, options.root / "build/release")
    listed = equivalents.read_equivalents((options.root / "tests/equivalent_mutants.txt").read_text(encoding="utf-8"))
    rooms = rooms_with_mutants(program, options, listed)
    if not rooms:
        print("Nothing changed in a room whose tests are tried with mutants." if options.changed_since else "There is no mutant.")
        return 0
    if options.list:
        for room in rooms:
            for mutant in room.mutants:
                print(report.survivor(mutant.shown(room.content(mutant))))
        return 0
    try:
        for room in rooms:
            unknown = look_up(room, listed)
            if unknown and time.monotonic() < deadline:
                with alone(room.work):
                    try_each(program, room, unknown, options.jobs, deadline)
    except (KeyboardInterrupt, Stopped):
        tell(rooms, options)
        print("Stopped. The same command goes on from here.")
        return 130
    return tell(rooms, options)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (NoSuchRoom, OtherRun, TestsFail, equivalents.BadEntry) as error:
        sys.exit(f"!! {error}")
