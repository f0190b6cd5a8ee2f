# SPDX-License-Identifier: Apache-2.0
"""Scenes for the detector: faces of all sizes on backgrounds without any, and what the net should answer there.

Backgrounds are drawn here (clouds, stripes, shapes, hands, animals) or cut from the portraits where there is no face.
"""
import cv2
import numpy as np

from augmentation import degraded, relit
from crops import mapped

SIZE, CELL = 160, 8        # px
CELLS = SIZE // CELL
UNIT_FACE = 40.0           # px; sizes are answered as the logarithm of a multiple of this
SMALLEST, LARGEST = 12.0, 115.0
STORED_FACE = 130.0        # px; portraits are shrunk to this size of the face


class Face:
    """A face in a portrait: centre, right and left eye (3, 2) and its size, px."""

    def __init__(self, portrait):
        low, high = portrait.box
        self.portrait = portrait
        self.marks = np.array([(low + high) / 2, portrait.points[0:16].mean(0), portrait.points[16:32].mean(0)])
        self.size = float((high - low).max())


def clouds(rng, size):
    """Smooth noise of several sizes in a few colours."""
    picture = np.zeros((size, size, 3), np.float32)
    for cells in rng.choice([2, 3, 5, 9, 17, 40], rng.integers(1, 4), replace=False):
        layer = rng.uniform(-1, 1, (int(cells), int(cells), 1 if rng.random() < 0.5 else 3)).astype(np.float32)
        layer = cv2.resize(layer, (size, size), interpolation=cv2.INTER_CUBIC).reshape(size, size, -1)
        picture += layer * rng.uniform(10, 80, 3).astype(np.float32)
    return np.clip(picture + rng.uniform(20, 230, 3), 0, 255).astype(np.uint8)


def colour(rng):
    return tuple(rng.uniform(0, 255, 3).tolist())


def skin(rng):
    return tuple(np.clip(np.array([115, 145, 195]) * rng.uniform(0.3, 1.25) + rng.normal(0, 12, 3), 0, 255).tolist())


def shapes(rng, size):
    """Overlapping discs, boxes, lines and polygons."""
    picture = clouds(rng, size) if rng.random() < 0.5 else np.full((size, size, 3), colour(rng), np.uint8)
    for _ in range(rng.integers(3, 40)):
        at, extent = rng.integers(0, size, 2), rng.integers(2, 50, 2)
        kind, thickness = rng.random(), int(rng.choice([-1, 1, 2, 4]))
        if kind < 0.4:
            cv2.ellipse(picture, at.tolist(), extent.tolist(), rng.uniform(0, 180), 0, 360, colour(rng), thickness,
                        cv2.LINE_AA)
        elif kind < 0.7:
            cv2.rectangle(picture, at.tolist(), (at + extent).tolist(), colour(rng), thickness)
        elif kind < 0.9:
            cv2.line(picture, at.tolist(), rng.integers(0, size, 2).tolist(), colour(rng), abs(thickness) + 1,
                     cv2.LINE_AA)
        else:
            cv2.fillPoly(picture, [rng.integers(0, size, (int(rng.integers(3, 7)), 2)).astype(np.int32)], colour(rng),
                         cv2.LINE_AA)
    return picture


def stripes(rng, size):
    """Stripes or a grid, as of cloth, blinds, bricks and lattices."""
    y, x = np.mgrid[0:size, 0:size].astype(np.float32)
    angle, period = rng.uniform(0, np.pi), rng.uniform(4, 50)
    wave = np.sin((x * np.cos(angle) + y * np.sin(angle)) * 2 * np.pi / period)
    if rng.random() < 0.5:
        wave *= np.sin((y * np.cos(angle) - x * np.sin(angle)) * 2 * np.pi / (period * rng.uniform(0.5, 2)))
    part = (np.clip(wave * rng.uniform(1, 8), -1, 1)[..., None] + 1) / 2
    return (np.array(colour(rng)) * part + np.array(colour(rng)) * (1 - part)).astype(np.uint8)


def soft(picture, rng, deviation=None):
    return cv2.GaussianBlur(picture, (0, 0), deviation or rng.uniform(0.5, 1.5))


def hand(rng, size):
    """A palm with four fingers and a thumb, with darker gaps and nails."""
    picture, tone = clouds(rng, size), skin(rng)
    palm, scale, turn = rng.uniform(0.3, 0.7, 2) * size, rng.uniform(10, 45), rng.uniform(0, 2 * np.pi)
    for finger in (-0.9, -0.3, 0.05, 0.4, 0.75):
        direction = np.array([np.cos(turn + finger), np.sin(turn + finger)])
        start, end = palm + 0.5 * scale * direction, palm + rng.uniform(1.2, 2.3) * scale * direction
        shade = tuple(v * rng.uniform(0.85, 1.05) for v in tone)
        for width, ink in ((0.5, tuple(v * 0.6 for v in tone)), (0.42, shade)):
            cv2.line(picture, start.astype(int).tolist(), end.astype(int).tolist(), ink,
                     max(1, int(width * scale)), cv2.LINE_AA)
        cv2.circle(picture, end.astype(int).tolist(), max(1, int(0.12 * scale)), tuple(min(255, v * 1.2) for v in tone),
                   -1, cv2.LINE_AA)
    cv2.circle(picture, palm.astype(int).tolist(), int(0.75 * scale), tone, -1, cv2.LINE_AA)
    return soft(picture, rng)


