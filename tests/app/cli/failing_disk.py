#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs every verb that touches an album on a disk that fails at one of its calls, reading or writing, once or from then on;
and those that look at all of it where one file or folder is bad. The verb ends by itself with a sentence, nothing is lost, and
what it says is done is done.

    failing_disk.py LAB LIBRARY SAMPLES [--each N] [--seed S] [--verb NAME] [--way WAY] [--all] [--jobs J]

LAB is touchphoto-lab, LIBRARY tests/support/failing_files.cpp built, SAMPLES a folder of photographs. Of each verb N calls are
tried in each way (--all: every one), and of those about a file of CLOSELY every one. What went wrong is told with the verb and the
fault, which can be tried again: --verb NAME --fault FAULT, "EIO@12", "EIO@1 on album/one.jpg" (its bytes) or "EIO-once@2 of
album/one.jpg" (the second call about it).
"""
import argparse
import difflib
import hashlib
import json
import os
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PATIENCE_S = 120
WAYS = ("EIO-once", "EIO")
MENDING = {"check --mend": "album", "check --mend, a recording that was cut off": "cut"}  # in which folder
CLOSELY = {"trash restore": "album/.touchphoto/trash/{trashed}/0", "export": "album/one.jpg.tags"}
LOOKING_AT_ALL = {**MENDING, "scan": "album", "export": "album", "person rename": "album", "search": "album"}


def wav(seconds: float) -> bytes:
    samples = b"".join(struct.pack("<h", (i * 7919) % 20000 - 10000) for i in range(int(seconds * 8000)))
    return (b"RIFF" + struct.pack("<I", 36 + len(samples)) + b"WAVEfmt " + struct.pack("<IHHIIHH", 16, 1, 1, 8000, 16000, 2, 16)
            + b"data" + struct.pack("<I", len(samples)) + samples)


def verbs(disk, file, trashed):
    """Name to words; each begins on the same disk."""
    album = f"{disk}/album"
    one, two, three = (f"{album}/{name}" for name in ("one.jpg", "two.jpg", "sub/three.jpg"))
    memo, results = f"{disk}/memo.wav", f"{disk}/results"
    return {
        "scan": ["album", "scan", album],
        "rebuild": ["album", "rebuild", album],
        "list": ["album", "list", album],
        "search": ["album", "search", album, "anna"],
        "show": ["album", "show", one],
        "check": ["album", "check", album],
        "check --mend": ["album", "check", album, "--mend"],
        "check --mend, a recording that was cut off": ["album", "check", f"{disk}/cut", "--mend"],
        "import": ["album", "import", album, f"{disk}/card"],
        "import a bundle": ["album", "import", album, f"{disk}/b.touchphoto"],
        "export": ["album", "export", album, "--to", f"{results}/all.touchphoto"],
        "export into the album": ["album", "export", album, one, "--to", f"{album}/one.touchphoto"],
        "tag list": ["album", "tag", "list", one],
        "tag add": ["album", "tag", "add", one, "--from", memo, "--kind", "story"],
        "tag add, the first": ["album", "tag", "add", two, "--from", memo, "--kind", "memo"],
        "tag label": ["album", "tag", "label", one, file, "--person", "Otto", "--transcript", "text"],
        "tag order": ["album", "tag", "order", one, file],
        "tag trim": ["album", "tag", "trim", one, file, "--end", "0.1"],
        "tag delete": ["album", "tag", "delete", one, file],
        "person list": ["album", "person", "list", album],
        "person name": ["album", "person", "name", two, "Anna", "--face", "0.5,0.5,0.2,0.3"],
        "person rename": ["album", "person", "rename", album, "Anna", "Berta"],
        "person record": ["album", "person", "record", album, "Otto", "--from", memo],
        "person language": ["album", "person", "language", album, "Anna", "de"],
        "trash list": ["album", "trash", "list", album],
        "trash restore": ["album", "trash", "restore", album, trashed],
        "trash empty": ["album", "trash", "empty", album, "--yes"],
        "faces": ["faces", one],
        "faces --svg": ["faces", three, "--svg", f"{album}/sub", "--overlay", f"{album}/sub"],
        "scene": ["scene", three, "--out", f"{album}/scene.svg"],
        "tactile": ["tactile", three, f"{album}/sheet.svg"],
        "correction": ["correction", one],
        "field": ["field", "--scene", f"{album}/drawn.svg", "--out", f"{album}/field.png"],
        "force": ["force", "--scene", f"{album}/drawn.svg"],
        "friction": ["friction", "--scene", f"{album}/drawn.svg", "--out", f"{album}/friction.png"],
        "trace": ["trace", "--scene", f"{album}/drawn.svg", "--out", f"{album}/trace", "--seconds", "1"],
        "study simulate": ["study", "simulate", "1", "--participants", "1", "--out", f"{album}/study"],
    }


def content_of(path: Path) -> str:
    """Of a recording its sound, which stays where its comments change: the MD5 of its samples (FLAC format, STREAMINFO)."""
    content = path.read_bytes()
    if content[:4] == b"RIFF":
        return hashlib.md5(content[44:]).hexdigest()
    return content[26:42].hex() if content[:4] == b"fLaC" else hashlib.sha256(content).hexdigest()


def state_of(folder: Path) -> dict:
    return {str(path.relative_to(folder)): content_of(path) for path in sorted(folder.rglob("*")) if path.is_file()}


class Lab:
    def __init__(self, program, library):
        self.program, self.library = program, library

    def run(self, words, place: Path, below=None, fault=None, count=None, reads="all"):
        environment = dict(os.environ, XDG_CACHE_HOME=f"{place}/cache", XDG_STATE_HOME=f"{place}/state", LC_ALL="C.UTF-8")
        if fault:
            environment.update(LD_PRELOAD=self.library.name, LD_LIBRARY_PATH=str(self.library.parent), TP_FAULT=fault,
                               TP_FAULT_READS=reads, TP_FAULT_BELOW=str(below))
            if count:
                environment["TP_FAULT_COUNT"] = str(count)
        return subprocess.run([self.program, *map(str, words)], env=environment, input=b"1 2\n", capture_output=True,
                              timeout=PATIENCE_S, check=False)


def normal(text: str) -> str:
    """Without times and the names that are made of them."""
    return re.sub(r"\d{4}-\d\d-\d\dT[0-9.:]+(Z|[+-]\d\d:\d\d)?(-\d+)?|[0-9a-f]{64}", "TIME", text)


def seen(lab: Lab, place: Path) -> str:
    """What is known of the album's photographs, and what it holds."""
    album = place / "disk"
    text = "\n".join(sorted(normal(str(path.relative_to(album))) for path in album.rglob("*")
                            if path.is_file() and path.suffix in (".jpg", ".flac", ".svg", ".png", ".csv", ".xmp")))
    for bundle in sorted(album.glob("results/*.touchphoto")):
        text += "".join(f"\n{normal(packed.filename)}: {packed.file_size}" for packed in zipfile.ZipFile(bundle).infolist())
    for photo in sorted([*album.glob("album/**/*.jpg"), *album.glob("cut/*.jpg")]):
        shown = lab.run(["album", "show", photo, "--json"], place)
        told = "\n".join(line for line in shown.stderr.decode().splitlines() if not line.startswith("…"))
        text += "\n" + normal((shown.stdout.decode() + told).replace(str(place), "")).replace(",", ",\n")
    return text


