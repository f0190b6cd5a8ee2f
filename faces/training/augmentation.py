# SPDX-License-Identifier: Apache-2.0
"""What a photograph may do to a face: another window, other light, blur, noise, JPEG, things in front of it.

Geometry acts on the window before the crop is taken, so that every pixel is interpolated once; light acts on whole
batches of float32 crops of 0 … 255.
"""
from dataclasses import dataclass

import cv2
import numpy as np


@dataclass
class Jitter:
    """Half widths of what varies, as parts of the window's side, logarithms and radians."""
    shift: float
    scale: float
    turn: float          # standard deviation
    stretch: float = 0.08
    shear: float = 0.06
    large_turn: float = 0.0  # in a third of the pictures, evenly distributed


def jittered(to_picture, size, jitter, rng):
    """A window's 2 × 3 matrix (crop → picture px), varied about its middle."""
    turn = rng.normal(0.0, jitter.turn)
    if jitter.large_turn and rng.random() < 1 / 3:
        turn = rng.uniform(-jitter.large_turn, jitter.large_turn)
    scale = np.exp(rng.uniform(-jitter.scale, jitter.scale))
    stretch = np.exp(rng.uniform(-jitter.stretch, jitter.stretch))
    c, s = np.cos(turn) * scale, np.sin(turn) * scale
    vary = np.array([[c, -s], [s, c]]) @ np.array([[stretch, rng.uniform(-jitter.shear, jitter.shear)],
                                                   [0.0, 1.0 / stretch]])
    linear = to_picture[:, :2] @ vary
    middle = to_picture[:, :2] @ [size / 2, size / 2] + to_picture[:, 2]
    middle = middle + to_picture[:, :2] @ (rng.uniform(-jitter.shift, jitter.shift, 2) * size)
    return np.c_[linear, middle - linear @ [size / 2, size / 2]]


def turned_aside(crop, points, rng):
    """A little yaw: one half of the face narrows, the other widens. Crop px."""
    size = crop.shape[0]
    bend = rng.uniform(-0.28, 0.28)

    def source(x):  # −1 … 1 across the crop, monotone for |bend| < 0.5
        return x + bend * (1.0 - x * x)
    at = (np.arange(size, dtype=np.float32) + 0.5) / size * 2.0 - 1.0
    columns = ((source(at) + 1.0) / 2.0 * size - 0.5).astype(np.float32)
    x, y = np.meshgrid(columns, np.arange(size, dtype=np.float32))
    out = cv2.remap(crop, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    fine = np.linspace(-1.6, 1.6, 801)
    moved = points.copy()
    moved[:, 0] = (np.interp(points[:, 0] / size * 2.0 - 1.0, source(fine)[np.argmin(source(fine)):],
                             fine[np.argmin(source(fine)):]) + 1.0) / 2.0 * size
    return out, moved


def degraded(crop, rng):
    """Blur, lost resolution or JPEG, 8-bit in and out."""
    size = crop.shape[0]
    if rng.random() < 0.3:
        crop = cv2.GaussianBlur(crop, (0, 0), 0.4 * np.exp(rng.uniform(0.0, np.log(12.0)) * rng.random()))
    if rng.random() < 0.2:
        part = rng.uniform(0.15, 0.7)
        crop = cv2.resize(cv2.resize(crop, None, fx=part, fy=part, interpolation=cv2.INTER_AREA), (size, size))
    if rng.random() < 0.15:
        _, data = cv2.imencode(".jpg", crop, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(25, 90))])
        crop = cv2.imdecode(data, cv2.IMREAD_COLOR)
    return crop


