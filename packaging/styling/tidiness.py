# SPDX-License-Identifier: Apache-2.0
"""What clang-tidy says of changed lines."""

import concurrent.futures
import json
import os
import re
import subprocess
import time

from layout import ranges
from program import NoSuchRoom

ROOMS = ("app/", "core/", "device/", "audio/", "faces/")
SAID = re.compile(r"^(?P<file>/.+?):(?P<line>\d+):\d+: (?:warning|error): (?P<what>.+)$")


def sources_to_ask(program, changes):
    """What must be looked through to see the changes of the rooms, most changes first, each with the flags that it is
    compiled with; and the files that are not compiled here. A header is seen with the source of its name, or alone."""
    flags, count, unseen = {}, {}, []
    for name, lines in changes.items():
        if not name.startswith(ROOMS):
            continue
        if re.search(r"_(windows|macos)\.hpp$", name):
            unseen.append(name)
            continue
        source = re.sub(r"\.hpp$", ".cpp", name)
        try:
            if source != name and not program.is_compiled(source):
                source = name
            # Flags that both compilers know: which folders, which macros, which language.
            flags[source] = [*program.parse_flags(source), "-fPIC", "-xc++"]
        except (KeyError, StopIteration, NoSuchRoom):
            unseen.append(name)
            continue
        count[source] = count.get(source, 0) + len(lines)
    return [(source, flags[source]) for source in sorted(count, key=lambda source: (-count[source], source))], unseen


def line_filter(root, changes):
    return json.dumps([{"name": str(root / name), "lines": ranges(lines)} for name, lines in changes.items()])


def look_through(root, sources, changes, seconds):
    """What clang-tidy warns of in changed lines, each once; and the sources for which there was no time."""
    end = time.monotonic() + seconds
    only = line_filter(root, changes)

    def ask(source, flags):
        left = end - time.monotonic()
        if left <= 0:
            return None
        try:
            return subprocess.run(["clang-tidy-14", "--quiet", f"--line-filter={only}", str(root / source), "--", *flags],
                                  capture_output=True, text=True, errors="replace", timeout=left).stdout
        except subprocess.TimeoutExpired:
            return None

    found, left_out = {}, []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        answers = workers.map(lambda asked: ask(*asked), sources)
        for (source, _), answer in zip(sources, answers):
            if answer is None:
                left_out.append(source)
                continue
            for said in filter(None, map(SAID.match, answer.splitlines())):
                name = os.path.relpath(os.path.realpath(said["file"]), root)
                found[f"{name}:{said['line']}: {said['what']}"] = None
    return list(found), left_out