def animal(rng, size):
    """Fur with ears, round eyes wide apart, a muzzle and a nose: no face of a person."""
    picture, fur = clouds(rng, size), np.array(colour(rng)) * 0.8
    middle, r = rng.uniform(0.3, 0.7, 2) * size, rng.uniform(12, 50)

    def disc(x, y, rx, ry, ink, turn=0.0):
        cv2.ellipse(picture, (middle + r * np.array([x, y])).astype(int).tolist(),
                    (max(1, int(rx * r)), max(1, int(ry * r))), turn, 0, 360, tuple(np.clip(ink, 0, 255).tolist()), -1,
                    cv2.LINE_AA)
    disc(0.6, 1.6, 1.3, 1.1, fur * 0.9)
    ear_length = rng.uniform(0.3, 0.9)
    for side in (-1, 1):
        disc(side * 0.75, -0.8, 0.3, ear_length, fur * 0.7, side * 25.0)
    disc(0, 0, 1.0, 0.9, fur)
    for _ in range(200):  # strokes of fur
        at = middle + r * rng.normal(0, 0.6, 2)
        cv2.line(picture, at.astype(int).tolist(), (at + rng.normal(0, 0.1 * r, 2)).astype(int).tolist(),
                 tuple(np.clip(fur * rng.uniform(0.7, 1.3), 0, 255).tolist()), 1, cv2.LINE_AA)
    iris = np.array(colour(rng))
    apart = rng.uniform(0.4, 0.65)
    for side in (-1, 1):
        disc(side * apart, -0.15, 0.17, 0.17, iris)
        disc(side * apart, -0.15, rng.uniform(0.04, 0.12), 0.13, np.zeros(3))
    disc(0, 0.5, 0.45, 0.35, fur * 1.25 + 15)
    disc(0, 0.32, 0.16, 0.11, np.array([40, 35, 50]) * rng.uniform(0.3, 2))
    cv2.line(picture, (middle + r * np.array([0, 0.4])).astype(int).tolist(),
             (middle + r * np.array([0, 0.65])).astype(int).tolist(), (30, 25, 35), 1, cv2.LINE_AA)
    return soft(picture, rng)


def part_of_portrait(rng, size, faces):
    """Clothes below the chin, or the backdrop beside the head, enlarged or shrunk."""
    face = faces[rng.integers(len(faces))]
    picture, (low, high) = face.portrait.picture, face.portrait.box.astype(int)
    parts = [picture[high[1] + 4:], picture[:, :max(0, low[0] - 25)], picture[:, high[0] + 25:]]
    parts = [part for part in parts if min(part.shape[:2]) >= 12]
    if not parts:
        return shapes(rng, size)
    part = parts[rng.integers(len(parts))]
    extent = np.array(part.shape[:2])
    keep = np.maximum(12, (extent * rng.uniform(0.4, 1.0, 2)).astype(int))
    at = rng.integers(0, extent - keep + 1)
    part = part[at[0]:at[0] + keep[0], at[1]:at[1] + keep[1]]
    if rng.random() < 0.5:
        part = np.rot90(part, int(rng.integers(4)))
    return cv2.resize(np.ascontiguousarray(part), (size, size))


def piece_of_face(rng, size, faces):
    """An eye, a nose, a cheek or an ear that fills the view: skin and features, but no face."""
    face = faces[rng.integers(len(faces))]
    low, high = face.portrait.box
    side = max(10, int(face.size * rng.uniform(0.15, 0.35)))
    at = (low + rng.random(2) * np.maximum(1, high - low - side)).astype(int)
    at = np.clip(at, 0, np.maximum(0, np.array(face.portrait.picture.shape[1::-1]) - side))
    return cv2.resize(face.portrait.picture[at[1]:at[1] + side, at[0]:at[0] + side], (size, size))


def background(rng, faces, size=SIZE):
    """A picture without a face."""
    draw = rng.choice([clouds, shapes, stripes, hand, animal, part_of_portrait, piece_of_face],
                      p=[0.15, 0.15, 0.08, 0.1, 0.12, 0.3, 0.1])
    picture = draw(rng, size, faces) if draw in (part_of_portrait, piece_of_face) else draw(rng, size)
    return np.ascontiguousarray(picture[:, ::-1] if rng.random() < 0.5 else picture)