class World:
    """A disk with an album, a card, a bundle and a sound, made once and copied for each run."""

    def __init__(self, lab: Lab, samples: Path, place: Path):
        self.lab, self.place = lab, place
        disk, album = place / "disk", place / "disk/album"
        for folder in (album / "sub", disk / "card", disk / "results", disk / "other"):
            folder.mkdir(parents=True)
        for name, to in (("anna_smiling", album / "one.jpg"), ("ben_smiling", album / "two.jpg"),
                         ("clara_sad", album / "sub/three.jpg"), ("ben_angry", disk / "card/four.jpg"),
                         ("anna_sad", disk / "other/five.jpg")):
            shutil.copyfile(samples / f"{name}.jpg", to)
        (disk / "memo.wav").write_bytes(wav(0.3))
        self.made("album", "tag", "add", album / "one.jpg", "--from", disk / "memo.wav", "--kind", "memo", "--person", "Anna")
        self.file = next((album / "one.jpg.tags").iterdir()).name
        self.made("album", "tag", "add", album / "sub/three.jpg", "--from", disk / "memo.wav", "--kind", "memo")
        self.made("album", "tag", "add", album / "two.jpg", "--from", disk / "memo.wav", "--kind", "memo")
        self.made("album", "tag", "delete", album / "two.jpg", next((album / "two.jpg.tags").iterdir()).name)
        self.trashed = next((album / ".touchphoto/trash").iterdir()).name
        self.made("album", "person", "record", album, "Anna", "--from", disk / "memo.wav")
        self.made("album", "tag", "add", disk / "other/five.jpg", "--from", disk / "memo.wav", "--kind", "story")
        self.made("album", "export", disk / "other", "--to", disk / "b.touchphoto")
        self.made("faces", album / "one.jpg", "--svg", album)
        self.made("album", "person", "name", album / "one.jpg", "Anna", "--face", "0.5,0.5,0.2,0.3")
        (album / "drawn.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">'
                                         '<path id="mouth" d="M10 20 L50 20"/></svg>', encoding="utf-8")
        (disk / "cut/one.jpg.tags").mkdir(parents=True)
        shutil.copyfile(samples / "anna_angry.jpg", disk / "cut/one.jpg")
        shutil.copyfile(disk / "memo.wav", disk / "cut/one.jpg.tags/2026-05-01T101500-memo.wav.part")
        # A sidecar that a program was killed replacing, which another program may have written.
        (disk / "cut/.touchphoto-999999999-0.tmp").write_bytes((album / "one.jpg.xmp").read_bytes() + b"\n")
        self.made("album", "scan", album)

    def made(self, *words):
        run = self.lab.run(words, self.place)
        if run.returncode != 0:
            raise SystemExit(f"the album cannot be made: {run.stderr.decode()}")

    def copy(self, to: Path) -> Path:
        shutil.copytree(self.place, to, symlinks=True)
        return to


