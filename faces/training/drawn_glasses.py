# SPDX-License-Identifier: Apache-2.0
"""Glasses drawn before the eyes of a crop: dark ones, which hide them, and clear ones, shadows and brims, which do not; and
things that hide one eye alone.

Sizes are parts of the distance between the outer corners of the eyes, about 90 mm; lenses are 45 … 65 mm wide and 25 …
55 mm high, of a bridge of 14 … 24 mm (ISO 8624, boxed sizes on sale).
"""
from dataclasses import dataclass

import cv2
import numpy as np

DARK = (0.06, 0.5)    # how much of a pixel's value (gamma-coded) dark lenses let through: 0.2 … 20 % of the light
CLEAR = (0.75, 1.0)   # and clear or lightly tinted ones
CORNERS = 40          # of a lens's rim
FINE = 4              # bits of a pixel in which rims are placed


@dataclass
class Look:
    """What both lenses of a pair have in common."""
    half: np.ndarray   # width and height
    roundness: float   # exponent of a superellipse
    taper: float       # how much narrower it is below
    sag: float         # how far its outer half hangs down
    drop: float        # of its middle below the eye's

    @staticmethod
    def drawn(rng):
        wide = rng.uniform(0.24, 0.36)
        return Look(np.array([wide, wide * rng.uniform(0.5, 1.05)]), rng.uniform(2.0, 6.0), rng.uniform(-0.05, 0.25),
                    rng.uniform(-0.15, 0.2), rng.uniform(-0.02, 0.12))

    def rim(self, side, width, widest):
        """(CORNERS, 2): around the lens's middle, x outwards on `side` (−1 or 1)."""
        t = np.linspace(0.0, 2.0 * np.pi, CORNERS, endpoint=False)
        unit = np.stack([np.cos(t), np.sin(t)], -1)
        unit = np.sign(unit) * np.abs(unit) ** (2.0 / self.roundness)
        half = self.half * [width, 1.0]
        half[0] = min(half[0], widest)
        x, y = (unit * half).T
        x = x * (1.0 - self.taper * y / half[1])
        return np.stack([side * x, y + self.sag * x], -1)


class Face:
    """Middle, axes and unit of the eyes (32, 2) of a crop: the right one first."""

    def __init__(self, eyes):
        right, left = eyes[:16], eyes[16:]
        self.middles = np.stack([right.mean(0), left.mean(0)])
        across = left[0] - right[0]
        self.unit = max(float(np.linalg.norm(across)), 1.0)
        along = across / self.unit
        self.axes = np.stack([along, [-along[1], along[0]]])
        widths = np.array([np.ptp(eye @ along) for eye in (right, left)])
        self.widths = (widths / max(widths.mean(), 1e-6)) ** 0.7  # a turned head's far eye is narrower
        self.apart = float((self.middles[1] - self.middles[0]) @ along) / self.unit

    def back(self, lens, places):
        """From the middle of lens 0 or 1, in units, to px of the crop."""
        return self.middles[lens] + self.unit * places @ self.axes


def mask_of(shape, rim):
    mask = np.zeros(shape[:2], np.uint8)
    cv2.fillPoly(mask, [np.round(rim * (1 << FINE)).astype(np.int32)], 255, cv2.LINE_AA, FINE)
    return mask.astype(np.float32)[..., None] / 255.0


def stroke(picture, line, is_closed, colour, px):
    cv2.polylines(picture, [np.round(line * (1 << FINE)).astype(np.int32)], is_closed, colour, max(1, round(px)),
                  cv2.LINE_AA, FINE)


def slope(shape, face, rng):
    """0 at one end of the eyes' neighbourhood, 1 at the other: mostly from top to bottom."""
    angle = rng.normal(0.5 * np.pi, 0.4)
    y, x = np.mgrid[:shape[0], :shape[1]]
    off = ((x - face.middles[:, 0].mean()) * np.cos(angle) + (y - face.middles[:, 1].mean()) * np.sin(angle)) / face.unit
    return np.clip(off / 0.6 + 0.5, 0.0, 1.0).astype(np.float32)[..., None]


def mirrored_world(shape, face, rng):
    """What lenses may mirror: sky over ground, and a few soft lights, 0 … 255."""
    horizon = np.clip((slope(shape, face, rng) - rng.uniform(0.2, 0.8)) * rng.uniform(1.0, 12.0) + 0.5, 0.0, 1.0)
    sky, ground = rng.uniform(60, 255, 3), rng.uniform(0, 140, 3)
    world = (sky + horizon * (ground - sky)).astype(np.float32)
    for _ in range(rng.integers(0, 5)):
        at = face.middles[rng.integers(2)] + rng.normal(0.0, 0.18, 2) * face.unit
        axes = np.maximum(1, face.unit * rng.uniform(0.02, 0.2, 2)).astype(int)
        cv2.ellipse(world, tuple(at.astype(int).tolist()), tuple(axes.tolist()), rng.uniform(0, 180), 0, 360,
                    rng.uniform(0, 255, 3).tolist(), -1, cv2.LINE_AA)
    return cv2.GaussianBlur(world, (0, 0), 0.01 * face.unit * np.exp(rng.uniform(0.0, 2.0)) + 0.3)


