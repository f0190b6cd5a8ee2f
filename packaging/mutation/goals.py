# SPDX-License-Identifier: Apache-2.0
"""The rooms whose tests must be sharp, and how sharp."""

from __future__ import annotations

import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Goal:
    percent: float  # of the mutants that are to be noticed
    quick: bool  # a mutant is judged so quickly that packaging/test tries some


def read_goals(root: pathlib.Path) -> dict[str, Goal]:
    """By room, as packaging/mutation/rooms.txt lists them; none where a house has no such list."""
    path = root / "packaging/mutation/rooms.txt"
    if not path.is_file():
        return {}
    goals = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            room, percent, *rest = line.split()
            goals[room] = Goal(float(percent), rest == ["quick"])
    return goals
