# SPDX-License-Identifier: Apache-2.0
"""Hair as sheets of strands: a sheet is a row of guide curves, a strand a blend of two neighbours."""

from __future__ import annotations

import cv2
import numpy as np

from .canvas import OVERSAMPLING, Pen
from .curves import spline
from .people import Person

_SAMPLES = 33  # points on a guide or strand


def _guides(curves) -> np.ndarray:
    """Guide curves from knots, resampled alike: (guides, _SAMPLES, 2) in face units."""
    out = []
    for knots in curves:
        p = spline(knots).points()
        s = np.r_[0, np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))]
        t = np.linspace(0, s[-1], _SAMPLES)
        out.append(np.c_[np.interp(t, s, p[:, 0]), np.interp(t, s, p[:, 1])])
    return np.array(out)


def _strand(guides: np.ndarray, at: float) -> np.ndarray:
    i = min(int(at), len(guides) - 2)
    return guides[i] + (guides[i + 1] - guides[i]) * (at - i)


def _base(pen: Pen, guides: np.ndarray, colour, blur: float, skin: Pen | None) -> None:
    """The dark mass under the strands, with its shadow on the skin."""
    rim = np.vstack([guides[0], guides[1:-1, -1], guides[-1][::-1], guides[-2:0:-1, 0]])
    if skin is not None:
        skin.tint(skin.area(rim + [0.012, 0.03], 0.03), np.array([0.5, 0.38, 0.34], np.float32), 0.9)
    pen.paint(pen.area(rim, blur), colour)


def _sheen(along: np.ndarray, where: float) -> np.ndarray:
    """Brightness along a strand: two bands of reflected light, the first at `where` (0 to 1)."""
    band = lambda centre, width: np.exp(-0.5 * ((along - centre) / width) ** 2)
    return 0.55 + 0.75 * band(where, 0.13) + 0.3 * band(0.75, 0.12)


def _stroke(pen: Pen, person: Person, strand: np.ndarray, light: np.ndarray, thick: int) -> None:
    """One hair, its brightness changing along it."""
    q = np.round((pen.frame.to_picture(strand) * OVERSAMPLING - 0.5) * 16).astype(np.int32)
    colours = person.hair * light[:, None] + 0.012 * light[:, None] ** 2
    for j in range(0, len(q) - 1, 2):
        cv2.polylines(pen.canvas.rgb, [q[j : j + 3]], False, colours[j].tolist(), thick, cv2.LINE_8, 4)


def paint_sheet(pen: Pen, person: Person, curves, strands: int, rng: np.random.Generator, ragged: float = 0.012,
                dim: float = 1.0, tidy: bool = False, blur: float = 0.012, even: float = 0.78,
                skin: Pen | None = None) -> None:
    """One sheet: dark base, then `strands` thin strokes.

    `tidy` keeps strands from straying past the first guide, `even` is the share of its length that every strand has,
    `skin` a pen clipped to the skin on which the sheet casts its shadow.
    """
    guides = _guides(curves)
    whole = int(_SAMPLES * even)
    _base(pen, guides[:, :whole], person.hair * 0.28 * dim, blur, skin)
    places = np.linspace(0, len(guides) - 1, strands)
    clump = np.interp(places, np.linspace(0, len(guides) - 1, 60), rng.normal(0, 0.2, 60))
    along = np.linspace(0, 1, _SAMPLES)
    thick = max(1, round(0.0048 * pen.unit))
    for k in rng.permutation(strands):
        stray = ragged * (np.clip(0.8 * places[k], 0.12, 1) if tidy else 1.0)
        drift = stray * np.cumsum(rng.normal(0, 0.3, _SAMPLES))[:, None] * along[:, None]
        strand = _strand(guides, places[k]) + drift + stray * rng.normal(0, 0.5, 2)
        tone = np.clip(0.85 + 0.22 * rng.normal() + clump[k], 0.3, 1.8)
        light = tone * dim * _sheen(along, 0.3 + 0.05 * np.sin(5 * places[k]) + 0.035 * rng.normal())
        last = rng.integers(whole, _SAMPLES + 1)
        _stroke(pen, person, strand[:last], light[:last], thick)


