# SPDX-License-Identifier: Apache-2.0
"""Faces that portraits seldom show, made by moving their pixels: mouths that open, lids that close, other lips.

A warp is given as the source place of every pixel; the labels move by the same rule forwards.
"""
import cv2
import numpy as np

from contours import SLICES

LOWER, UPPER = slice(0, 11), [0, *range(19, 9, -1)]  # of a lip's 20 points, both from corner 0 to corner 10


class CornerFrame:
    """u along the line from one corner to the other, v across it (down the face), both in px."""

    def __init__(self, first, second):
        self.origin, self.width = first, float(np.linalg.norm(second - first))
        across = (second - first) / self.width
        self.axes = np.stack([across, [-across[1], across[0]]])

    def of(self, points):
        return (points - self.origin) @ self.axes.T

    def back(self, uv):
        return uv @ self.axes + self.origin

    def grid(self, low, high):
        """u and v of the middle of every pixel of a part of the picture: two (h, w)."""
        y, x = np.mgrid[low[1]:high[1], low[0]:high[0]] + 0.5
        uv = self.of(np.stack([x, y], -1))
        return uv[..., 0], uv[..., 1]


def window(picture, points, reach):
    """Corners (low, high) of the part of the picture within `reach` px of the points."""
    limit = np.array(picture.shape[1::-1])
    low = np.clip(np.floor(points.min(0) - reach), 0, limit - 1).astype(int)
    high = np.clip(np.ceil(points.max(0) + reach), low + 1, limit).astype(int)
    return low, high


def remapped(picture, frame, low, high, u, v):
    """The part of the picture whose pixels come from (u, v): float32."""
    source = (frame.back(np.stack([u, v], -1)) - 0.5).astype(np.float32)
    return cv2.remap(picture, source[..., 0], source[..., 1], cv2.INTER_LINEAR,
                     borderMode=cv2.BORDER_REPLICATE).astype(np.float32)


