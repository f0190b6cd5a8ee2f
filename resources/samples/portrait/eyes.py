# SPDX-License-Identifier: Apache-2.0
"""Eyes: ball, iris, lids and lashes (face units; the eye on the picture's right, mirrored for the other)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .canvas import Pen
from .curves import Path, smoothstep, spline
from .people import Contours, Expression, Person, srgb
from .relief import across

_SHADE = np.array([0.42, 0.27, 0.23], np.float32)
_SCLERA = srgb(200, 189, 181)


def _iris(dx, dy, person: Person, side: int, rng: np.random.Generator) -> np.ndarray:
    """Colour at an offset from the pupil's centre: spokes, a brighter collar, a dark rim, the pupil."""
    ring = np.hypot(dx, dy) / person.shape.iris
    around = np.append(rng.normal(0, 1, 96), 0)
    around[-1] = around[0]
    spokes = np.interp(np.arctan2(dy, dx), np.linspace(-np.pi, np.pi, 97), around)
    collar = np.exp(-0.5 * ((ring - 0.58) / 0.16) ** 2)
    light = 0.85 + 0.22 * spokes * smoothstep(0.35, 0.6, ring) + 0.4 * collar
    light *= 1 + 0.45 * smoothstep(-0.2, 1.0, (dy + 0.4 * side * dx) / person.shape.iris)
    light *= 1 - 0.72 * smoothstep(0.8, 1.0, ring)
    colour = person.iris * light[..., None]
    return colour + (np.float32(0.006) - colour) * smoothstep(0.45, 0.37, ring)[..., None]


def _eyeball(x, y, person: Person, lid: Path, look: tuple[float, float], side: int, rng) -> np.ndarray:
    """Colour of the ball at each place of an eye whose iris stands at `look` (face units, `x` measured outwards)."""
    s = person.shape
    middle = 0.5 * (0.5 + s.eye_inner)
    r = np.hypot((x - middle) / 0.19, (y + 0.005) / 0.16)
    white = _SCLERA * (1 - 0.42 * np.clip(r, 0, 1.2)[..., None] ** 2 * np.array([0.8, 1.0, 1.05], np.float32))
    pink = smoothstep(s.eye_inner + 0.05, s.eye_inner + 0.012, x)[..., None]
    ball = white + (srgb(198, 128, 116) - white) * 0.8 * pink
    dx, dy = x - look[0], y - look[1]
    edge = smoothstep(1.04, 0.93, np.hypot(dx, dy) / s.iris)[..., None]
    ball = ball + (_iris(dx, dy, person, side, rng) - ball) * edge
    depth = y - across(lid, x)
    shadow = 0.34 + 0.66 * smoothstep(-0.005, 0.05, depth)
    out = ball * shadow[..., None]
    light = np.exp(-0.5 * (np.hypot(dx + side * 0.022, dy + 0.026) / 0.0095) ** 4)
    soft = 0.12 * np.exp(-0.5 * (np.hypot(dx - side * 0.02, dy - 0.03) / 0.013) ** 2)
    return out + (np.float32(0.95) - out) * np.clip(light + soft, 0, 1)[..., None]


@dataclass(frozen=True)
class _Row:
    """One row of lashes."""

    count: int
    length: float  # face units, before the person's own factor
    width: float
    opacity: float
    down: int  # 1: grows downwards, -1: upwards
    last: float  # share of the lid, from the outer corner, that carries lashes


_UPPER = _Row(70, 0.031, 0.0048, 0.75, -1, 0.86)
_LOWER = _Row(30, 0.014, 0.0040, 0.40, 1, 0.97)


def _lashes(pen: Pen, person: Person, lid: np.ndarray, row: _Row, side: int, rng: np.random.Generator) -> None:
    """Hairs along a lid (its points from the outer corner), longer and more slanted towards that corner."""
    colour = np.float32(0.010) + 0.12 * np.minimum(person.hair, 0.15)
    for u in rng.uniform(0.03, row.last, row.count):
        root = lid[int(u * (len(lid) - 1))]
        size = row.length * person.lashes * (1.15 - 0.75 * u) * rng.uniform(0.7, 1.2)
        lean = 0.95 - 1.5 * u + rng.normal(0, 0.12)
        tip = root + size * np.array([lean, row.down]) / np.hypot(lean, 1)
        bend = 0.5 * (root + tip) + size * np.array([-0.10, 0.16])
        curve = spline([root, bend, tip]).points(4) * [side, 1]
        pen.tapered(curve, np.linspace(row.width, 0.001, len(curve)), colour, row.opacity)


