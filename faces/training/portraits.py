# SPDX-License-Identifier: Apache-2.0
"""Labelled portraits in memory, as the nets are trained on them."""
from dataclasses import dataclass

import cv2
import numpy as np

from correction import Correction
from labels import teacher_labels
from photos import held_out_people, is_held_out, read_photo, read_truth
from truth_points import truth_labels
from warps import closed_eyes, opened_mouth

APART_PX = 140.0  # pictures are shrunk until the outer corners of the eyes are at most this far apart
REACH = 1.9       # of that distance: what is kept around the middle of the face
# How often a portrait is shown: hand-placed contours are the truth, the smallest pictures teach least.
WEIGHTS = {"truth": 8.0, "london": 3.0, "congress": 2.0, "ukmp": 1.0}


@dataclass
class Portrait:
    picture: np.ndarray  # 8-bit BGR
    points: np.ndarray   # (140, 2), px of the picture, counted from its corner
    box: np.ndarray      # (2, 2), least and largest corner of the face, forehead and all
    weight: float        # how often it is shown, to that of the others

    def shrunk(self, apart):
        """The same with the eyes at most `apart` px apart."""
        scale = apart / np.linalg.norm(self.points[16] - self.points[0])
        if scale >= 1.0:
            return self
        picture = cv2.resize(self.picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        exact = np.divide(picture.shape[1::-1], self.picture.shape[1::-1])
        return Portrait(picture, self.points * exact, self.box * exact, self.weight)


def cut_out(picture, points, box, weight):
    apart = np.linalg.norm(points[16] - points[0])
    middle = points[:105].mean(0)
    low = np.maximum(0, np.floor(middle - REACH * apart)).astype(int)
    high = np.ceil(middle + REACH * apart).astype(int)
    part = picture[low[1]:high[1], low[0]:high[0]]
    return Portrait(np.ascontiguousarray(part), points - low, box - low, weight).shrunk(APART_PX)


def plain_portraits(faces, work, log):
    """One a portrait, with the teacher's points corrected, or the hand-placed ones where there are some."""
    said, truth, held_out = teacher_labels(faces, work, log), read_truth(faces), held_out_people()
    placed = {name: truth_labels(truth[name], said[name][0])
              for name in truth if name in said and not is_held_out(name, held_out)}
    correct = Correction([(said[name][0], placed[name]) for name in placed])
    portraits = []
    for name, (points, box) in said.items():
        weight = WEIGHTS["truth" if name in placed else name.split("/")[0]]
        points = placed[name] if name in placed else correct(points)
        portraits.append(cut_out(read_photo(faces, name), points, box, weight))
    log(f"{len(portraits)} portraits, {len(placed)} of them with hand-placed contours")
    return portraits


def warped(portraits, kind, seed):
    """Every portrait once more with an "open" mouth or "closed" eyes. They are shown less often: they are less real."""
    warp, share = {"open": (opened_mouth, 0.5), "closed": (closed_eyes, 0.25)}[kind]
    rng = np.random.default_rng([seed, len(kind)])
    return [Portrait(*warp(p.picture, p.points, rng), p.box, share * min(p.weight, 2.0)) for p in portraits]