class Trial:
    """One verb under one fault; `wrong` says what is wrong with what came of it."""

    def __init__(self, world: World, name: str, fault: str, expected: str, changes: bool):
        self.world, self.lab, self.name, self.fault = world, world.lab, name, fault
        self.expected, self.changes = expected, changes  # what is seen where the disk works, and whether the album is another then

    def wrong(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            place = self.world.copy(Path(folder) / "w")
            try:
                return self.wrong_in(place)
            except subprocess.TimeoutExpired:
                return "it hangs"

    def wrong_in(self, place: Path) -> str:
        album = place / "disk/album"
        before = state_of(place / "disk")
        words = verbs(place / "disk", self.world.file, self.world.trashed)[self.name]
        fault, about, file = re.fullmatch(r"(\S+)(?: (on|of) (.*))?", self.fault).groups()
        run = self.lab.run(words, place, below=place / "disk" / (file or ""), fault=fault, reads="bytes" if about == "on" else "all")
        said = [line for line in run.stderr.decode(errors="replace").splitlines() if line and not line.startswith("…")]
        if run.returncode not in (0, 1):
            return f"it ended with {run.returncode}: {said[-3:]}"
        if run.returncode == 1 and not said and not self.name.startswith("check"):
            return "it failed without a word"
        if run.returncode == 1 and not all(re.search(r"[.:)]$", line) for line in said):
            return f"no sentence: {said}"
        after = state_of(place / "disk")
        if after == before and (run.returncode == 1 or not self.changes):
            return ""
        kept = set(after.values())
        for path, content in before.items():
            if content not in kept and path.endswith((".jpg", ".flac", ".part", ".tmp")) and self.name not in ("trash empty", "person record"):
                return f"{path} is lost: {said}"
        self.lab.run(["album", "import", album, "--continue"], place)
        self.lab.run(["album", "check", album, "--mend"], place)
        left = self.lab.run(["album", "check", album, "--json"], place)
        findings = [f for f in json.loads(left.stdout)["findings"] if "who is on no photograph" not in f["sentence"]]
        if findings:
            return f"left after mending: {findings[0]['sentence']}"
        for path, content in before.items():
            if path.endswith(".jpg") and state_of(place / "disk").get(path) != content:
                return f"{path} is another"
        if run.returncode == 0 and not said and seen(self.lab, place) != self.expected:
            lines = difflib.unified_diff(self.expected.splitlines(), seen(self.lab, place).splitlines(), n=0, lineterm="")
            return f"it says that it is done: {[line[:300] for line in lines][3:12]}"
        return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lab")
    parser.add_argument("library", type=Path)
    parser.add_argument("samples", type=Path)
    parser.add_argument("--each", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--verb")
    parser.add_argument("--fault")
    parser.add_argument("--way")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    chance = random.Random(asked.seed)
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(asked.lab, asked.library.resolve())
        world = World(lab, asked.samples, Path(folder) / "made")
        tried, unchanged = 0, seen(lab, world.place)
        for name in verbs("", "", ""):
            if asked.verb and name != asked.verb:
                continue
            place = Path(folder) / "counted"
            count = Path(folder) / "calls"
            before = state_of(place / "disk")
            closely = CLOSELY.get(name, "").format(trashed=world.trashed)
            counted = {}
            for below in {closely, ""} if asked.way is None else {""}:
                shutil.rmtree(place, ignore_errors=True)
                world.copy(place)
                run = lab.run(verbs(place / "disk", world.file, world.trashed)[name], place, below=place / "disk" / below,
                              fault="none@1", count=count)
                if run.returncode != 0:
                    raise SystemExit(f"{name}: ends with {run.returncode} on a disk that works: {run.stderr.decode()}")
                counted[below] = int(count.read_text())
            calls = counted[""]
            changes = state_of(place / "disk") != before
            expected = seen(lab, place) if changes else unchanged
            shutil.rmtree(place)
            chosen = range(1, calls + 1) if asked.all else sorted(chance.sample(range(1, calls + 1), min(asked.each, calls)))
            plans = [asked.fault] if asked.fault else [f"{way}@{at}" for way in WAYS for at in chosen if asked.way in (None, way)]
            looked_at = (LOOKING_AT_ALL if asked.way is None else MENDING).get(name)
            if looked_at and not asked.fault:
                plans += [f"EIO@1 on {path.relative_to(world.place / 'disk')}"
                          for path in sorted((world.place / "disk" / looked_at).rglob("*"))]
            if closely in counted and closely and not asked.fault:
                plans += [f"EIO-once@{at} of {closely}" for at in range(1, counted[closely] + 1)]
            print(f"{name}: {calls} calls, {len(plans)} tried", flush=True)
            trials = [Trial(world, name, plan, expected, changes) for plan in plans]
            with ThreadPoolExecutor(asked.jobs) as pool:
                for trial, wrong in zip(trials, pool.map(Trial.wrong, trials)):
                    if wrong:
                        faults += 1
                        print(f"  {trial.fault}: {wrong}", flush=True)
            tried += len(trials)
    print(f"{tried} runs, {faults} wrong")
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