def seen_through(crop, face, let_through, is_dark, rng):
    """The crop as the lenses show it: tinted, lighter towards one end, with what they mirror and some haze."""
    tint = np.clip(let_through * np.exp(rng.normal(0.0, 0.25 if is_dark else 0.05, 3)), 0.0, 1.0)
    ends = np.stack([tint, np.minimum(tint * rng.uniform(1.0, 3.5), 0.75 if is_dark else 1.0)])
    if rng.random() < 0.4:
        ends[1] = tint
    through = crop * (ends[0] + slope(crop.shape, face, rng) * (ends[1] - ends[0]))
    if is_dark:
        through = through + rng.uniform(0.0, 30.0)
    if rng.random() < (0.6 if is_dark else 0.15):
        share = rng.uniform(0.03, 0.3) if rng.random() < 0.8 or not is_dark else rng.uniform(0.3, 0.9)
        through = through + share * (mirrored_world(crop.shape, face, rng) - through)
    return through


def with_glasses(crop, eyes, is_dark, rng):
    """8-bit BGR crop with glasses before both eyes (32, 2)."""
    face, look = Face(eyes), Look.drawn(rng)
    bridge = rng.uniform(0.14, 0.26)
    widest = max(0.08, 0.5 * (face.apart - bridge) + rng.uniform(-0.03, 0.08))
    middle = [np.array([side * (look.half[0] - widest) * (look.half[0] > widest) + side * rng.uniform(0.0, 0.05),
                        look.drop]) for side in (-1, 1)]
    rims = [face.back(lens, middle[lens] + look.rim(side, face.widths[lens], max(widest, 0.2)))
            for lens, side in ((0, -1), (1, 1))]
    let_through = np.exp(rng.uniform(*np.log(DARK))) if is_dark else rng.uniform(*CLEAR)
    shown = crop.astype(np.float32)
    through = seen_through(shown, face, let_through, is_dark, rng)
    for rim in rims:
        shown = shown + mask_of(crop.shape, rim) * (through - shown)
    shown = np.ascontiguousarray(np.clip(shown, 0.0, 255.0).astype(np.uint8))
    if rng.random() < (0.75 if is_dark else 0.95):
        draw_frame(shown, face, rims, rng)
    return shown


def draw_frame(shown, face, rims, rng):
    colour = (rng.uniform(0, 60, 3) if rng.random() < 0.6 else rng.uniform(0, 255, 3)).tolist()
    px = face.unit * np.exp(rng.uniform(np.log(0.012), np.log(0.07)))
    for rim in rims:
        stroke(shown, rim, True, colour, px)
    inner = [rims[0][np.argmax(rims[0] @ face.axes[0])], rims[1][np.argmin(rims[1] @ face.axes[0])]]
    lift = rng.uniform(0.0, 0.1) * face.unit * face.axes[1]
    for line in [np.stack(inner) - lift] + ([np.stack(inner) - 2.0 * lift] if rng.random() < 0.3 else []):
        stroke(shown, line, False, colour, px)
    for lens, side in ((0, -1), (1, 1)):
        rim = rims[lens]
        outer = rim[np.argmax(side * (rim @ face.axes[0]))] - lift
        end = outer + face.unit * (side * rng.uniform(0.15, 0.35) * face.axes[0] - rng.uniform(-0.02, 0.08) * face.axes[1])
        stroke(shown, np.stack([outer, end]), False, colour, px)


def with_one_hidden(crop, eyes, rng):
    """Something before one eye alone, such as a patch, hair or a hand, dark or not: 8-bit in and out."""
    face, look, lens = Face(eyes), Look.drawn(rng), rng.integers(2)
    look.half = look.half * rng.uniform(0.6, 1.3)
    at = np.array([rng.normal(0.0, 0.05), rng.normal(0.0, 0.05)])
    mask = mask_of(crop.shape, face.back(lens, at + look.rim((-1, 1)[lens], 1.0, 0.5)))
    mask = cv2.GaussianBlur(mask, (0, 0), face.unit * np.exp(rng.uniform(np.log(0.004), np.log(0.05))))[..., None]
    colour = rng.uniform(0, 60, 3) if rng.random() < 0.6 else rng.uniform(0, 255, 3)
    return (crop + mask * rng.uniform(0.8, 1.0) * (colour - crop)).astype(np.uint8)


def with_shadow(crop, eyes, rng):
    """Sockets in the shade, or a brim's shadow over the eyes: 8-bit in and out. The eyes are seen in it."""
    face = Face(eyes)
    if rng.random() < 0.5:
        mask = np.zeros(crop.shape[:2], np.float32)
        for lens in (0, 1):
            at = face.back(lens, np.array([0.0, rng.uniform(-0.08, 0.06)]))
            axes = np.maximum(1, face.unit * rng.uniform([0.18, 0.08], [0.4, 0.25])).astype(int)
            cv2.ellipse(mask, tuple(at.astype(int).tolist()), tuple(axes.tolist()), 0.0, 0, 360, 1.0, -1)
        mask = cv2.GaussianBlur(mask, (0, 0), face.unit * rng.uniform(0.05, 0.15))[..., None]
    else:
        edge = rng.uniform(0.45, 0.95)  # of the slope, above which it is dark
        mask = np.clip((edge - slope(crop.shape, face, rng)) * rng.uniform(4.0, 40.0), 0.0, 1.0)
    return (crop * (1.0 - mask * rng.uniform(0.2, 0.85))).astype(np.uint8)
