#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Others read what touchphoto-lab writes, so a field of JSON or a column once published stays what it is.

published_fields.txt holds commands with what came of them: `path: kinds` of JSON on stdout, `file: columns` of a table.
This runs each command on the drawn samples and fails where something of that is missing, of another kind, or in another
place of its table. What is new must be added to the list: --write does, and takes nothing away.

Usage: published_fields.py TOUCHPHOTO_LAB ROOT [--write]
"""

import json
import math
import os
import pathlib
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import wave

LIST = pathlib.Path(__file__).with_suffix(".txt")
KINDS = {bool: "yes or no", int: "number", float: "number", str: "text", type(None): "null", list: "list", dict: "object"}


def fields(value, path=""):
    """(path, kind) of everything in a value of JSON."""
    if path:
        yield path, KINDS[type(value)]
    if isinstance(value, dict):
        for name, part in value.items():
            yield from fields(part, f"{path}.{name}" if path else name)
    elif isinstance(value, list):
        for part in value:
            yield from fields(part, path + "[]")


def of_json(text):
    """{path: kinds} of lines of JSON."""
    found = {}
    for line in text.splitlines():
        for path, kind in fields(json.loads(line)):
            found.setdefault(path, set()).add(kind)
    return {path: " or ".join(sorted(kinds)) for path, kinds in found.items()}


def read_list():
    """[(command, {what: how})]"""
    commands = []
    for line in LIST.read_text(encoding="utf-8").splitlines():
        if line.startswith("$ "):
            commands.append((line[2:], {}))
        elif line and not line.startswith("#"):
            what, how = line.split(": ", 1)
            commands[-1][1][what] = how
    return commands


def write_list(commands):
    head = [line for line in LIST.read_text(encoding="utf-8").splitlines() if line.startswith("#")]
    for command, listed in commands:
        head += ["", f"$ {command}", *(f"{what}: {how}" for what, how in listed.items())]
    LIST.write_text("\n".join(head) + "\n", encoding="utf-8")


PLACE = """<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" xmlns:exif="http://ns.adobe.com/exif/1.0/" exif:GPSLatitude="48,12.5N"
exif:GPSLongitude="16,22.25E"/></rdf:RDF></x:xmpmeta>
"""
STUDY = """experiment: short
task: follow
set path: circle
set stiffness: 0.4 N/mm
factor range: 4, 8 mm
set law: published
"""


def prepare(root, out):
    """What the commands work on, beside the drawn samples."""
    (out / "album").mkdir()
    samples = root / "resources/samples"
    (out / "old").mkdir()
    for source, name in (("anna_smiling.jpg", "mended.jpg"), ("anna_smiling.truth.svg", "mended.jpg.contours.svg"),
                         ("ben_angry.jpg", "old/somewhere.jpg")):
        shutil.copy(samples / source, out / name)
    for name in ("somewhere.jpg.xmp", "gone.jpg.xmp"):  # the second belongs to no photograph
        (out / "old" / name).write_text(PLACE, encoding="utf-8")
    (out / "short.study").write_text(STUDY, encoding="utf-8")
    (out / "broken.jpg").write_bytes(b"\xff\xd8\xff no more")
    with wave.open(str(out / "sound.wav"), "wb") as file:
        file.setparams((1, 2, 8000, 0, "NONE", ""))
        file.writeframes(b"".join(struct.pack("<h", int(9000 * math.sin(i / 5))) for i in range(8000)))


def of_line(line):
    """{what: how} of the first line that is no JSON: a table's columns; of a row with numbers, what it has."""
    words = ["text" if word[0].isalpha() else "number" for word in line.split()]
    if "," in line:
        return {"columns": line}
    return {"a line": " ".join(words)} if "number" in words else {}


def run(lab, root, out, command):
    """{what: how} of what came of it. `{recording}` is the file of the only recording."""
    recording = next((path.name for path in out.glob("album/*.tags/*.flac")), "")
    words = [word.format(samples=root / "resources/samples", out=out, recording=recording) for word in shlex.split(command)]
    home = {name: str(out / "home" / name) for name in ("HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    before = set(out.rglob("*.csv")) | set(out.glob("*.json"))
    done = subprocess.run([lab, *words], capture_output=True, text=True, env={**os.environ, **home}, input="10 10\n")
    if done.returncode not in (0, 1):
        raise SystemExit(f"{command}: ended with {done.returncode}\n{done.stderr}")
    found = {}
    if done.stdout.startswith("{"):
        found = of_json(done.stdout)
    elif done.stdout:
        found = of_line(done.stdout.splitlines()[0])
    for table in sorted(set(out.rglob("*.csv")) - before):
        with table.open(encoding="utf-8") as file:
            found[table.name] = file.readline().rstrip("\n")
    for written in sorted(set(out.glob("*.json")) - before):
        found.update(of_json(json.dumps(json.loads(written.read_text(encoding="utf-8")))))
    return found


def holds(how, now):
    """Kinds may not become more, columns may only be added behind."""
    if "," in how:
        return (now + ",").startswith(how + ",")
    if " or " not in how and " " in how:
        return now == how
    return set(now.split(" or ")) <= set(how.split(" or "))


def main():
    lab, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    write = sys.argv[3:] == ["--write"]
    commands, faults, new = read_list(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder).resolve()
        prepare(root, out)
        for command, listed in commands:
            found = run(lab, root, out, command)
            for what, how in list(listed.items()):
                if what not in found:
                    faults += 1
                    print(f"{command}\n    {what} is missing")
                elif not holds(how, found[what]):
                    faults += 1
                    print(f"{command}\n    {what} was {how}\n    and is {found[what]}")
                elif "," in how:
                    listed[what] = found[what]
            for what, how in found.items():
                if what not in listed:
                    new += 1
                    print(f"{command}\n    {what} is new: {how}")
                    listed[what] = how
    if write and not faults:
        write_list(commands)
    print(f"{len(commands)} commands, {sum(len(listed) for _, listed in commands)} fields and tables, "
          f"{faults} not as published, {new} new")
    return 1 if faults or (new and not write) else 0


if __name__ == "__main__":
    sys.exit(main())
