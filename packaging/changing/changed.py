# SPDX-License-Identifier: Apache-2.0
"""Which programs of a finished build are made of something that is other than at some commit, or read it; which tests have
changed themselves, or their room has; which programs tests run at all.

changed.py fuzzers BUILD COMMIT         the fuzzers that are
changed.py left-out BUILD COMMIT TURN   the tests that have not, and whose turn it is not; TURN is a number, by which another
                                        third of such tests is run each time; a third of those that have, where they
                                        are more than 300
changed.py unreached BUILD COMMIT LABEL the tests with that label that run nothing of what changed
changed.py run-by BUILD CTEST-OPTION…   the programs that the tests run which CTest chooses by these options; the build need
                                        not be finished
"""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import sys
import zlib

from made_of import MadeOf

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

MANY = 300  # tests that changed; more took CI longer than half an hour

CODE = (".cpp", ".hpp", ".c", ".h", ".inc")
COMPILED = (*CODE, ".qml", ".ts")  # and read by nothing else; all else may be read in its place too
UNREAD = (".md", ".py")  # by what is compiled
ELSEWHERE = ("docs/", "packaging/", ".github/", ".ci/", "tests/house/", "tests/e2e/", "cmake/House.cmake")  # the same


def folder_that_reads(file: str, folders: set[str]) -> str:
    """Data, or a file that says how to build, counts for all that is compiled below the next folder above it in which there
    is code; at last for everything."""
    folder = os.path.dirname(file)
    while folder and folder not in folders:
        folder = os.path.dirname(folder)
    return folder


def folders_of(files: set[str]) -> set[str]:
    found = set()
    for file in files:
        folder = os.path.dirname(file)
        while folder and folder not in found:
            found.add(folder)
            folder = os.path.dirname(folder)
    return found


def changed_files(root: pathlib.Path, since: str) -> set[str]:
    """Those that came, went or are others, committed or not."""
    shown = subprocess.run(["git", "-C", root, "diff", "--name-only", "--no-renames", "-z", since, "--"],
                           check=True, capture_output=True, text=True)
    return set(shown.stdout.split("\0")) - {""}


def changed_programs(sources: dict[str, set[str]], changes: set[str]) -> set[str]:
    """`sources`: of each program, the files that it is made of."""
    folders = {program: folders_of({file for file in files if file.endswith(CODE)}) for program, files in sources.items()}
    compiled_in = set().union(*folders.values())
    data = {folder_that_reads(file, compiled_in) for file in changes
            if not file.endswith(COMPILED + UNREAD) and not file.startswith(ELSEWHERE)}
    return {program for program, files in sources.items()
            if "" in data or files & changes or data & folders[program]}


def changed_tests(sources: dict[str, set[str]], changes: set[str]) -> set[str]:
    """Those of the programs whose own sources are others, with what they share with the tests beside and below them, or whose
    own room is: that of tests/core/servo is core/servo. A program that is no test counts as in changed_programs."""
    found = set()
    for program in changed_programs(sources, changes):
        folder = os.path.dirname(program)
        room = folder.removeprefix("tests/")
        if room == folder or any(is_own(file, folder, room, sources[program]) for file in changes):
            found.add(program)
    return found


def is_own(file: str, folder: str, room: str, sources: set[str]) -> bool:
    if file.startswith("tests/"):
        where = os.path.dirname(file)
        shared = file in sources and f"{folder}/".startswith(f"{where}/")
        return shared or file.startswith(f"{folder}/") and not file.endswith(COMPILED + UNREAD)
    return file.startswith(f"{room}/")


def third_of(name: str) -> int:
    """0, 1 or 2; the same for the same name for ever."""
    return zlib.crc32(name.encode()) % 3


def left_out(tests: dict[str, list[str]], programs: set[str], changed: set[str], turn: int) -> list[str]:
    """`tests`: of each, the words of its command. One that runs no program of ours is never left out; nor is one that
    changed, but for a third where more than MANY did."""
    runs = {name: programs & set(words) for name, words in tests.items()}
    own = {name for name in tests if runs[name] & changed}
    rests = (turn + 1) % 3 if len(own) > MANY else None
    return [name for name in tests if runs[name] and
            (third_of(name) == rests if name in own else third_of(name) != turn % 3)]


def unreached(tests: dict[str, list[str]], programs: set[str], changed: set[str]) -> list[str]:
    """One that runs no program of ours is reached by everything."""
    return [name for name, words in tests.items() if programs & set(words) and not changed & set(words)]


def run_by(tests: dict[str, list[str]], programs: set[str]) -> set[str]:
    return programs & {word for words in tests.values() for word in words}


def tests_of(build: pathlib.Path, *options: str) -> dict[str, list[str]]:
    shown = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", *options], check=True, capture_output=True,
                           text=True)
    return {test["name"]: [word.removeprefix(f"{build}/") for word in test.get("command", [])]
            for test in json.loads(shown.stdout)["tests"]}


def main() -> int:
    asked, *words = sys.argv[1:] or [""]
    if len(words) != {"fuzzers": 2, "left-out": 3, "unreached": 3, "run-by": max(len(words), 2)}.get(asked):
        sys.exit(__doc__)
    build = pathlib.Path(words[0]).resolve()
    made_of = MadeOf(ROOT, build)
    if asked == "run-by":
        names = sorted(run_by(tests_of(build, *words[1:]), set(made_of.programs)))
    else:
        sources = {program: made_of.sources(program) for program in made_of.programs}
        changes = changed_files(ROOT, words[1])
        if asked == "fuzzers":
            names = sorted(program.removeprefix("fuzz/") for program in changed_programs(sources, changes)
                           if program.startswith("fuzz/"))
        elif asked == "unreached":
            names = unreached(tests_of(build, "-L", f"^{words[2]}$"), set(sources), changed_programs(sources, changes))
        else:
            names = left_out(tests_of(build), set(sources), changed_tests(sources, changes), int(words[2]))
    sys.stdout.writelines(f"{name}\n" for name in names)
    return 0


if __name__ == "__main__":
    sys.exit(main())
