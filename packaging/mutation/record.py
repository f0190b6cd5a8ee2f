# SPDX-License-Identifier: Apache-2.0
"""What was found out about each mutant, a line of JSON each, so that a run goes on where another stopped."""

from __future__ import annotations

import json
import pathlib
import threading

from mutant import Mutant

NOTICED, SURVIVED, UNBUILDABLE, SAME = "noticed", "survived", "does not compile", "same program"


class Record:
    def __init__(self, path: pathlib.Path, tests: str):
        """`tests` names the tests as they are: what survived other tests is judged again."""
        self._path = path
        self._tests = tests
        self._lock = threading.Lock()
        self._known: dict[str, dict] = {}
        if path.exists():
            for line in path.read_text(encoding="utf-8").splitlines():
                try:
                    entry = json.loads(line)
                except json.JSONDecodeError:  # the end of a run that was killed
                    continue
                self._known[entry["key"]] = entry

    def known(self, mutant: Mutant, content: bytes) -> dict | None:
        entry = self._known.get(mutant.key(content))
        if entry and entry["result"] == SURVIVED and entry["tests"] != self._tests:
            return None
        return entry

    def add(self, mutant: Mutant, content: bytes, result: str, by: str, seconds: float) -> dict:
        entry = {"key": mutant.key(content), "result": result, "by": by, "seconds": round(seconds, 2),
                 "tests": self._tests, **mutant.shown(content)}
        with self._lock:
            self._known[entry["key"]] = entry
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with self._path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(entry, ensure_ascii=False) + "\n")
        return entry
