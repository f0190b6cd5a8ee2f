# SPDX-License-Identifier: Apache-2.0
"""What a finished build knows of a room: how its files are compiled, how its tests are linked and run."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
import re
import shlex
import subprocess
from collections.abc import Iterable


class NoSuchRoom(Exception):
    pass


@dataclasses.dataclass
class Test:
    name: str
    objects: dict[str, pathlib.Path]  # of its own sources, as they are linked
    link: list[str]  # the command that links it
    environment: dict[str, str]
    arguments: list[str]  # of its program: which of its tests to run
    sources: list[str] = dataclasses.field(default_factory=list)


class Program:
    def __init__(self, root: pathlib.Path, build: pathlib.Path):
        self.root = root
        self.build = build
        entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
        self._commands = {entry["file"]: shlex.split(entry["command"]) for entry in entries}
        self._one_of: dict[str, str] = {}  # a file that is compiled with others: what includes them
        self._batches: dict[str, list[str]] = {}
        for unit in self._commands:
            if "/Unity/unity_" in unit:
                self._batches[unit] = re.findall(r'^#include "(.+)"', pathlib.Path(unit).read_text(encoding="utf-8"), re.M)
                for file in self._batches[unit]:
                    self._one_of[file] = unit

    def sources(self, room: str) -> list[str]:
        """The files of the room that can be mutated, relative to the root."""
        folder = self.root / room
        if not folder.is_dir():
            raise NoSuchRoom(f"There is no {room}.")
        files = sorted(path.name for path in folder.iterdir() if path.suffix in (".cpp", ".hpp"))
        compiled = [f"{room}/{name}" for name in files if self.is_compiled(f"{room}/{name}")]
        if not compiled:
            raise NoSuchRoom(f"Nothing of {room} is compiled in {self.build}.")
        return sorted(compiled + [f"{room}/{name}" for name in files if name.endswith(".hpp")])

    def is_compiled(self, file: str) -> bool:
        path = str(self.root / file)
        return path in self._commands or path in self._one_of

    def compile_command(self, file: str) -> list[str]:
        """How the file alone is compiled, without its output and its input; nothing is warned of."""
        path = str(self.root / file) if not os.path.isabs(file) else file
        command = self._commands[path if path in self._commands else self._one_of[path]]
        kept = []
        skip = False
        for word in command:
            if skip or word in ("-c", "-o"):
                skip = not skip
            elif word not in ("-Werror", "ccache"):
                kept.append(word)
        return [*kept, "-w"]

    def parse_flags(self, file: str) -> list[str]:
        """What a parser must know of a room's file, or of a header of the room."""
        if file.endswith(".hpp"):
            file = next(other for other in self.sources(os.path.dirname(file)) if other.endswith(".cpp"))
        words = self.compile_command(file)
        flags = [word for word in words if re.match(r"-(I|D|std=)", word)]
        return flags + [word for index, value in enumerate(words) if value == "-isystem"
                        for word in (value, words[index + 1])]

    def replaced_files(self, room: str) -> list[str]:
        """All files, with their path, that must be compiled one by one so that the room's can be exchanged."""
        files = set()
        for name in self.sources(room):
            path = str(self.root / name)
            if path in self._one_of:
                files.update(self._batches[self._one_of[path]])
            elif path in self._commands:
                files.add(path)
        return sorted(files)

    def archive_of(self, file: str) -> str:
        """The name of the library that a room's source, with its path, is compiled into."""
        command = self._commands[self._one_of.get(file, file)]
        target = re.search(r"CMakeFiles/([^/]+)\.dir/", command[command.index("-o") + 1])
        return f"lib{target.group(1)}.a" if target else ""

    def whole_archives(self, files: Iterable[str]) -> set[str]:
        """The names of the libraries of which these sources, with their path, are all."""
        units = {self._one_of.get(file, file) for file in files}
        return {self.archive_of(unit) for unit in units} - {
            self.archive_of(unit) for unit in self._commands if unit not in units and "/cmake_pch." not in unit}

    def programs_beside(self, test: Test) -> list[pathlib.Path]:
        """Those other than tests that the test's program finds beside itself."""
        folder = (self.build / self.target(test)).parent
        return [path for path in folder.iterdir()
                if path.is_file() and os.access(path, os.X_OK) and not path.name.startswith("test_")]

    def tests_folder(self, room: str) -> str:
        """tests/ROOM; a room within a room, such as a device's protocol, is tested with the one around it."""
        folder = room
        while folder and not (self.root / "tests" / folder / "CMakeLists.txt").is_file():
            folder = os.path.dirname(folder)
        if not folder:
            raise NoSuchRoom(f"{room} has no tests in tests/{room}.")
        return f"tests/{folder}"

    def tests(self, room: str) -> list[Test]:
        """The room's own."""
        folder = self.tests_folder(room)
        shown = subprocess.run(["ctest", "--test-dir", self.build, "--show-only=json-v1"], check=True,
                               capture_output=True, text=True)
        found = []
        for test in json.loads(shown.stdout)["tests"]:
            command = test.get("command", [])
            if len(command) < 2 or not command[0].endswith("/run_test"):
                continue
            executable = pathlib.Path(command[1])
            if executable.parent != self.build / folder:
                continue
            properties = {entry["name"]: entry["value"] for entry in test["properties"]}
            environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
            link = self._link_command(executable)
            objects = {word: self.build / word for word in link if word.startswith("tests/") and word.endswith(".o")}
            found.append(Test(test["name"], objects, link, environment, command[2:]))
        if not found:
            raise NoSuchRoom(f"{room} has no tests in {folder}.")
        return found

    def target(self, test: Test) -> str:
        return test.link[test.link.index("-o") + 1]

    def _link_command(self, executable: pathlib.Path) -> list[str]:
        shown = subprocess.run(["ninja", "-C", self.build, "-t", "commands", executable.relative_to(self.build)],
                               check=True, capture_output=True, text=True)
        line = shown.stdout.strip().splitlines()[-1]
        return shlex.split(line.split(": && ", 1)[1].rsplit(" && :", 1)[0])

    def source_of(self, test_object: str) -> str:
        """tests/core/servo/CMakeFiles/T.dir/X.cpp.o is made of tests/core/servo/X.cpp; what the build wrote, of that with its path."""
        folder, rest = test_object.split("/CMakeFiles/", 1)
        source = os.path.normpath(f"{folder}/{rest.split('.dir/', 1)[1].removesuffix('.o')}")
        return source if (self.root / source).exists() else str(self.build / source)

    def headers_of(self, test_object: str) -> set[str]:
        """The files that this object was made of, by their real path."""
        shown = subprocess.run(["ninja", "-C", self.build, "-t", "deps", test_object], check=True,
                               capture_output=True, text=True)
        return {os.path.realpath(self.build / line.strip()) for line in shown.stdout.splitlines()[1:] if line.strip()}