def _upper_lid(pen: Pen, person: Person, e: Expression, lid: np.ndarray, side: int) -> None:
    """Fold over the eye, the skin between fold and lashes, and the dark line of the lashes' roots, all outside the eye."""
    flip = np.array([side, 1.0])
    t = np.linspace(0, 1, len(lid))
    height = (0.45 + 0.62 * np.sin(np.pi * t) ** 0.7) / np.clip(e.eye_up, 0.7, 1.2) ** 0.3
    fold = lid + np.c_[0.012 * (1 - t), -0.052 * height]
    pen.tint(pen.area(np.vstack([fold, lid[::-1]]) * flip, 0.008), np.array([0.88, 0.78, 0.74], np.float32), 0.75)
    pen.tint(pen.line(fold[1:-2] * flip, 0.008, 0.0065), _SHADE, 1.0)
    pen.tint(pen.line((fold[2:-6] + [0.0, -0.012]) * flip, 0.02, 0.014), _SHADE, 0.45)
    width = 0.007 + 0.013 * np.sin(np.pi * np.clip(1.02 - t, 0, 1) ** 0.75) * (0.8 + 0.2 * person.lashes)
    dark = np.float32(0.012) + 0.10 * np.minimum(person.hair, 0.15)
    pen.tapered((lid - np.c_[np.zeros_like(t), 0.5 * width]) * flip, width, dark, 0.93)


def _lower_lid(pen: Pen, person: Person, e: Expression, lid: np.ndarray, side: int) -> None:
    """Moist rim and shade under the eye, the bag, and the lines at the outer corner that age and smiling bring."""
    flip = np.array([side, 1.0])
    pen.paint(pen.line((lid[3:-3] + [0, 0.005]) * flip, 0.008, 0.003), person.skin * np.array([0.98, 0.76, 0.72]), 0.55)
    pen.tint(pen.line((lid[6:] + [0, 0.013]) * flip, 0.008, 0.005), _SHADE, 0.55)
    bag = lid[8:-8] * [0.98, 1] + [0, 0.062 - 0.012 * e.cheek_lift]
    pen.tint(pen.line(bag * flip, 0.014, 0.014), _SHADE, 0.22 + 0.35 * person.age + 0.28 * e.cheek_lift)
    if person.age + e.cheek_lift > 0.7:
        for slope in (-0.03, 0.02, 0.06):
            foot = spline([(0.545, 0.01 + 0.5 * slope), (0.6, 0.012 + slope), (0.64, 0.02 + 1.7 * slope)]).points()
            pen.tint(pen.line(foot * flip, 0.006, 0.006), _SHADE, 0.14 + 0.3 * person.age)


def paint_eyes(pen: Pen, person: Person, e: Expression, c: Contours, rng: np.random.Generator) -> None:
    """Both eyes with everything between fold and bag."""
    s = person.shape
    look = (0.5 * (0.5 + s.eye_inner) - 0.004, -0.009 if e.eye_up > 0.82 else -0.002)
    for side in (-1, 1):
        eye = np.vstack([c.upper_lid.points(), c.lower_lid.points()[1:]]) * [side, 1]
        mask = pen.area(eye)
        x, y = mask.grid(pen.frame)
        pen.paint(mask, _eyeball(x * side, y, person, c.upper_lid, look, side, rng))
        upper, lower = c.upper_lid.points(), c.lower_lid.points()
        _upper_lid(pen, person, e, upper, side)
        _lower_lid(pen, person, e, lower, side)
        _lashes(pen, person, upper, _UPPER, side, rng)
        _lashes(pen, person, lower[::-1], _LOWER, side, rng)
