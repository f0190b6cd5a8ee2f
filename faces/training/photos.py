# SPDX-License-Identifier: Apache-2.0
"""The photographs of ../shared/faces, hand-placed contours, and what is held out of all training."""
import json
from pathlib import Path

import cv2
import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DEFAULT_FACES = ROOT.parent / "shared" / "faces"
SETS = ("congress", "ukmp", "london", "wild")
KEYS = {"right_eye": "eye_on_the_left_of_the_picture", "left_eye": "eye_on_the_right_of_the_picture",
        "outer_lip": "outer_lip", "inner_lip": "inner_lip", "outline": "outline"}


def listed(file):
    """The lines of a file without comments."""
    return {line.strip() for line in file.read_text().splitlines() if line.strip() and not line.startswith("#")}


def held_out_people():
    """Numbers of the people of the London set whom no training may see."""
    return listed(HERE / "holdout.txt")


def held_out():
    """Those, and the names of the photographs of the wild set that no training may see."""
    return held_out_people() | listed(HERE / "holdout_wild.txt")


def hidden_eyes():
    """Names, as "wild/file.jpg", of photographs in which something hides an eye."""
    return {f"wild/{file}" for file in listed(HERE / "eyes_hidden.txt")}


def person_of(name):
    """"london/002_03.jpg" → "002"; everybody else has one picture, whose name is theirs."""
    folder, file = name.split("/")
    return file.split("_")[0] if folder == "london" else name


def is_held_out(name, kept_out):
    folder, file = name.split("/")
    return folder == "london" and person_of(name) in kept_out or folder == "wild" and file in kept_out


def names_of(faces, sets=SETS):
    """Names of all portraits, as "set/file.jpg", in order; sets that are absent are left out."""
    return [f"{folder}/{file.name}" for folder in sets
            for file in sorted((faces / "photos" / folder).glob("*.jpg"))]


def training_names(faces):
    kept_out = held_out()
    return [name for name in names_of(faces) if not is_held_out(name, kept_out)]


def read_photo(folder, name):
    """8-bit BGR."""
    picture = cv2.imread(str(folder / name))
    if picture is None:
        raise SystemExit(f"The portrait {folder / name} cannot be read.")
    return picture


def truth_file(faces):
    return faces / "photos" / "london_truth.json"


def read_truth(file):
    """name → contour name → (n, 2) points placed by hand, px. Closed lines start at the corner nearest the picture's
    left edge and go over the top."""
    people = json.loads(file.read_text(encoding="utf-8"))
    return {name: {contour: np.array(person[key]) for contour, key in KEYS.items()}
            for name, person in people.items()}
