# SPDX-License-Identifier: Apache-2.0
"""A linear-light picture at twice its final size, and a pen that paints on it in face units."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from .curves import Frame

OVERSAMPLING = 2
_SUBPIXEL = 4  # bits of sub-pixel position handed to OpenCV's drawing


@dataclass(frozen=True)
class Mask:
    """Coverage 0 to 1 over a rectangle of the canvas."""

    rows: slice
    columns: slice
    values: np.ndarray

    def grid(self, frame: Frame) -> tuple[np.ndarray, np.ndarray]:
        """Face coordinates x, y of each pixel's centre."""
        y, x = np.mgrid[self.rows, self.columns]
        p = frame.to_face(np.stack([(x + 0.5) / OVERSAMPLING, (y + 0.5) / OVERSAMPLING], -1))
        return p[..., 0].astype(np.float32), p[..., 1].astype(np.float32)


class Canvas:
    """RGB in linear light, 0 to 1, `OVERSAMPLING` samples a final pixel along each axis."""

    def __init__(self, width: int, height: int):
        self.width, self.height = width, height
        self.rgb = np.zeros((height * OVERSAMPLING, width * OVERSAMPLING, 3), np.float32)

    def picture(self, rng: np.random.Generator) -> np.ndarray:
        """The finished picture, 8-bit BGR, with a camera's fine grain."""
        small = cv2.resize(self.rgb, (self.width, self.height), interpolation=cv2.INTER_AREA)
        screen = 255 * np.clip(small, 0, 1) ** (1 / 2.2)
        grain = cv2.GaussianBlur(rng.normal(0, 1, small.shape[:2]).astype(np.float32), (0, 0), 0.7)
        screen = screen + 3.2 * grain[..., None]
        return np.clip(np.rint(screen), 0, 255).astype(np.uint8)[..., ::-1].copy()


class Pen:
    """Paints curves given in face units onto a canvas."""

    def __init__(self, canvas: Canvas, frame: Frame, clip: np.ndarray | None = None):
        self.canvas, self.frame, self.clip = canvas, frame, clip
        self.unit = frame.scale * OVERSAMPLING  # canvas samples per face unit

    def clipped(self, mask: Mask) -> "Pen":
        """A pen that reaches only what `mask` covers."""
        clip = np.zeros(self.canvas.rgb.shape[:2], np.float32)
        clip[mask.rows, mask.columns] = mask.values
        return Pen(self.canvas, self.frame, clip)

    def _share(self, mask: Mask, opacity: float) -> np.ndarray:
        """How much of each place under the mask a stroke takes, with a channel axis."""
        share = opacity * mask.values
        if self.clip is not None:
            share = share * self.clip[mask.rows, mask.columns]
        return share[..., None]

    def _samples(self, points) -> np.ndarray:
        return self.frame.to_picture(points) * OVERSAMPLING - 0.5

    def _window(self, p: np.ndarray, margin: float) -> tuple[slice, slice] | None:
        height, width = self.canvas.rgb.shape[:2]
        low = np.maximum(np.floor(p.min(0) - margin).astype(int), 0)
        high = np.minimum(np.ceil(p.max(0) + margin).astype(int) + 1, [width, height])
        return (slice(low[1], high[1]), slice(low[0], high[0])) if (high > low).all() else None

    def _raster(self, points, margin: float, draw) -> Mask | None:
        p = self._samples(points)
        window = self._window(p, margin)
        if window is None:
            return None
        rows, columns = window
        image = np.zeros((rows.stop - rows.start, columns.stop - columns.start), np.uint8)
        fixed = np.round((p - [columns.start, rows.start]) * (1 << _SUBPIXEL)).astype(np.int32)
        draw(image, fixed)
        return Mask(rows, columns, image.astype(np.float32) / 255)

    def _softened(self, mask: Mask | None, blur: float) -> Mask | None:
        if mask is None or blur <= 0:
            return mask
        return Mask(mask.rows, mask.columns, cv2.GaussianBlur(mask.values, (0, 0), max(blur * self.unit, 0.3)))

    def area(self, points, blur: float = 0.0, margin: float = 0.0) -> Mask | None:
        """Coverage of a closed polygon; `blur` is the standard deviation of its softened edge, in face units."""
        draw = lambda image, p: cv2.fillPoly(image, [p], 255, cv2.LINE_AA, _SUBPIXEL)
        return self._softened(self._raster(points, (3 * blur + margin) * self.unit + 3, draw), blur)

    def line(self, points, width: float, blur: float = 0.0) -> Mask | None:
        """Coverage of a polyline of constant `width`, in face units."""
        thick = max(1, round(width * self.unit))
        draw = lambda image, p: cv2.polylines(image, [p], False, 255, thick, cv2.LINE_AA, _SUBPIXEL)
        return self._softened(self._raster(points, (3 * blur + width) * self.unit + 3, draw), blur)

    def paint(self, mask: Mask | None, colour, opacity: float = 1.0) -> None:
        """Lay `colour` (one colour or one per pixel) over the canvas where the mask covers it."""
        if mask is None:
            return
        region = self.canvas.rgb[mask.rows, mask.columns]
        region += (np.asarray(colour, np.float32) - region) * self._share(mask, opacity)

    def tint(self, mask: Mask | None, factor, opacity: float = 1.0) -> None:
        """Multiply the canvas by `factor` (a number or one per channel) where the mask covers it."""
        if mask is None:
            return
        region = self.canvas.rgb[mask.rows, mask.columns]
        region *= 1 + self._share(mask, opacity) * (np.asarray(factor, np.float32) - 1)

    def tapered(self, points, widths, colour, opacity: float = 1.0) -> None:
        """A stroke whose width changes along it: the ribbon around `points` with full widths `widths`."""
        p = np.asarray(points, float)
        tangent = np.gradient(p, axis=0)
        normal = np.c_[-tangent[:, 1], tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1), 1e-9)[:, None]
        half = normal * np.asarray(widths, float)[:, None] / 2
        self.paint(self.area(np.vstack([p + half, (p - half)[::-1]])), colour, opacity)
