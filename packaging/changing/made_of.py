# SPDX-License-Identifier: Apache-2.0
"""What each program of a finished build is made of, as ninja knows it."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess


def _unescaped(words: str) -> list[str]:
    return [re.sub(r"\$([ :$])", r"\1", word) for word in re.findall(r"(?:\$.|[^\s$])+", words)]


class MadeOf:
    def __init__(self, root: pathlib.Path, build: pathlib.Path):
        self.root, self.build = root, build
        self._from: dict[str, list[str]] = {}  # what is made, from what; ninja's names
        self.programs: list[str] = []
        for line in (build / "build.ninja").read_text(encoding="utf-8").splitlines():
            if not line.startswith("build "):
                continue
            made, _, rest = re.match(r"build ((?:\$.|[^:$])*)(:)\s*(.*)", line).groups()
            rule, *origins = _unescaped(rest)
            made = [name for name in _unescaped(made) if name != "|"]
            for name in made:
                self._from[name] = [origin for origin in origins if origin not in ("|", "||", "|@")]
            if "_EXECUTABLE_LINKER_" in rule:
                self.programs.append(made[0])
        self._add_headers()
        self._known: dict[str, str | None] = {}

    def _add_headers(self) -> None:
        shown = subprocess.run(["ninja", "-C", self.build, "-t", "deps"], check=True,
                               capture_output=True, text=True)
        objects: list[str] = []
        for line in shown.stdout.splitlines():
            if not line.startswith(" "):
                objects = self._from.setdefault(line.split(": #deps", 1)[0], [])
            elif line and (not line.startswith("    /") or line.startswith(f"    {self.root}/")):
                objects.append(line.strip())

    def sources(self, program: str) -> set[str]:
        """The files of the tree that it is made of, relative to the root."""
        seen = {program}
        ahead = [program]
        files = set()
        while ahead:
            name = ahead.pop()
            if (file := self._in_tree(name)) is not None:
                files.add(file)
            for origin in self._from.get(name, ()):
                if origin not in seen:
                    seen.add(origin)
                    ahead.append(origin)
        return files

    def _in_tree(self, name: str) -> str | None:
        """None for what the build has made, and what is not ours. Headers are found through links (cmake/House.cmake)."""
        if name not in self._known:
            path = os.path.realpath(os.path.join(self.build, name))
            inside = path.startswith(f"{self.root}/") and not path.startswith(f"{self.root}/build/")
            self._known[name] = os.path.relpath(path, self.root) if inside else None
        return self._known[name]
