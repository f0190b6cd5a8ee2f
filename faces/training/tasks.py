# SPDX-License-Identifier: Apache-2.0
"""What each contour net is shown and asked: its window on a portrait, varied, and the points in that window."""
from dataclasses import dataclass
from typing import Callable

import numpy as np

import crops
from augmentation import Jitter, covered, degraded, jittered, relit, turned_aside, with_glare
from contours import BROW, COUNT, EYE, LIP, MIRROR, MOUTH, MOUTH_MIRROR, NOSE, OUTLINE, OUTLINE_MIRROR, SLICES
from crops import Frame, inverse, mapped, warp
from portraits import turned, warped


@dataclass
class Question:
    frame: Frame
    points: np.ndarray  # (n, 2), px of the picture, in the order in which the net answers


def eye_question(portrait, rng):
    """Either eye, the left one in a mirror."""
    mirrored = rng.random() < 0.5
    eye = portrait.points[SLICES["left_eye" if mirrored else "right_eye"]]
    return Question(crops.eye_frame(eye, mirrored), eye)


def mirrored_question(frame, points, order, rng):
    if rng.random() < 0.5:
        return Question(frame, points)
    frame.mirrored = True
    return Question(frame, points[order])


def mouth_question(portrait, rng):
    lips = portrait.points[MOUTH]
    return mirrored_question(crops.mouth_frame(lips), lips, MOUTH_MIRROR, rng)


def outline_question(portrait, rng):
    return mirrored_question(crops.outline_frame(portrait.points), portrait.points[SLICES["outline"]],
                             OUTLINE_MIRROR, rng)


def face_question(portrait, rng):
    """As from a detector's box, forehead and all, or from the points of a first look."""
    frame = crops.face_frame(portrait.points)
    if rng.random() < 0.5:
        frame.centre = portrait.box.mean(0)
        frame.side = crops.FACE_BY_BOX * (portrait.box[1] - portrait.box[0]).max()
    return mirrored_question(frame, portrait.points, MIRROR, rng)


@dataclass
class Task:
    """How one contour net is trained."""
    size: int         # px of its window
    points: int
    question: Callable
    jitter: Jitter
    apart: float      # portraits are shrunk until the outer corners of the eyes are this far apart, px
    warps: tuple      # how portraits are warped for copies that are shown beside them
    features: tuple   # numbers of points of its lines, and which of them are corners
    aside: float = 0.0  # how often the head is turned
    glare: float = 0.0


def closed(count):
    return count, (0, count // 2), True


OPEN_OUTLINE = (OUTLINE, (), False)
NO_LINE = (4, (0, 1, 2, 3), True)  # centres and rims of the irises
BROW_LINE, NOSE_LINE = (BROW, (), True), (NOSE, (), False)
TASKS = {
    "eye": Task(crops.EYE_PX, EYE, eye_question, Jitter(0.07, 0.16, 0.08), 140.0, ("closed",), (closed(EYE),),
                glare=0.15),
    "mouth": Task(crops.MOUTH_PX, 2 * LIP, mouth_question, Jitter(0.07, 0.16, 0.08), 140.0, ("open", "lips"),
                  (closed(LIP), closed(LIP))),
    "outline": Task(crops.OUTLINE_PX, OUTLINE, outline_question, Jitter(0.04, 0.1, 0.06), 60.0, ("open",),
                    (OPEN_OUTLINE,), aside=0.3),
    "contours": Task(crops.FACE_PX, COUNT, face_question, Jitter(0.08, 0.18, 0.15, large_turn=np.pi / 4), 60.0,
                     ("open", "closed"), (closed(EYE), closed(EYE), closed(LIP), closed(LIP), OPEN_OUTLINE, NO_LINE,
                                          BROW_LINE, BROW_LINE, NOSE_LINE),
                     aside=0.3, glare=0.1),
}


def tangents(points, features):
    """Unit direction of the line at each of (B, n, 2) points, 0 where it has a corner, an end or no line."""
    result, start = np.zeros_like(points), 0
    for count, corners, is_closed in features:
        line = points[:, start:start + count]
        along = np.roll(line, -1, 1) - np.roll(line, 1, 1)
        along /= np.maximum(np.linalg.norm(along, axis=2, keepdims=True), 1e-6)
        along[:, list(corners) if is_closed else [0, count - 1]] = 0.0
        result[:, start:start + count] = along
        start += count
    return result


class Batches:
    """Batch number `step` is the same whenever it is made: training can stop and resume anywhere."""

    def __init__(self, task, portraits, seed, size=48):
        self.task, self.seed, self.size = task, seed, size
        plain = [portrait.shrunk(task.apart) for portrait in portraits]
        heads = plain + turned(plain, seed)
        self.portraits = heads + [copy for kind in task.warps for copy in warped(heads, kind, seed)]
        weights = np.array([p.weight for p in self.portraits])
        self.shares = weights / weights.sum()

    def sample(self, portrait, rng):
        task = self.task
        question = task.question(portrait, rng)
        to_picture = jittered(question.frame.to_picture(task.size), task.size, task.jitter, rng)
        crop = warp(portrait.picture, to_picture, task.size)
        points = mapped(inverse(to_picture), question.points)
        if rng.random() < task.aside:
            crop, points = turned_aside(crop, points, rng)
        if rng.random() < task.glare:
            eye = points[:EYE]
            crop = with_glare(crop, eye.mean(0), np.ptp(eye, 0).max(), rng)
        if rng.random() < 0.15:
            crop = covered(crop, rng)
        return degraded(crop, rng), points

    def __call__(self, step):
        """(B, 3, s, s) pixels as the net wants them, (B, n, 2) points from the middle in window sides, tangents."""
        rng = np.random.default_rng([self.seed, step])
        chosen = rng.choice(len(self.portraits), self.size, p=self.shares)
        pairs = [self.sample(self.portraits[i], rng) for i in chosen]
        pixels = (relit(np.stack([crop for crop, _ in pairs]), rng) - np.float32(127.5)) / np.float32(255.0)
        points = np.stack([points for _, points in pairs])
        along = tangents(points, self.task.features)
        return (pixels.transpose(0, 3, 1, 2), (points / self.task.size - 0.5).astype(np.float32),
                along.astype(np.float32))

    def mean_answer(self):
        """(n, 2): what the net starts from."""
        rng = np.random.default_rng([self.seed, 1 << 20])
        size = self.task.size
        answers = []
        for portrait in self.portraits[::7]:
            question = self.task.question(portrait, rng)
            answers.append(mapped(inverse(question.frame.to_picture(size)), question.points) / size - 0.5)
        return np.mean(answers, 0).astype(np.float32)