def covered(crop, rng):
    """Something like a hand, a finger, hair or an edge of cloth in front of part of the window."""
    size = crop.shape[0]
    mask = np.zeros((size, size), np.uint8)
    kind = rng.random()
    if kind < 0.4:  # fingers
        colour = np.array([110, 140, 190]) * rng.uniform(0.3, 1.2) + rng.normal(0, 12, 3)
        edge, aim = rng.uniform(-0.1, 1.1, 2), rng.uniform(0.2, 0.8, 2)
        edge[rng.integers(2)] = rng.choice([-0.05, 1.05])
        for _ in range(rng.integers(1, 4)):
            edge, aim = edge + rng.normal(0, 0.08, 2), aim + rng.normal(0, 0.08, 2)
            cv2.line(mask, tuple((edge * size).astype(int).tolist()), tuple((aim * size).astype(int).tolist()), 255,
                     int(rng.integers(size // 16, size // 7)), cv2.LINE_AA)
    elif kind < 0.8:  # strands of hair
        colour = np.array([40, 60, 90]) * rng.uniform(0.2, 2.0) + rng.normal(0, 10, 3)
        start = rng.uniform(0.0, 1.0, 2) * [1.0, 0.2]
        for _ in range(rng.integers(3, 25)):
            line = np.cumsum(np.vstack([start + rng.normal(0, 0.06, 2), rng.normal([0.0, 0.15], 0.06, (6, 2))]), 0)
            cv2.polylines(mask, [(line * size * 8).astype(np.int32)], False, 255, int(rng.integers(1, 3)),
                          cv2.LINE_AA, 3)
    elif kind < 0.88:  # a wall, a book, somebody else's shoulder: all beyond a line
        colour = rng.uniform(0, 255, 3)
        angle, reach = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.0, 0.35) * size
        y, x = np.mgrid[:size, :size] - 0.5 * size
        mask[np.cos(angle) * x + np.sin(angle) * y > reach] = 255
    else:
        colour = rng.uniform(0, 255, 3)
        at, extent = rng.uniform(0.0, 1.0, 2), rng.uniform(0.08, 0.3, 2)
        cv2.ellipse(mask, tuple((at * size).astype(int).tolist()), tuple((extent * size).astype(int).tolist()),
                    rng.uniform(0, 180), 0, 360, 255, -1, cv2.LINE_AA)
    part = cv2.GaussianBlur(mask, (0, 0), rng.uniform(0.5, 1.5)).astype(np.float32)[..., None] / 255.0
    return (crop + part * (np.clip(colour, 0, 255) - crop)).astype(np.uint8)


def with_glare(crop, at, radius, rng):
    """A bright, soft patch, as a lamp makes on glasses, at a place of the crop."""
    mask = np.zeros(crop.shape[:2], np.uint8)
    axes = np.maximum(1, radius * rng.uniform(0.15, 0.7, 2)).astype(int)
    place = np.asarray(at) + rng.normal(0.0, 0.4 * radius, 2)
    cv2.ellipse(mask, tuple(place.astype(int).tolist()), tuple(axes.tolist()), rng.uniform(0, 180), 0, 360, 255, -1)
    part = cv2.GaussianBlur(mask, (0, 0), rng.uniform(0.8, 0.25 * radius + 1.0)).astype(np.float32)[..., None]
    return (crop + part / 255.0 * rng.uniform(0.3, 0.95) * (255.0 - crop)).astype(np.uint8)


def relit(crops, rng):
    """(B, size, size, 3) crops under other light: exposure, colour, side light, grey film, noise. float32, 0 … 255."""
    count, size = crops.shape[:2]

    def each(low, high, channels=1):
        return rng.uniform(low, high, (count, 1, 1, channels)).astype(np.float32)
    x = crops.astype(np.float32)
    grey = rng.random(count) < 0.15
    x[grey] = x[grey].mean(3, keepdims=True)
    x *= each(0.6, 1.4) * np.exp(rng.normal(0.0, 0.08, (count, 1, 1, 3))).astype(np.float32)
    x += each(-30.0, 30.0)
    direction = rng.uniform(0.0, 2.0 * np.pi, (count, 1, 1, 1)).astype(np.float32)
    at = np.linspace(-1.0, 1.0, size, dtype=np.float32)
    slope = np.cos(direction) * at[None, None, :, None] + np.sin(direction) * at[None, :, None, None]
    strength = each(0.0, 0.7) * (rng.random((count, 1, 1, 1)) < 0.4)
    x *= np.maximum(0.1, 1.0 + strength.astype(np.float32) * slope)
    strength = np.exp(each(np.log(2.0), np.log(30.0))) * (rng.random((count, 1, 1, 1)) < 0.3)
    noisy = np.flatnonzero(strength[:, 0, 0, 0])
    x[noisy] += rng.standard_normal((len(noisy), size, size, 3), np.float32) * strength[noisy].astype(np.float32)
    return np.clip(x, 0.0, 255.0)