def _mirror(curves, dx: float = 0.0) -> list:
    return [[(-x + dx, y) for x, y in c] for c in curves]


def _long_back(pen: Pen, person: Person, rng) -> None:
    """Falls behind the ears onto the shoulders."""
    side = [
        [(0.3, -0.8), (0.62, -0.2), (0.66, 0.5), (0.58, 1.1), (0.52, 1.5), (0.5, 1.95)],
        [(0.3, -1.0), (0.8, -0.3), (0.86, 0.5), (0.82, 1.1), (0.76, 1.6), (0.72, 2.15)],
        [(0.2, -1.1), (0.92, -0.5), (1.0, 0.4), (1.02, 1.1), (0.98, 1.7), (0.9, 2.2)],
    ]
    for curves in (side, _mirror(side)):
        paint_sheet(pen, person, curves, 900, rng, ragged=0.02, dim=0.72, blur=0.02)


def _long_front(pen: Pen, person: Person, rng, skin: Pen) -> None:
    """Parted at the picture's right of the middle, swept over the temples and behind the ears."""
    part = 0.10
    right = [
        [(part, -0.76), (0.34, -0.68), (0.58, -0.46), (0.71, -0.18), (0.79, 0.1), (0.86, 0.5), (0.8, 0.95)],
        [(part, -0.88), (0.4, -0.83), (0.68, -0.56), (0.82, -0.22), (0.88, 0.1), (0.93, 0.5), (0.89, 1.0)],
        [(part, -1.0), (0.42, -0.98), (0.76, -0.68), (0.92, -0.26), (0.97, 0.12), (1.0, 0.55), (0.97, 1.1)],
        [(part, -1.15), (0.45, -1.12), (0.84, -0.78), (1.0, -0.28), (1.05, 0.2), (1.06, 0.6), (1.02, 1.2)],
    ]
    left = [
        [(part, -0.76), (-0.2, -0.72), (-0.5, -0.52), (-0.69, -0.2), (-0.79, 0.1), (-0.86, 0.5), (-0.8, 0.95)],
        [(part, -0.88), (-0.28, -0.87), (-0.63, -0.6), (-0.82, -0.22), (-0.88, 0.1), (-0.93, 0.5), (-0.89, 1.0)],
        [(part, -1.0), (-0.34, -1.02), (-0.74, -0.72), (-0.92, -0.26), (-0.97, 0.12), (-1.0, 0.55), (-0.97, 1.1)],
        [(part, -1.15), (-0.4, -1.16), (-0.84, -0.8), (-1.01, -0.28), (-1.05, 0.2), (-1.06, 0.6), (-1.02, 1.2)],
    ]
    for curves in (left, right):
        paint_sheet(pen, person, curves, 1700, rng, tidy=True, skin=skin)


def _crop(w: float) -> list:
    """Guides of hair cut short and brushed up and aside: roots along the hairline, tips on the silhouette."""
    roots = [(-w + 0.01, 0.02), (-w + 0.02, -0.2), (-w + 0.09, -0.42), (-0.52, -0.6), (-0.28, -0.68), (0, -0.7),
             (0.28, -0.68), (0.52, -0.6), (w - 0.09, -0.42), (w - 0.02, -0.2), (w - 0.01, 0.02)]
    tips = [(-w - 0.045, -0.05), (-w - 0.075, -0.42), (-w - 0.02, -0.8), (-0.58, -1.05), (-0.3, -1.16), (0.02, -1.2),
            (0.32, -1.16), (0.6, -1.03), (w + 0.025, -0.78), (w + 0.075, -0.42), (w + 0.045, -0.05)]
    guides = []
    for r, t in zip(np.array(roots), np.array(tips)):
        bow = np.array([0.06, -0.02]) * (1 - abs(r[0]) / w)
        guides.append([tuple(r), tuple(0.5 * (r + t) + bow), tuple(t)])
    return guides


