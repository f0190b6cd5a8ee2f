# SPDX-License-Identifier: Apache-2.0
"""The bare head: neck, ears, garment, and the lit skin of the face with its lips."""

from __future__ import annotations

import cv2
import numpy as np

from .canvas import Mask, Pen
from .curves import joined, smoothstep, spline
from .people import Contours, Expression, Person
from .relief import cushion, face_features, dome, lit, noise, normals, occlusion

_SHADE = np.array([0.50, 0.36, 0.31], np.float32)  # a shadow on skin keeps more red than blue
_CAST = np.array([0.40, 0.27, 0.23], np.float32)  # where the main light does not reach


def skull(person: Person, c: Contours) -> np.ndarray:
    """Closed polygon of the face's outline and the head above it."""
    w = person.shape.cheek
    right = [(w, 0.0), (w + 0.005, -0.25), (w - 0.05, -0.55), (w - 0.22, -0.86), (0.3, -1.02), (0.0, -1.07)]
    top = spline(right + [(-x, y) for x, y in right[-2::-1]])
    return joined(c.outline, top).points()


def paint_garment(pen: Pen, person: Person, rng: np.random.Generator) -> None:
    """Shoulders and cloth down to below the picture's edge."""
    half = [(0.47, 1.67), (0.62, 1.70), (0.95, 1.79), (1.45, 1.93), (1.8, 2.2), (1.95, 2.9), (2.0, 4.0), (2.0, 6.0)]
    neck = [(-0.3, 1.84), (0, 1.93), (0.3, 1.84)] if person.collar == "round" else [(-0.25, 1.8), (0, 2.08), (0.25, 1.8)]
    body = np.vstack([spline([(-x, y) for x, y in half[::-1]] + neck + half).points(), [(0, 6.0)]])
    mask = pen.area(body)
    if mask is None:
        return
    x, y = mask.grid(pen.frame)
    rough = lambda sigma: noise(mask.values.shape, sigma * pen.unit, rng)
    weave = 1 + 0.03 * rough(0.006) + 0.025 * rough(0.12)
    folds = 0.006 * rough(0.1) + 0.02 * np.sin(9 * (np.abs(x) - 0.35 * y))
    z = dome(mask, 0.7, 0.45, pen.unit) + folds
    pen.paint(mask, lit(person.garment * weave[..., None], normals(z, pen.unit)))
    if person.collar == "shirt":
        _paint_collar(pen, person)
    else:
        pen.tint(pen.line(spline([(-0.5, 1.68)] + neck + [(0.5, 1.68)]).points(), 0.03, 0.012), 0.75)


def _paint_collar(pen: Pen, person: Person) -> None:
    """Two folded wings of a shirt's collar and the button line."""
    for side in (-1, 1):
        wing = np.array([(0.52, 1.55), (0.3, 1.72), (0.02, 2.06), (0.3, 2.28), (0.62, 1.9), (0.66, 1.68)]) * [side, 1]
        pen.tint(pen.area(wing + [0.01, 0.03], 0.02), 0.6)
        cushion(pen, wing, person.garment * 1.06, 0.12, 0.03)
    pen.tint(pen.line([(0, 2.1), (0.01, 6)], 0.012, 0.006), 0.7)


def paint_neck(pen: Pen, person: Person, c: Contours, jaw_drop: float) -> None:
    """Neck with the shadow that the chin casts on it."""
    w = person.shape.jaw * 0.79
    half = [(w + 0.03, 0.7), (w, 1.1), (w - 0.01, 1.4), (w + 0.06, 1.64), (w + 0.32, 1.8)]
    right = spline(half).points()
    body = np.vstack([right, [(0.25, 2.3), (0, 2.45), (-0.25, 2.3)], (right * [-1, 1])[::-1]])
    cushion(pen, body, person.skin * np.array([0.80, 0.77, 0.76]), 0.42, 0.4)
    for side in (-1, 1):
        pen.tint(pen.line(np.array([(0.36, 1.25), (0.2, 1.6), (0.07, 1.8)]) * [side, 1], 0.035, 0.035), _SHADE, 0.3)
        pen.tint(pen.line(np.array([(0.1, 1.82), (0.35, 1.76), (0.62, 1.74)]) * [side, 1], 0.03, 0.025), _SHADE, 0.4)
    chin = c.outline.points()
    pen = pen.clipped(pen.area(body))
    pen.tint(pen.area(chin * [0.97, 1] + [0.06, 0.22], 0.04), _CAST, 0.95)
    pen.tint(pen.area(chin + [0.01, 0.05], 0.035), _SHADE, 0.85)