def smooth_step(t):
    t = np.clip(t, 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def opened_mouth(picture, points, rng):
    """Lower lip and jaw go down by a quarter to all of the mouth's width; what appears between the lips is painted
    as teeth, tongue and dark. Returns picture and points."""
    inner = points[SLICES["inner_lip"]]
    frame = CornerFrame(inner[0], inner[10])
    width, middle = frame.width, 0.5 * frame.width
    upper, lower = frame.of(inner[UPPER]), frame.of(inner[LOWER])
    drop = width * rng.uniform(0.1, 0.95)

    def upper_edge(u):
        return np.interp(u, upper[:, 0], upper[:, 1], 0.0, 0.0)

    def lower_edge(u):
        return np.maximum(np.interp(u, lower[:, 0], lower[:, 1], 0.0, 0.0), upper_edge(u))

    def lip_drop(u):
        return drop * np.clip(1.0 - ((u - middle) / middle) ** 2, 0.0, 1.0) ** 0.6

    def jaw_drop(u):
        return drop * np.exp(-((u - middle) / (1.25 * width)) ** 2)

    def moved_down(u, v):
        """How far a point below the lower lip's inner edge moves: with the lip, further down with the jaw."""
        t = smooth_step((v - lower_edge(u)) / (0.7 * width))
        return lip_drop(u) * (1.0 - t) + jaw_drop(u) * t

    # Labels: what lies on or below the inner edge of the lower lip moves.
    uv = frame.of(points)
    below = uv[:, 1] >= lower_edge(uv[:, 0]) - 0.02 * width
    in_mouth = (uv[:, 0] > 0.0) & (uv[:, 0] < width)
    below &= in_mouth | (uv[:, 1] > 0.02 * width)
    below[SLICES["inner_lip"]] = np.isin(np.arange(20), range(1, 10))
    below[SLICES["outer_lip"]] = np.isin(np.arange(20), range(1, 10))
    new = uv.copy()
    new[below, 1] += moved_down(uv[below, 0], uv[below, 1])

    # Pixels: solve place = source + moved_down(source) for the source.
    low, high = window(picture, points, 0.1 * width)
    low[0], high[:] = 0, picture.shape[1::-1]  # neck and shoulders move with the jaw
    u, v = frame.grid(low, high)
    source = v - lip_drop(u)
    for _ in range(8):
        source = v - moved_down(u, source)
    inside = (u > 0.0) & (u < width)
    top, bottom = upper_edge(u), lower_edge(u) + lip_drop(u)
    below_mouth = (v >= bottom) & (inside | (v > 0.0))
    gap = inside & (v > top) & (v < bottom)
    was_open = lower_edge(u) - top
    shown = np.where(gap, top + np.minimum(v - top, 0.85 * was_open), np.where(below_mouth, source, v))
    out = remapped(picture, frame, low, high, u, shown)
    paint_mouth(out, gap, v - top, bottom - v, was_open, width, drop, rng)
    result = picture.copy()
    result[low[1]:high[1], low[0]:high[0]] = np.clip(out, 0, 255).astype(np.uint8)
    return result, frame.back(new)


def paint_mouth(out, gap, from_top, from_bottom, was_open, width, drop, rng):
    """Upper teeth (sometimes), then the dark with a tongue (sometimes), in the gap of an opened mouth."""
    teeth_seen = was_open.max() > 0.07 * width
    teeth = np.where(teeth_seen, 0.8 * was_open, width * rng.uniform(0.06, 0.16) * (rng.random() < 0.55))
    if not teeth_seen and teeth.max() > 0.0:
        blend(out, gap & (from_top < teeth), rng.uniform(150, 225) + rng.normal(0, 8, 3), width / 60)
    dark = np.array([rng.uniform(10, 50), rng.uniform(10, 50), rng.uniform(25, 90)]) * rng.uniform(0.4, 1.2)
    colour = np.broadcast_to(dark, out.shape)
    if rng.random() < 0.5:
        tongue = np.array([rng.uniform(60, 110), rng.uniform(60, 110), rng.uniform(140, 200)]) * rng.uniform(0.5, 1)
        part = np.clip(1.0 - from_bottom / (drop * rng.uniform(0.3, 0.7)), 0.0, 1.0)[..., None]
        colour = dark * (1 - part) + tongue * part
    blend(out, gap * np.clip((from_top - teeth) / (0.06 * width) + 0.3, 0.0, 1.0), colour, width / 70)


def blend(out, mask, colour, softness):
    mask = cv2.GaussianBlur(mask.astype(np.float32), (0, 0), max(0.6, softness))[..., None]
    out += mask * (np.asarray(colour, np.float32) - out)


def other_lips(picture, points, rng):
    """Lips thicker or thinner, each with a colour nearer to the skin's or not: official portraits show few full lips and
    few whose colour is the skin's."""
    inner, outer = points[SLICES["inner_lip"]], points[SLICES["outer_lip"]]
    frame = CornerFrame(inner[0], inner[10])
    width = frame.width
    low, high = window(picture, outer, 0.6 * width)
    u, v = frame.grid(low, high)
    shown, moved, lips = v.copy(), points.copy(), []
    new = frame.of(outer)
    for side, direction, room in ((UPPER, -1.0, 0.3), (LOWER, 1.0, 0.4)):
        edge, rim = frame.of(inner[side]), frame.of(outer[side])
        times = np.exp(rng.uniform(np.log(0.75), np.log(1.7)))

        def beyond(u, v, edge=edge, direction=direction):
            return direction * (v - np.interp(u, edge[:, 0], edge[:, 1]))
        thick = np.maximum(0.0, direction * (np.interp(u, rim[:, 0], rim[:, 1], 0.0, 0.0) -
                                             np.interp(u, edge[:, 0], edge[:, 1])))
        still = np.maximum(thick + room * width, 1.3 * times * thick)  # beyond it nothing moves
        away = beyond(u, v)
        lip = (away >= 0.0) & (away <= times * thick)
        skin = (away > times * thick) & (away < still)
        squeezed = thick + (away - times * thick) * (still - thick) / np.maximum(still - times * thick, 1e-3)
        shown = np.where(lip, v + direction * (away / times - away), shown)
        shown = np.where(skin, v + direction * (squeezed - away), shown)
        lips.append(lip & (thick > 0.0))
        new[side, 1] += direction * (times - 1.0) * np.maximum(0.0, beyond(rim[:, 0], rim[:, 1]))
    out = remapped(picture, frame, low, high, u, shown)
    around = ~(lips[0] | lips[1]) & (np.abs(u - 0.5 * width) < 0.7 * width)
    skin_colour = out[around].mean(0) if around.any() else out.mean((0, 1))
    for lip in lips:
        if lip.any():
            toward = rng.uniform(0.0, 0.9) * (skin_colour - out[lip].mean(0))
            blend(out, lip, np.clip(out + toward, 0, 255), width / 50)
    result = picture.copy()
    result[low[1]:high[1], low[0]:high[0]] = np.clip(out, 0, 255).astype(np.uint8)
    moved[SLICES["outer_lip"]] = frame.back(new)
    return result, moved


def closed_eyes(picture, points, rng):
    """Upper lids come down, to the lower lid or part of the way; the skin above them is stretched."""
    result, moved = picture.copy(), points.copy()
    shut = 1.0 if rng.random() < 0.6 else rng.uniform(0.3, 0.9)
    for name in ("right_eye", "left_eye"):
        part = SLICES[name]
        result, moved[part] = closed_eye(result, points[part], shut, rng)
    return result, moved


def closed_eye(picture, eye, shut, rng):
    frame = CornerFrame(eye[0], eye[8])
    uv = frame.of(eye)
    sign = 1.0 if uv[1:8, 1].mean() > uv[9:, 1].mean() else -1.0  # v points up the face for the left eye
    uv[:, 1] *= sign
    upper, lower = uv[[0, *range(15, 7, -1)]], uv[:9]
    width = frame.width
    # Lids meet a little above the lower one, which comes up a little itself.
    rise = rng.uniform(0.0, 0.15)

    def top(u):
        return np.interp(u, upper[:, 0], upper[:, 1], 0.0, 0.0)

    def bottom(u):
        return np.maximum(np.interp(u, lower[:, 0], lower[:, 1], 0.0, 0.0), top(u))

    def meeting(u):
        return bottom(u) - rise * (bottom(u) - top(u))

    def new_top(u):
        return top(u) + shut * (meeting(u) - top(u))

    def new_bottom(u):
        return bottom(u) - shut * (bottom(u) - meeting(u))
    reach = 0.45 * width  # above the lid, where the skin starts to stretch
    low, high = window(picture, eye, 0.6 * width)
    u, v = frame.grid(low, high)
    v = v * sign
    inside = (u > 0.0) & (u < width)
    above = (v < new_top(u)) & (v > top(u) - reach) & inside
    # The skin between the brow's side and the lid is stretched over what it now covers.
    start = top(u) - reach
    along = (v - start) / np.maximum(new_top(u) - start, 1e-3)
    source = np.where(above, start + along * reach - 0.04 * width * shut * along, v)
    ball = inside & (v >= new_top(u)) & (v <= new_bottom(u))
    source = np.where(ball, np.maximum(v, top(u)), source)
    between = inside & (v > new_bottom(u)) & (v < bottom(u) + 0.15 * width)
    stretch = (bottom(u) + 0.15 * width - v) / np.maximum(bottom(u) + 0.15 * width - new_bottom(u), 1e-3)
    source = np.where(between, bottom(u) + 0.15 * width * (1.0 - stretch), source)
    out = remapped(picture, frame, low, high, u, source * sign)
    # Lashes: a dark soft line where the lids meet.
    line = inside & (np.abs(v - new_top(u)) < max(0.7, 0.025 * width))
    blend(out, line * rng.uniform(0.3, 0.9), out.mean((0, 1)) * rng.uniform(0.15, 0.5), width / 60)
    result = picture.copy()
    result[low[1]:high[1], low[0]:high[0]] = np.clip(out, 0, 255).astype(np.uint8)
    moved = uv.copy()
    moved[1:8, 1] = new_bottom(uv[1:8, 0])
    moved[9:, 1] = new_top(uv[9:, 0])
    moved[:, 1] *= sign
    return result, frame.back(moved)