def _short_front(pen: Pen, person: Person, rng, skin: Pen) -> None:
    paint_sheet(pen, person, _crop(person.shape.cheek), 3600, rng, ragged=0.009, blur=0.015, even=0.96, skin=skin)


def _swept_front(pen: Pen, person: Person, rng, skin: Pen) -> None:
    """Waves combed from a side parting to behind the ears, which stay free."""
    part, w = -0.2, person.shape.cheek
    near = [
        [(part, -0.72), (-0.4, -0.66), (-0.58, -0.46), (-w + 0.05, -0.24), (-w - 0.01, -0.06), (-w - 0.03, 0.04)],
        [(part, -0.86), (-0.46, -0.8), (-0.7, -0.54), (-w - 0.06, -0.26), (-w - 0.07, -0.08), (-w - 0.06, 0.04)],
        [(part, -1.04), (-0.54, -0.98), (-0.82, -0.62), (-w - 0.14, -0.3), (-w - 0.12, -0.08), (-w - 0.08, 0.06)],
        [(part, -1.2), (-0.58, -1.1), (-0.88, -0.7), (-w - 0.19, -0.34), (-w - 0.16, -0.08), (-w - 0.1, 0.08)],
    ]
    far = [
        [(part, -0.72), (0.0, -0.78), (0.34, -0.7), (0.58, -0.5), (w - 0.04, -0.24), (w + 0.01, -0.06), (w + 0.03, 0.04)],
        [(part, -0.86), (0.04, -0.93), (0.42, -0.84), (0.7, -0.56), (w + 0.06, -0.26), (w + 0.07, -0.08), (w + 0.06, 0.04)],
        [(part, -1.04), (0.08, -1.1), (0.5, -1.0), (0.82, -0.64), (w + 0.14, -0.3), (w + 0.12, -0.08), (w + 0.08, 0.06)],
        [(part, -1.2), (0.1, -1.25), (0.54, -1.13), (0.88, -0.72), (w + 0.19, -0.34), (w + 0.16, -0.08), (w + 0.1, 0.08)],
    ]
    for curves in (near, far):
        paint_sheet(pen, person, curves, 1500, rng, ragged=0.016, tidy=True, even=0.95, skin=skin)


def _swept_back(pen: Pen, person: Person, rng) -> None:
    """Ends at the nape, seen on both sides behind the ears."""
    w = person.shape.cheek
    side = [
        [(0.5, -0.5), (w - 0.06, 0.0), (w - 0.06, 0.4), (0.55, 0.85)],
        [(0.6, -0.8), (w + 0.07, -0.1), (w + 0.08, 0.3), (0.62, 0.88)],
        [(0.6, -1.0), (w + 0.15, -0.2), (w + 0.17, 0.25), (0.7, 0.86)],
    ]
    for curves in (side, _mirror(side)):
        paint_sheet(pen, person, curves, 700, rng, ragged=0.012, dim=0.6, blur=0.015, even=0.93)


def _nothing(pen: Pen, person: Person, rng) -> None:
    """No hair behind the head."""


STYLES = {"long": (_long_back, _long_front), "short": (_nothing, _short_front), "swept": (_swept_back, _swept_front)}


def paint_back(pen: Pen, person: Person, rng: np.random.Generator) -> None:
    """Hair behind the face."""
    STYLES[person.hair_style][0](pen, person, rng)


def paint_front(pen: Pen, person: Person, rng: np.random.Generator, skin: Pen) -> None:
    """Hair that grows from the forehead and lies over the head, with its shadow through the pen `skin`."""
    STYLES[person.hair_style][1](pen, person, rng, skin)
