# SPDX-License-Identifier: Apache-2.0
"""Cubic Bezier paths and the similarity that carries a face onto a picture.

Face frame: the unit is the distance between the outer eye corners, the origin lies midway between them,
x runs right and y runs down as seen in the picture.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Frame:
    """Similarity from face units to picture pixels; a picture's corner is (0, 0), its first pixel's centre (0.5, 0.5)."""

    scale: float  # pixels per face unit, > 0
    origin: tuple[float, float]  # pixels
    roll: float = 0.0  # radians, clockwise in the picture

    def _axes(self) -> np.ndarray:
        c, s = np.cos(self.roll), np.sin(self.roll)
        return np.array([[c, s], [-s, c]])

    def to_picture(self, points) -> np.ndarray:
        """Points in face units, shape (..., 2), as pixels."""
        return np.asarray(points, float) @ self._axes() * self.scale + np.asarray(self.origin)

    def to_face(self, pixels) -> np.ndarray:
        """Pixels, shape (..., 2), as points in face units; the inverse of `to_picture`."""
        return (np.asarray(pixels, float) - np.asarray(self.origin)) / self.scale @ self._axes().T


@dataclass(frozen=True)
class Path:
    """A start point and cubic Bezier pieces (n, 3, 2): two control points and an end point each."""

    start: np.ndarray
    cubics: np.ndarray
    closed: bool = False

    def points(self, per_piece: int = 16) -> np.ndarray:
        """The curve flattened to `per_piece` chords a piece, start point first."""
        t = np.linspace(0, 1, per_piece + 1)[1:, None]
        out, p0 = [self.start[None]], self.start
        for c1, c2, p1 in self.cubics:
            out.append((1 - t) ** 3 * p0 + 3 * t * (1 - t) ** 2 * c1 + 3 * t * t * (1 - t) * c2 + t**3 * p1)
            p0 = p1
        return np.vstack(out)

    def mapped(self, function) -> "Path":
        """The path with `function` applied to every control point; exact where the function is affine."""
        return Path(function(self.start), function(self.cubics), self.closed)

    def mirrored(self) -> "Path":
        """The path on the other side of the face (x negated)."""
        return self.mapped(lambda p: p * np.array([-1.0, 1.0]))

    def reversed(self) -> "Path":
        """The same curve run backwards."""
        ends = np.vstack([self.start[None], self.cubics[:, 2]])
        pieces = [[c2, c1, p] for (c1, c2, _), p in zip(self.cubics[::-1], ends[-2::-1])]
        return Path(ends[-1], np.array(pieces), self.closed)

    def svg(self) -> str:
        """SVG path data in absolute M and C commands, two decimals, Z when closed."""
        words = ["M %.2f %.2f" % tuple(self.start)]
        words += ["C %.2f %.2f %.2f %.2f %.2f %.2f" % tuple(c.ravel()) for c in self.cubics]
        return " ".join(words + (["Z"] if self.closed else []))


def spline(knots) -> Path:
    """Smooth open path through `knots` (n >= 2): Catmull-Rom with chord-length spacing and parabolic ends."""
    k = np.asarray(knots, float)
    h = np.maximum(np.linalg.norm(np.diff(k, axis=0), axis=1), 1e-9)
    slope = np.diff(k, axis=0) / h[:, None]
    tangent = np.empty_like(k)
    if len(k) > 2:
        tangent[1:-1] = (slope[:-1] * h[1:, None] + slope[1:] * h[:-1, None]) / (h[:-1] + h[1:])[:, None]
        tangent[0], tangent[-1] = 2 * slope[0] - tangent[1], 2 * slope[-1] - tangent[-2]
    else:
        tangent[:] = slope
    step = h[:, None] / 3
    cubics = np.stack([k[:-1] + tangent[:-1] * step, k[1:] - tangent[1:] * step, k[1:]], axis=1)
    return Path(k[0], cubics)


def joined(*paths: Path, closed: bool = True) -> Path:
    """Paths laid end to end; each starts where the one before it ends."""
    return Path(paths[0].start, np.concatenate([p.cubics for p in paths]), closed)


def smoothstep(low: float, high: float, x) -> np.ndarray:
    """0 below `low`, 1 above `high`, a smooth cubic between (low may exceed high: then it falls)."""
    t = np.clip((np.asarray(x) - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