class Scenes:
    """Batch number `step` is the same whenever it is made."""

    def __init__(self, portraits, seed, size=32):
        stored = [p.shrunk(STORED_FACE * 0.51) for p in portraits]  # the eyes' outer corners are 0.51 of a face apart
        self.faces, self.seed, self.size = [Face(p) for p in stored], seed, size

    def place(self, scene, placed, count, rng):
        """Puts one face into the scene, unless there is another one where it would go."""
        face = self.faces[rng.integers(len(self.faces))]
        largest = LARGEST if count == 1 else 55.0
        size = np.exp(rng.uniform(np.log(SMALLEST), np.log(largest)))
        scale, turn, stretch = size / face.size, rng.normal(0, 0.25), np.exp(rng.uniform(-0.1, 0.1))
        c, s = np.cos(turn) * scale, np.sin(turn) * scale
        linear = np.array([[c * stretch, -s], [s, c / stretch]])
        centre = rng.uniform(0.3 * size, SIZE - 0.3 * size, 2)
        marks = face.marks
        if rng.random() < 0.5:
            linear = linear @ np.diag([-1.0, 1.0])
            marks = marks[[0, 2, 1]]
        if any(np.linalg.norm(centre - other[0]) < size + its_size for other, its_size in placed):
            return scene
        picture, shrunk = face.portrait.picture, min(1.0, 1.6 * scale)
        source = cv2.resize(picture, None, fx=shrunk, fy=shrunk, interpolation=cv2.INTER_AREA)
        exact = np.divide(source.shape[1::-1], picture.shape[1::-1])
        to_scene = np.c_[linear, centre - linear @ face.marks[0]]
        from_source = np.c_[linear / exact, to_scene[:, 2]]
        from_source[:, 2] = mapped(from_source, np.array([0.5, 0.5])) - 0.5
        fills = count == 1 and rng.random() < 0.5
        border = cv2.BORDER_REPLICATE if fills else cv2.BORDER_CONSTANT
        shown = cv2.warpAffine(source, from_source, (SIZE, SIZE), flags=cv2.INTER_LINEAR, borderMode=border)
        if not fills:
            mask = cv2.warpAffine(np.full(source.shape[:2], 255, np.uint8), from_source, (SIZE, SIZE))
            if rng.random() < 0.4:  # without its own backdrop
                head = np.zeros((SIZE, SIZE), np.uint8)
                cv2.ellipse(head, centre.astype(int).tolist(), (int(0.62 * size), int(0.75 * size)),
                            np.degrees(turn), 0, 360, 255, -1)
                mask = np.minimum(mask, head)
            part = cv2.GaussianBlur(mask, (0, 0), 0.7).astype(np.float32)[..., None] / 255.0
            shown = (scene + part * (shown.astype(np.float32) - scene)).astype(np.uint8)
        placed.append((mapped(to_scene, marks), size))
        return shown

    def scene(self, rng):
        picture, placed = background(rng, self.faces), []
        count = int(rng.choice([0, 1, 2, 3, 5], p=[0.2, 0.5, 0.12, 0.09, 0.09]))
        for _ in range(count):
            picture = self.place(picture, placed, count, rng)
        return degraded(picture, rng), placed

    def __call__(self, step):
        """Pixels (B, 3, s, s); how much of a face each cell is (B, c, c), 1 at centres; the other seven answers
        (B, 7, c, c); where those count (B, c, c)."""
        rng = np.random.default_rng([self.seed, step])
        scenes = [self.scene(rng) for _ in range(self.size)]
        pixels = (relit(np.stack([picture for picture, _ in scenes]), rng) - np.float32(127.5)) / np.float32(255.0)
        answers = [answer_for(placed) for _, placed in scenes]
        return (pixels.transpose(0, 3, 1, 2), *(np.stack(part) for part in zip(*answers)))


def answer_for(placed):
    score = np.zeros((CELLS, CELLS), np.float32)
    values, counts = np.zeros((7, CELLS, CELLS), np.float32), np.zeros((CELLS, CELLS), np.float32)
    y, x = np.mgrid[0:CELLS, 0:CELLS]
    for marks, size in placed:
        column, row = np.floor(marks[0] / CELL).astype(int)
        spread = max(0.7, size / CELL / 6)
        score = np.maximum(score, np.exp(-((x - column) ** 2 + (y - row) ** 2) / (2 * spread ** 2)))
        score[row, column] = 1.0
        reach = 1 if size > 24 else 0
        for j in range(max(0, row - reach), min(CELLS, row + reach + 1)):
            for i in range(max(0, column - reach), min(CELLS, column + reach + 1)):
                here = (np.array([i, j]) + 0.5) * CELL
                counts[j, i] = 1.0
                values[:, j, i] = [*((marks[0] - here) / CELL), np.log(size / UNIT_FACE),
                                   *((marks[1:] - here) / size).ravel()]
    return score.astype(np.float32), values, counts
