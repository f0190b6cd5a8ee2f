# SPDX-License-Identifier: Apache-2.0
"""What a run says: how far it is, and what came out."""

from __future__ import annotations

import collections
import sys
import threading
import time

from record import NOTICED, SAME, SURVIVED, UNBUILDABLE

LISTED = "listed as equivalent"
LEAST_JUDGED = 20  # fewer say nothing about a share


class Progress:
    """A line that is written over on a terminal, and one now and then elsewhere."""

    def __init__(self, room: str, count: int):
        self._room = room
        self._count = count
        self._done = 0
        self._noticed = 0
        self._survived = 0
        self._begun = time.monotonic()
        self._said = self._begun
        self._lock = threading.Lock()

    def step(self, entry: dict) -> None:
        with self._lock:
            self._done += 1
            self._noticed += entry["result"] == NOTICED
            self._survived += entry["result"] == SURVIVED
            now = time.monotonic()
            terminal = sys.stderr.isatty()
            if not terminal and now - self._said < 20.0 and self._done < self._count:
                return
            self._said = now
            left = (now - self._begun) / self._done * (self._count - self._done)
            text = (f"{self._room}: {self._done} of {self._count} mutants, {self._noticed} noticed, "
                    f"{self._survived} not, about {_duration(left)} left")
            print(f"\r\x1b[K{text}" if terminal else text, end="" if terminal else "\n", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._done and sys.stderr.isatty():
            print(file=sys.stderr)


def _duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 90.0 else f"{seconds / 60.0:.0f} min"


def judged(results: list[str]) -> tuple[int, int]:
    """How many were noticed, and of how many: what does not compile, is the same or is equivalent does not count."""
    noticed = results.count(NOTICED)
    return noticed, noticed + results.count(SURVIVED)


def share(results: list[str]) -> float:
    noticed, of = judged(results)
    return 100.0 * noticed / of if of else 100.0


def is_enough(results: list[str], at_least: float) -> bool:
    return judged(results)[1] < LEAST_JUDGED or share(results) >= at_least


def summary(name: str, results: list[str], not_tried: int, goal: float | None = None) -> str:
    """`goal`: how many per cent are to be noticed, where that is known."""
    noticed, of = judged(results)
    counts = collections.Counter(results)
    besides = [] if goal is None else [f"goal {goal:g} %" + ("" if share(results) >= goal else ", not met")]
    besides += [f"{counts[kind]} {words}" for kind, words in (
        (UNBUILDABLE, "do not compile"), (SAME, "make the same program"), (LISTED, LISTED)) if counts[kind]]
    if not_tried:
        besides.append(f"{not_tried} not tried")
    return (f"{name}: {noticed} of {of} mutants noticed, {share(results):.1f} %"
            + (f" ({', '.join(besides)})" if besides else ""))


def survivor(entry: dict) -> str:
    return "\n".join([f"{entry['file']}:{entry['line']} ({entry['operator']})",
                      *(f"    {line}" for line in entry["difference"])])
