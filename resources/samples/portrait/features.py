# SPDX-License-Identifier: Apache-2.0
"""What is painted onto the lit head beside the eyes: brows, nostrils, folds, the opening of the mouth."""

from __future__ import annotations

import numpy as np

from .canvas import Pen
from .curves import smoothstep, spline
from .people import Contours, Expression, Person, srgb
from .relief import across

_SHADE = np.array([0.42, 0.27, 0.23], np.float32)  # a shadow on skin keeps more red than blue
_DEEP = np.array([0.16, 0.07, 0.06], np.float32)
_SIDES = (np.array([-1.0, 1.0]), np.array([1.0, 1.0]))  # factors on points for the picture's left and right


def _brow_spine(person: Person, e: Expression) -> np.ndarray:
    """Middle line of the brow on the picture's right, from the nose outwards."""
    y = person.shape.brow
    return spline([
        (0.135 - e.brow_close, y + 0.03 + e.brow_inner),
        (0.27 - 0.4 * e.brow_close, y - 0.022 + 0.55 * e.brow_middle + 0.45 * e.brow_inner),
        (0.44, y - 0.05 + 0.65 * e.brow_middle + 0.35 * e.brow_outer),
        (0.62, y + 0.025 + e.brow_outer),
    ]).points(20)


def _brow_hair(spine: np.ndarray, thick: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Root, middle and tip of one hair: upright near the nose, lying along the brow farther out."""
    u = rng.uniform(0, 1) ** 0.92
    i = min(int(u * (len(spine) - 1)), len(spine) - 2)
    heading = spine[i + 1] - spine[i]
    offset = rng.uniform(-0.5, 0.5)  # 0.5: at the lower rim
    lift = np.interp(u, [0, 0.18, 0.5, 1], [0.95, 0.6, 0.4, 0.15]) * (0.75 + 0.6 * offset)
    angle = np.arctan2(heading[1], heading[0]) - lift + rng.normal(0, 0.10)
    hair = (0.062 - 0.018 * u) * rng.uniform(0.6, 1.1) * np.array([np.cos(angle), np.sin(angle)])
    root = spine[i] + [0, offset * thick[i]] - 0.4 * hair
    return np.array([root, root + 0.5 * hair + [0, -0.004], root + hair])


def paint_brows(pen: Pen, person: Person, e: Expression, rng: np.random.Generator) -> None:
    """Two brows of single hairs over a soft shade."""
    weight, spine = person.shape.brow_weight, _brow_spine(person, e)
    colour = person.hair * 0.7 if person.brow_colour is None else person.brow_colour
    t = np.linspace(0, 1, len(spine))
    thick = weight * 0.068 * np.minimum(1, 0.6 + 2.2 * t) * np.clip(1.12 - t, 0.14, 1) ** 0.62
    rise = np.c_[np.zeros_like(t), 0.42 * thick]
    ribbon = np.vstack([spine - rise, (spine + rise)[::-1]])
    for flip in _SIDES:
        pen.tint(pen.area(ribbon * flip, 0.012), 0.25 + 0.75 * colour / max(colour.max(), 0.2), 0.6 * min(weight, 1.1))
        for _ in range(int(330 * weight)):
            hair = _brow_hair(spine, thick, rng) * flip
            pen.tapered(hair, [0.0055, 0.0048, 0.001], colour * rng.uniform(0.5, 1.3), 0.6)


def _nose_shadow(pen: Pen, n: float, w: float) -> None:
    """Shadow of a nose that ends at height `n`, `w` wide to each side: under it, and beside it away from the light."""
    under = spline([(-w + 0.03, n), (-0.07, n + 0.025), (0, n + 0.04), (0.1, n + 0.03), (w - 0.015, n + 0.01),
                    (w, n + 0.055), (0.09, n + 0.1), (-0.05, n + 0.085)]).points()
    beside = [(0.05, 0.05), (0.1, 0.2), (0.15, n - 0.05), (0.2, n), (0.24, n - 0.06), (0.16, 0.1)]
    pen.tint(pen.area(under, 0.024), _SHADE, 0.55)
    pen.tint(pen.area(beside, 0.035), _SHADE, 0.25)


def paint_nose(pen: Pen, person: Person) -> None:
    """Nostrils, the folds round the wings, and the shadow that the nose casts."""
    n, w = person.shape.nose, person.shape.nose_width
    _nose_shadow(pen, n, w)
    hole = spline([(0.038, n - 0.002), (0.06, n - 0.022), (0.1, n - 0.028), (0.122, n - 0.01), (0.1, n + 0.008),
                   (0.06, n + 0.012), (0.038, n - 0.002)]).points()
    wing = spline([(w - 0.045, n - 0.13), (w - 0.004, n - 0.085), (w + 0.002, n - 0.03), (w - 0.035, n + 0.012),
                   (w - 0.075, n + 0.014)]).points()
    for flip in _SIDES:
        pen.tint(pen.area(hole * flip, 0.0085), _DEEP, 0.98)
        pen.tint(pen.line(wing[10:] * flip, 0.009, 0.008), _SHADE, 0.8)
        pen.tint(pen.line(wing * flip * [1.06, 1], 0.02, 0.022), _SHADE, 0.5)


def _cheek_folds(pen: Pen, person: Person, e: Expression) -> None:
    """Fold from each wing of the nose past the mouth's corner, and the dimple at that corner."""
    s, depth = person.shape, np.clip(0.9 * e.fold + 0.3 * person.age, 0, 1)
    n, mw, my = s.nose, s.mouth_width * e.mouth_width, s.mouth + e.mouth_shift + e.corner
    fold = spline([(s.nose_width, n - 0.1), (s.nose_width + 0.06, n - 0.02), (mw + 0.04, 0.55 * n + 0.45 * my),
                   (mw + 0.085, my - 0.03), (mw + 0.07, my + 0.06)]).points()
    dimple = spline([(mw - 0.012, my - 0.008), (mw + 0.012, my + 0.006), (mw + 0.022, my + 0.03)]).points()
    bright = np.array([1.22, 1.18, 1.15], np.float32)
    for flip in _SIDES:
        pen.tint(pen.line(fold * flip, 0.014, 0.012), _SHADE, 0.62 * depth)
        pen.tint(pen.line((fold + [-0.02, 0.012]) * flip, 0.05, 0.035), _SHADE, 0.42 * depth)
        pen.tint(pen.line((fold[:-10] + [0.05, -0.01]) * flip, 0.045, 0.035), bright, 0.5 * depth)
        pen.tint(pen.line(dimple * flip, 0.016, 0.013), _SHADE, 0.75)


def _brow_folds(pen: Pen, person: Person, e: Expression) -> None:
    """Upright folds between the brows and the level ones across the forehead."""
    y = person.shape.brow
    upright = spline([(0.05, y + 0.06), (0.062, y - 0.02), (0.05, y - 0.1)]).points()
    hollow = np.array([(0.08, -0.13), (0.22, -0.13), (0.24, -0.06), (0.1, -0.04)])
    for flip in _SIDES:
        pen.tint(pen.line(upright * flip, 0.012, 0.012), _SHADE, 0.7 * e.frown)
        pen.tint(pen.area(hollow * flip, 0.035), _SHADE, 0.5 * e.frown)
    for strength, y in ((0.5, -0.38), (0.42, -0.46), (0.34, -0.54)):
        level = spline([(-0.36, y + 0.05), (-0.18, y), (0, y + 0.012), (0.2, y - 0.004), (0.38, y + 0.05)]).points()
        pen.tint(pen.line(level, 0.008, 0.009), _SHADE, strength * max(e.forehead, 0.4 * person.age))


def paint_folds(pen: Pen, person: Person, e: Expression) -> None:
    """Lines of the face, and the shade under the lower lip."""
    _cheek_folds(pen, person, e)
    _brow_folds(pen, person, e)
    low = person.shape.mouth + e.mouth_shift + e.open_low + person.shape.lower_lip * e.lip_thin
    under = spline([(-0.13, low + 0.03), (0, low + 0.04), (0.13, low + 0.03)]).points()
    pen.tint(pen.line(under, 0.03, 0.022), _SHADE, 0.42)


def _teeth(x, y, top, length: float, half: float) -> tuple[np.ndarray, np.ndarray]:
    """Share and colour of the upper teeth under the edge `top`; the row curves back and darkens towards its ends."""
    u = np.clip(x / half, -1, 1)
    tooth = np.abs(np.arcsin(u)) / (np.pi / 2) * 5  # equal teeth along an arch, seen from the front
    gap = np.abs(tooth - np.round(tooth)) * (1 - 0.4 * u * u)
    shorter = 0.09 * (np.round(tooth - 0.5) == 1) + 0.35 * u**2 + 0.08 * np.clip(1 - gap / 0.16, 0, 1)
    share = smoothstep(0.008, -0.008, y - top - length * (1 - shorter)) * smoothstep(1.0, 0.97, np.abs(x / half))
    light = (1 - 0.55 * np.abs(u) ** 2.2) * (1 - 0.30 * smoothstep(0.07, 0.0, gap))
    light = light * (0.5 + 0.5 * smoothstep(-0.004, 0.035, y - top))
    return share, srgb(236, 226, 208) * 0.88 * light[..., None]


def _cavity(x, y, top, low, half: float, e: Expression) -> np.ndarray:
    """Colour inside the mouth, whose opening lies between `top` and `low` and is `half` wide to each side."""
    colour = np.broadcast_to(srgb(46, 16, 16) * 0.6, x.shape + (3,)).copy()
    if e.tongue:
        tongue = smoothstep(0.0, 0.05, y - (low - 0.085 + 0.9 * x * x)) * smoothstep(0.75, 0.45, np.abs(x) / half)
        colour += (srgb(150, 66, 64) * 0.55 - colour) * tongue[..., None]
    if e.teeth > 0:
        share, white = _teeth(x, y, top, e.teeth, 0.86 * half)
        colour += (white - colour) * share[..., None]
        rim = smoothstep(0.0, 0.03, y - top) * smoothstep(-0.002, 0.012, low - y)
        colour *= (0.45 + 0.55 * rim)[..., None]
    return colour


def paint_mouth(pen: Pen, person: Person, e: Expression, c: Contours) -> None:
    """The opening between the lips and the shade along its edges."""
    mask = pen.area(np.vstack([c.mouth_up.points(), c.mouth_low.points()[::-1]]))
    x, y = mask.grid(pen.frame)
    half = person.shape.mouth_width * e.mouth_width
    pen.paint(mask, _cavity(x, y, across(c.mouth_up, x), across(c.mouth_low, x), half, e))
    for path, strength in ((c.mouth_up, 0.75), (c.mouth_low, 0.45)):
        pen.tint(pen.line(path.points(), 0.008, 0.006), _SHADE, strength)