def paint_ears(pen: Pen, person: Person) -> None:
    """Both ears, partly behind the head."""
    w = person.shape.cheek
    rim = spline([(w - 0.06, -0.06), (w + 0.045, -0.115), (w + 0.115, -0.05), (w + 0.11, 0.12), (w + 0.06, 0.27),
                  (w + 0.035, 0.38), (w - 0.05, 0.42), (w - 0.1, 0.3)]).points()
    bowl = spline([(w + 0.01, 0.0), (w + 0.06, 0.02), (w + 0.065, 0.13), (w + 0.03, 0.25), (w - 0.02, 0.28)]).points()
    fold = spline([(w - 0.01, -0.05), (w + 0.05, -0.065), (w + 0.085, 0.0), (w + 0.075, 0.14), (w + 0.045, 0.24)]).points()
    for side in (-1, 1):
        flip = np.array([side, 1.0])
        cushion(pen, rim * flip, person.skin * np.array([0.98, 0.84, 0.80]), 0.07, 0.05, 0.4)
        pen.tint(pen.area(bowl * flip, 0.012), _CAST, 0.75)
        pen.tint(pen.line(fold * flip, 0.012, 0.007), _SHADE, 0.85)
        behind = np.array([(w - 0.2, -0.1), (w + 0.025, -0.02), (w + 0.02, 0.4), (w - 0.2, 0.45)])
        pen.tint(pen.area(behind * flip, 0.014), _SHADE, 0.6)


def _skin(mask: Mask, pen: Pen, person: Person, e: Expression, rng: np.random.Generator) -> np.ndarray:
    """Colour of the skin before light: redder cheeks and nose, darker round the eyes, mottled, freckled by pores."""
    x, y = mask.grid(pen.frame)
    side, s = np.abs(x), person.shape
    spot = lambda cx, cy, sx, sy: np.exp(-0.5 * (((side - cx) / sx) ** 2 + ((y - cy) / sy) ** 2))
    red = (0.55 * spot(0.43, 0.34, 0.16, 0.13) + 0.5 * spot(0, s.nose - 0.06, 0.13, 0.07)
           + 0.25 * spot(0, s.chin - 0.12, 0.14, 0.08))
    dark = 0.5 * spot(0.34, 0.0, 0.17, 0.085) + 0.25 * spot(0.3, 0.13, 0.14, 0.03)
    shape = mask.values.shape
    red = red * (0.7 + 0.3 * (person.stubble == 0)) + 0.13 * noise(shape, 0.07 * pen.unit, rng)
    tone = person.skin * np.exp(red[..., None] * np.array([0.03, -0.2, -0.16], np.float32))
    tone = tone * np.exp(dark[..., None] * np.array([-0.22, -0.34, -0.30], np.float32))
    grain = 0.028 * noise(shape, 0.004 * pen.unit, rng) + 0.022 * noise(shape, 0.016 * pen.unit, rng)
    return tone * _beard(x, y, person, e, rng)[..., None] * (1 + grain[..., None])


def _beard(x, y, person: Person, e: Expression, rng: np.random.Generator) -> np.ndarray:
    """Factor on the skin where a shaven beard shows: jaw, chin and upper lip."""
    if person.stubble <= 0:
        return np.ones_like(x)
    s, side = person.shape, np.abs(x)
    cheek = smoothstep(0.5, 0.75, y + 0.5 * (side - 0.5)) * smoothstep(0.12, 0.3, side)
    lip = smoothstep(s.nose + 0.03, s.nose + 0.1, y) * smoothstep(0.36, 0.24, side)
    cover = np.maximum(cheek, lip) * (1 - 0.5 * np.exp(-0.5 * ((side / 0.12) ** 2 + ((y - s.chin + 0.33) / 0.05) ** 2)))
    dots = np.clip(noise(x.shape, 0.9, rng), 0, None)
    return 1 - person.stubble * cover * (0.34 + 0.16 * dots)


def _lip_colour(pen: Pen, mask: Mask, person: Person, c: Contours,
                rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Share of lip colour at each place of `mask`, and that colour with its fine upright lines."""
    lips = pen.area(c.truth()["outer_lip"].points(), 0.005)
    share = np.zeros_like(mask.values)
    top, left = lips.rows.start - mask.rows.start, lips.columns.start - mask.columns.start
    height, width = lips.values.shape
    share[top : top + height, left : left + width] = lips.values
    lines = cv2.GaussianBlur(noise(mask.values.shape, 1.5, rng), (0, 0), sigmaX=0.1, sigmaY=0.03 * pen.unit)
    return share, person.lips * (1 + 0.10 * lines[..., None])


def paint_face(pen: Pen, person: Person, e: Expression, c: Contours, rng: np.random.Generator) -> None:
    """The lit skin of head and lips, without eyes, brows, nostrils, mouth opening and hair."""
    mask = pen.area(skull(person, c))
    x, y = mask.grid(pen.frame)
    detail = face_features(x, y, person, e, c)
    detail = cv2.GaussianBlur(detail, (0, 0), 0.008 * pen.unit)
    share, lip = _lip_colour(pen, mask, person, c, rng)
    albedo = _skin(mask, pen, person, e, rng)
    albedo += (lip - albedo) * (0.88 * share)[..., None]
    pores = 0.00035 * noise(x.shape, 0.006 * pen.unit, rng) + 0.0006 * noise(x.shape, 0.035 * pen.unit, rng)
    n = normals(dome(mask, 0.74, 0.6, pen.unit) + detail + pores, pen.unit)
    shade = occlusion(detail, pen.unit)[..., None] ** np.array([0.75, 1.0, 1.1], np.float32)
    pen.paint(mask, lit(albedo, n, 0.45) * shade)
