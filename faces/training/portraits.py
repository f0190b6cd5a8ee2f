# SPDX-License-Identifier: Apache-2.0
"""Labelled portraits in memory, as the nets are trained on them."""
from dataclasses import dataclass

import cv2
import numpy as np

from contours import SLICES
from correction import Correction
from labels import teacher_labels
from photos import held_out, is_held_out, read_photo, read_truth, truth_file
from truth_points import truth_labels
from turned_heads import turned_head
from warps import closed_eyes, opened_mouth, other_lips

APART_PX = 140.0  # pictures are shrunk until the outer corners of the eyes are at most this far apart
SELDOM_SHOWN, SHOWN_MORE_OFTEN = 20.0, 3.0  # dark skin, by its typology angle in degrees: 4 % of the portraits
LARGEST_YAW = 40  # degrees
REACH = 1.9       # of that distance: what is kept around the middle of the face
# How often a portrait is shown: hand-placed contours are the truth, the smallest pictures teach least.
WEIGHTS = {"truth": 8.0, "london": 3.0, "wild": 4.0, "congress": 2.0, "ukmp": 1.0}


@dataclass
class Portrait:
    picture: np.ndarray  # 8-bit BGR
    points: np.ndarray   # (140, 2), px of the picture, counted from its corner
    skin: np.ndarray     # (468, 3), the teacher's mesh, px of the picture and as many away from the camera
    weight: float        # how often it is shown, to that of the others
    name: str = ""       # of a photograph as it is, "set/file.jpg"

    @property
    def box(self):
        """(2, 2): least and largest corner of the face, forehead and all."""
        return np.stack([self.skin[:, :2].min(0), self.skin[:, :2].max(0)])

    def shrunk(self, apart):
        """The same with the eyes at most `apart` px apart."""
        scale = apart / np.linalg.norm(self.points[16] - self.points[0])
        if scale >= 1.0:
            return self
        picture = cv2.resize(self.picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        exact = np.divide(picture.shape[1::-1], self.picture.shape[1::-1])
        return Portrait(picture, self.points * exact, self.skin * [*exact, exact.mean()], self.weight, self.name)


def typology_angle(picture, points):
    """Individual typology angle of the cheeks in degrees (Chardon et al. 1991): arctan((L* − 50) / b*), below 28 for
    brown and dark skin; a picture that is too dark lowers it too."""
    reach = 0.08 * np.linalg.norm(points[16] - points[0])
    lab = cv2.cvtColor(picture.astype(np.float32) / 255.0, cv2.COLOR_BGR2Lab)
    seen = []
    for eye, corner in (("right_eye", 32), ("left_eye", 42)):
        cheek = 0.5 * (points[SLICES[eye]].mean(0) + points[corner])
        low, high = np.maximum(0, cheek - reach).astype(int), (cheek + reach + 1).astype(int)
        seen.append(lab[low[1]:high[1], low[0]:high[0]].reshape(-1, 3))
    lightness, _, yellow = np.median(np.vstack(seen), 0)
    return float(np.degrees(np.arctan2(lightness - 50.0, max(yellow, 1e-3))))


def cut_out(picture, points, skin, weight, name=""):
    apart = np.linalg.norm(points[16] - points[0])
    middle = points[:105].mean(0)
    low = np.maximum(0, np.floor(middle - REACH * apart)).astype(int)
    high = np.ceil(middle + REACH * apart).astype(int)
    part = picture[low[1]:high[1], low[0]:high[0]]
    return Portrait(np.ascontiguousarray(part), points - low, skin - [*low, 0], weight, name).shrunk(APART_PX)


def plain_portraits(faces, work, log, without=frozenset()):
    """One a portrait, with the teacher's points corrected, or the hand-placed ones where there are some. `without`:
    names that are left out."""
    said, truth, kept_out = teacher_labels(faces, work, log), read_truth(truth_file(faces)), held_out()
    placed = {name: truth_labels(truth[name], said[name].points)
              for name in truth if name in said and not is_held_out(name, kept_out)}
    correct = Correction([(said[name].points, placed[name]) for name in placed])
    portraits = []
    for name, seen in said.items():
        if name in without:
            continue
        weight = WEIGHTS["truth" if name in placed else name.split("/")[0]]
        points = placed[name] if name in placed else correct(seen.points)
        portrait = cut_out(read_photo(faces / "photos", name), points, seen.skin, weight, name)
        if typology_angle(portrait.picture, portrait.points) < SELDOM_SHOWN:
            portrait.weight *= SHOWN_MORE_OFTEN
        portraits.append(portrait)
    log(f"{len(portraits)} portraits, {len(placed)} of them with hand-placed contours")
    return portraits


def warped(portraits, kind, seed):
    """Every portrait once more with an "open" mouth, "closed" eyes or other "lips". They are shown less often: they are
    less real."""
    warp, share = {"open": (opened_mouth, 0.5), "closed": (closed_eyes, 0.25), "lips": (other_lips, 0.4)}[kind]
    rng = np.random.default_rng([seed, len(kind)])
    return [Portrait(*warp(p.picture, p.points, rng), p.skin, share * min(p.weight, 3.0)) for p in portraits]


def turned(portraits, seed):
    """Every portrait once more with the head turned aside by up to `LARGEST_YAW` and nodded a little."""
    rng = np.random.default_rng([seed, LARGEST_YAW])
    return [Portrait(*turned_head(p.picture, p.points, p.skin, np.radians(rng.uniform(-LARGEST_YAW, LARGEST_YAW)),
                                  np.radians(np.clip(rng.normal(0.0, 10.0), -20.0, 20.0))),
                     0.6 * min(p.weight, 3.0)) for p in portraits]
