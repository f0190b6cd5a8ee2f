# SPDX-License-Identifier: Apache-2.0
"""Height fields of skin and cloth, and the light that falls on them (heights in face units, towards the viewer)."""

from __future__ import annotations

import cv2
import numpy as np

from .canvas import Mask, Pen
from .curves import smoothstep
from .people import Contours, Expression, Person, Shape

_KEY = np.array([-0.42, -0.5, 0.757], np.float32)  # towards the main light: up and to the picture's left
_FILL = np.array([0.7, -0.05, 0.71], np.float32)
_BOUNCE = np.array([0.15, 0.10, 0.085], np.float32)  # light thrown back from chest and shoulders
_WRAP = np.array([0.42, 0.27, 0.22], np.float32)  # light bleeds around edges of skin, red the farthest


def noise(shape, sigma: float, rng: np.random.Generator) -> np.ndarray:
    """Smooth noise of unit standard deviation; `sigma` in samples (coarse noise is drawn small and enlarged)."""
    step = max(1, int(sigma / 3))
    small = rng.normal(0, 1, (shape[0] // step + 8, shape[1] // step + 8)).astype(np.float32)
    field = cv2.GaussianBlur(small, (0, 0), max(sigma / step, 0.3))
    field = cv2.resize(field, None, fx=step, fy=step, interpolation=cv2.INTER_CUBIC)[: shape[0], : shape[1]]
    return field / max(float(field.std()), 1e-6)


def dome(mask: Mask, radius: float, height: float, unit: float) -> np.ndarray:
    """A cushion over the mask: a quarter circle of `radius` from its rim inwards, flat beyond, `height` tall."""
    inside = (mask.values > 0.5).astype(np.uint8)
    d = np.clip(cv2.distanceTransform(inside, cv2.DIST_L2, 5) / unit / radius, 0, 1)
    z = height * np.sqrt(1 - (1 - d) ** 2)
    rim, middle = (cv2.GaussianBlur(z, (0, 0), share * radius * unit + 0.8) for share in (0.008, 0.055))
    return rim + (middle - rim) * smoothstep(0.06, 0.26, d)  # soft over the ridges inside, steep at the rim


def normals(z: np.ndarray, unit: float) -> np.ndarray:
    """Unit normals of a height field sampled `unit` times a face unit."""
    dy, dx = np.gradient(z * np.float32(unit))
    n = np.dstack([-dx, -dy, np.ones_like(z)])
    return n / np.linalg.norm(n, axis=2, keepdims=True)


def lit(albedo: np.ndarray, n: np.ndarray, gloss: float = 0.0) -> np.ndarray:
    """Reflected light of a surface: soft main light, weak fill, sky from above, and a broad sheen."""
    key = np.clip(((n @ _KEY)[..., None] + _WRAP) / (1 + _WRAP), 0, None)
    fill = np.clip(n @ _FILL, 0, None)[..., None]
    sky = (0.62 - 0.38 * n[..., 1])[..., None]
    bounce = np.clip(n[..., 1] + 0.1, 0, None)[..., None] * _BOUNCE
    out = albedo * (0.90 * key + 0.13 * fill + 0.22 * sky + bounce)
    if gloss > 0:
        half = _KEY + np.array([0, 0, 1], np.float32)
        half /= np.linalg.norm(half)
        shine = np.clip(n @ half, 0, 1)
        out += gloss * (0.10 * shine**14 + 0.09 * shine**60)[..., None]
    return out


def cushion(pen: Pen, polygon, colour, radius: float, height: float, gloss: float = 0.0, blur: float = 0.0) -> None:
    """Paint a plain rounded body (neck, ear, garment) with the common light."""
    mask = pen.area(polygon, blur)
    if mask is None:
        return
    albedo = np.broadcast_to(np.asarray(colour, np.float32), mask.values.shape + (3,))
    pen.paint(mask, lit(albedo, normals(dome(mask, radius, height, pen.unit), pen.unit), gloss))


def _bump(x, y, cx: float, cy: float, sx: float, sy: float) -> np.ndarray:
    return np.exp(-0.5 * (((x - cx) / sx) ** 2 + ((y - cy) / sy) ** 2))


def _nose(x, y, s: Shape) -> np.ndarray:
    """Bridge, tip and wings; the underside drops steeply at the height `s.nose`."""
    tip = s.nose - 0.065
    rise = 0.035 + 0.165 * smoothstep(-0.1, tip, y) ** 1.4
    lift = 0.065 * np.clip(x / s.nose_width, 0, 1) ** 1.5  # the underside rises towards the wings
    under = smoothstep(s.nose + 0.05, s.nose - 0.06, y + lift)
    width = 0.052 + 0.05 * smoothstep(0.05, tip, y)
    bridge = rise * under * smoothstep(-0.32, -0.02, y) * np.exp(-0.5 * np.abs(x / width) ** 2.3)
    ball = 0.045 * _bump(x, y, 0, tip, 0.062, 0.055)
    wing = 0.105 * _bump(x, y, s.nose_width - 0.062, s.nose - 0.048, 0.04, 0.045)
    wing = wing * smoothstep(s.nose + 0.03, s.nose - 0.04, y)
    return bridge + ball + wing


def _sockets(x, y, s: Shape, e: Expression) -> np.ndarray:
    """Brow ridge, hollows around the eyes and the balls in them (`x` is the distance from the middle)."""
    middle = 0.5 * (0.5 + s.eye_inner)
    brow = 0.032 * _bump(x, y, 0.32, s.brow + 0.02 + 0.5 * e.brow_middle, 0.2, 0.07)
    hollow = -0.058 * _bump(x, y, middle, -0.03, 0.19, 0.11) - 0.045 * _bump(x, y, 0.15, -0.03, 0.05, 0.08)
    ball = 0.042 * _bump(x, y, middle, 0.0, 0.1, 0.075)
    bag = 0.008 * _bump(x, y, middle, 0.12, 0.12, 0.03)
    return brow + hollow + ball + bag


def _cheeks(x, y, s: Shape, e: Expression) -> np.ndarray:
    lift = e.cheek_lift
    bone = (0.035 + 0.04 * lift) * _bump(x, y, 0.42, 0.30 - 0.04 * lift, 0.17 - 0.03 * lift, 0.15 - 0.03 * lift)
    hollow = -0.02 * _bump(x, y, 0.54, 0.62, 0.1, 0.2)
    temple = -0.03 * _bump(x, y, s.cheek - 0.06, -0.25, 0.08, 0.18)
    return bone + hollow + temple


def _lower_face(x, y, s: Shape, e: Expression) -> np.ndarray:
    """Bulge behind the lips, hollow under them, chin, groove over the upper lip."""
    mouth, chin = s.mouth + e.mouth_shift, s.chin + e.jaw_drop
    low = mouth + e.open_low + s.lower_lip
    muzzle = 0.05 * _bump(x, y, 0, mouth, 0.25, 0.16)
    under = -0.03 * _bump(x, y, 0, low + 0.06, 0.15, 0.045)
    ball = 0.055 * _bump(x, y, 0, chin - 0.16, 0.16, 0.09)
    groove = -0.008 * _bump(x, y, 0, 0.5 * (s.nose + mouth) - 0.03, 0.022, 0.06)
    corner = -0.02 * _bump(x, y, s.mouth_width * e.mouth_width + 0.02, mouth + e.corner, 0.035, 0.04)
    return muzzle + under + ball + groove + corner


def across(path, x: np.ndarray) -> np.ndarray:
    """Height of a left-to-right edge at each `x`, held constant beyond its ends."""
    p = path.points()
    order = np.argsort(p[:, 0])
    return np.interp(x, p[order, 0], p[order, 1]).astype(np.float32)


def _lips(x, y, c: Contours) -> np.ndarray:
    """Two rolls between the outer and inner edges of the lips; the lower one is fuller."""
    edges = [across(p, x) for p in (c.lip_up, c.mouth_up, c.mouth_low, c.lip_low)]
    roll = lambda top, low: np.sin(3.1415 * np.clip((y - top) / np.maximum(low - top, 1e-3), 0, 1))
    ends = c.lip_up.points()[[0, -1], 0]
    inside = smoothstep(ends[0], ends[0] + 0.1, x) * smoothstep(ends[1], ends[1] - 0.1, x)
    return inside * (0.028 * roll(edges[0], edges[1]) ** 0.8 + 0.042 * roll(edges[2], edges[3]) ** 0.8)


def face_features(x, y, person: Person, e: Expression, c: Contours) -> np.ndarray:
    """Everything that stands out from or sinks into the plain dome of the head."""
    s, side = person.shape, np.abs(x)
    forehead = 0.03 * _bump(x, y, 0, -0.42, 0.3, 0.16)
    return (_nose(side, y, s) + _sockets(side, y, s, e) + _cheeks(side, y, s, e) + _lower_face(side, y, s, e)
            + _lips(x, y, c) + forehead)


def occlusion(z: np.ndarray, unit: float) -> np.ndarray:
    """Share of ambient light that reaches each place: less where the neighbourhood stands higher."""
    out = np.ones_like(z)
    for sigma, depth in ((0.03, 4.0), (0.09, 2.2)):
        out -= depth * np.clip(cv2.GaussianBlur(z, (0, 0), sigma * unit) - z, 0, None)
    return np.clip(out, 0.35, 1)
