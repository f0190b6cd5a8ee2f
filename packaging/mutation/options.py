# SPDX-License-Identifier: Apache-2.0
"""What packaging/mutate is told."""

from __future__ import annotations

import argparse
import os
import pathlib

from goals import read_goals
from places import OPERATORS
from report import LEAST_JUDGED


def read_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="packaging/mutate", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Puts small faults into rooms of the house, one at a time, and tells which of them their tests do not notice.",
        epilog=f"""operators: {', '.join(OPERATORS)}

A run goes on where the last one stopped: what became of each mutant stands in build/mutants/ROOM.jsonl. A fault that no
test can notice is listed with its reason in tests/equivalent_mutants.txt. tests/MUTANTS.md has the scores.""")
    parser.add_argument("rooms", nargs="*", metavar="ROOM",
                        help="a folder, such as core/servo; without one all of packaging/mutation/rooms.txt")
    parser.add_argument("--quick", action="store_true", help="of these only rooms of which a mutant is judged quickly")
    parser.add_argument("--sample", type=int, metavar="N", help="only N of the mutants, chosen at random")
    parser.add_argument("--each", type=int, metavar="N", help="only N of each room's, chosen at random")
    parser.add_argument("--seed", default="1", help="of that choice (%(default)s)")
    parser.add_argument("--changed-since", metavar="COMMIT", help="only in lines that changed since then")
    parser.add_argument("--file", metavar="NAME", action="append", help="only in files of this name; may be repeated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="at a time (%(default)s)")
    parser.add_argument("--seconds", type=float, metavar="S", help="begin with no mutant later than that")
    parser.add_argument("--at-least", type=float, metavar="PERCENT",
                        help=f"end in 1 where fewer are noticed, of at least {LEAST_JUDGED}")
    parser.add_argument("--list", action="store_true", help="show the mutants and try none")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2],
                        help="the house, built in build/release (%(default)s)")
    options = parser.parse_args()
    options.root = options.root.resolve()
    options.goals = read_goals(options.root)
    options.rooms = [room.strip("/") for room in options.rooms] or list(options.goals)
    if options.quick:
        options.rooms = [room for room in options.rooms if room in options.goals and options.goals[room].quick]
    return options
