#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the sample portraits and writes the exact contours of each beside it."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

try:
    import cv2
    import numpy as np
except ModuleNotFoundError as missing:
    print(f"this Python has no {missing.name}; on Debian: apt-get install python3-numpy python3-opencv", file=sys.stderr)
    sys.exit(2)

from portrait.crowd import crowd
from portrait.scene import SCENES, Scene, render, truth_svg

HERE = Path(__file__).resolve().parent
JPEG_QUALITY = 92
TOLERANCE = 0.6  # mean difference of 8-bit values that another OpenCV or JPEG library may cause


def arguments() -> argparse.Namespace:
    """What was asked for on the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        epilog="Each picture NAME.jpg gets NAME.truth.svg: eyes, lips and outline as drawn, in pixels of the picture, "
        "left and right being the person's own. Needs numpy and OpenCV for Python; the result is the same every time.")
    parser.add_argument("--out", type=Path, default=HERE, metavar="DIR",
                        help="folder for pictures and truth (default: the program's own)")
    parser.add_argument("--only", metavar="NAME", help="just the picture of this name")
    parser.add_argument("--check", action="store_true",
                        help="write nothing; exit 1 with the reasons where the files in DIR are not what would be drawn")
    parser.add_argument("--crowd", type=int, metavar="N",
                        help="instead, N people who differ as people do, each with every expression; needs --out")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="another crowd for another seed (default: 1)")
    parser.add_argument("--contours-only", action="store_true", help="no pictures, which take a second or two each")
    options = parser.parse_args()
    if options.crowd is not None:
        if options.crowd < 1 or options.seed < 0:
            parser.error("--crowd needs a number above zero, and --seed one that is not below zero")
        if options.out == HERE or options.check:
            parser.error("--crowd needs --out DIR, another folder than the sample portraits', and nothing to check")
    return options


def encoded(scene: Scene) -> np.ndarray:
    """The picture's JPEG file as bytes."""
    ok, data = cv2.imencode(".jpg", render(scene), [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    if not ok:
        raise RuntimeError(f"{scene.name}: OpenCV could not encode the picture as JPEG")
    return data


def write(scene: Scene, folder: Path, picture: bool) -> None:
    """The truth of one scene, and its picture if wanted; makes the folder where it is missing."""
    folder.mkdir(parents=True, exist_ok=True)
    if picture:
        (folder / f"{scene.name}.jpg").write_bytes(encoded(scene).tobytes())
    (folder / f"{scene.name}.truth.svg").write_text(truth_svg(scene), encoding="utf-8")


def faults(scene: Scene, folder: Path) -> list[str]:
    """What keeps the stored files of one scene from being what would be drawn; empty when nothing does."""
    found = []
    truth, picture = folder / f"{scene.name}.truth.svg", folder / f"{scene.name}.jpg"
    if not truth.is_file():
        found.append(f"{truth} is missing: run draw_portraits.py to write it")
    elif truth.read_text(encoding="utf-8") != truth_svg(scene):
        found.append(f"{truth} differs from the contours that would be drawn: run draw_portraits.py and commit the result")
    stored = cv2.imread(str(picture)) if picture.is_file() else None
    if stored is None:
        found.append(f"{picture} is missing or unreadable: run draw_portraits.py to write it")
        return found
    fresh = cv2.imdecode(encoded(scene), cv2.IMREAD_COLOR)
    if stored.shape != fresh.shape:
        found.append(f"{picture} has the wrong size: run draw_portraits.py and commit the result")
    elif (gap := float(np.abs(stored.astype(int) - fresh).mean())) > TOLERANCE:
        found.append(f"{picture} differs from what would be drawn by {gap:.2f} grey levels on average "
                     f"(allowed: {TOLERANCE}): run draw_portraits.py and commit the result")
    return found


def main() -> int:
    """Draws or checks; returns the exit status: 0 done, 1 files differ, 2 wrong request."""
    cv2.setNumThreads(1)
    options = arguments()
    drawn = crowd(options.crowd, options.seed) if options.crowd else SCENES
    scenes = [s for s in drawn if options.only in (None, s.name)]
    if not scenes:
        print(f"no picture is called {options.only}; there are: {', '.join(s.name for s in drawn)}", file=sys.stderr)
        return 2
    found = []
    for number, scene in enumerate(scenes, 1):
        print(f"[{number}/{len(scenes)}] {scene.name}", file=sys.stderr, flush=True)
        if options.check:
            found += faults(scene, options.out)
            continue
        try:
            write(scene, options.out, not options.contours_only)
        except OSError as error:
            print(f"cannot write to {options.out}: {error.strerror}", file=sys.stderr)
            return 2
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
