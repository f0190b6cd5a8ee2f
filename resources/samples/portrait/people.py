# SPDX-License-Identifier: Apache-2.0
"""Who is drawn: face shapes, expressions, colours, and the contours that follow from them (face units)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .curves import Path, joined, spline


def srgb(red: int, green: int, blue: int) -> np.ndarray:
    """A screen colour (0 to 255) as linear light, 0 to 1."""
    return (np.array([red, green, blue], np.float32) / 255) ** 2.2


@dataclass(frozen=True)
class Shape:
    """Resting shape of a face, in face units."""

    cheek: float = 0.755  # half width at the cheekbones
    jaw: float = 0.61  # half width at the height of the mouth
    chin_width: float = 0.235  # half width of the chin's flat part
    chin: float = 1.25  # depth of the chin below the eye line
    eye_inner: float = 0.185  # distance of the inner eye corner from the middle
    eye_up: float = 0.068  # upper lid above, lower lid below the line of the corners
    eye_low: float = 0.046
    eye_tilt: float = 0.014  # inner corner below the outer one
    iris: float = 0.066  # radius
    brow: float = -0.2  # height of the brow's middle
    brow_weight: float = 1.0  # thickness and density
    nose: float = 0.445  # height of the tip's lower end
    nose_width: float = 0.185  # half width across the wings
    mouth: float = 0.745  # height of the line between the lips
    mouth_width: float = 0.285  # half width
    upper_lip: float = 0.082  # thickness in the middle
    lower_lip: float = 0.105


@dataclass(frozen=True)
class Expression:
    """Changes to the resting shape, in face units or as factors."""

    mouth_width: float = 1.0  # factor
    corner: float = 0.0  # how far the mouth's corners sit below the middle (smile: negative)
    mouth_shift: float = 0.0  # mouth moves down
    open_up: float = 0.004  # how far the opening's edges stand above and below the lip line
    open_low: float = 0.005
    opening_round: float = 2.0  # exponent of the opening's profile: 2 lens, larger boxier
    lip_thin: float = 1.0  # factor on both thicknesses
    jaw_drop: float = 0.0
    cheek_lift: float = 0.0  # 0 to 1: raised cheeks and the folds beside the nose
    eye_up: float = 1.0  # factors on the lids
    eye_low: float = 1.0
    lid_outer: float = 0.0  # upper lid sags at its outer third
    brow_inner: float = 0.0  # vertical shift of the brow's ends and middle (down is positive)
    brow_middle: float = 0.0
    brow_outer: float = 0.0
    brow_close: float = 0.0  # inner ends move towards the nose
    frown: float = 0.0  # 0 to 1: upright folds between the brows
    forehead: float = 0.0  # 0 to 1: folds across the forehead
    fold: float = 0.25  # 0 to 1: fold from the nose's wing to the mouth's corner
    teeth: float = 0.0  # length of the visible upper teeth
    tongue: bool = False


@dataclass(frozen=True)
class Person:
    """Shape, colours and hair of one drawn person."""

    name: str
    shape: Shape
    skin: np.ndarray
    lips: np.ndarray
    iris: np.ndarray
    hair: np.ndarray
    garment: np.ndarray
    hair_style: str = "long"  # a name in `hair.STYLES`
    lashes: float = 1.0  # length factor
    stubble: float = 0.0  # 0 to 1
    age: float = 0.0  # 0 to 1: depth of lines
    collar: str = "round"
    seed: int = 1
    brow_colour: np.ndarray | None = field(default=None)


EXPRESSIONS = {
    "neutral": Expression(),
    "smiling": Expression(
        mouth_width=1.2, corner=-0.075, mouth_shift=-0.005, open_up=0.012, open_low=0.085, lip_thin=0.86,
        cheek_lift=1.0, eye_up=0.9, eye_low=0.78, brow_inner=-0.02, brow_middle=-0.012,
        fold=0.75, teeth=0.08, opening_round=2.5),
    "surprised": Expression(
        mouth_width=0.84, corner=0.0, mouth_shift=0.045, open_up=0.062, open_low=0.118, lip_thin=0.9,
        jaw_drop=0.115, eye_up=1.34, eye_low=1.12, brow_inner=-0.075, brow_middle=-0.1, brow_outer=-0.06, forehead=0.8,
        fold=0.12, teeth=0.035, tongue=True, opening_round=2.3),
    "sad": Expression(
        mouth_width=0.96, corner=0.05, mouth_shift=-0.008, lip_thin=0.95, eye_up=0.88, eye_low=0.95,
        lid_outer=0.02, brow_inner=-0.07, brow_middle=0.0, brow_outer=0.045, brow_close=0.03, frown=0.3,
        forehead=0.3, fold=0.45),
    "angry": Expression(
        mouth_width=0.97, corner=0.035, mouth_shift=-0.005, lip_thin=0.72, eye_up=0.78, eye_low=0.8,
        brow_inner=0.085, brow_middle=0.045, brow_outer=-0.02, brow_close=0.045, frown=1.0, fold=0.6),
}

ANNA = Person(
    "anna", Shape(), skin=srgb(226, 178, 152), lips=srgb(186, 96, 92), iris=srgb(84, 94, 92), hair=srgb(92, 60, 38),
    garment=srgb(52, 84, 110), seed=11)

BEN = Person(
    "ben",
    Shape(cheek=0.775, jaw=0.65, chin_width=0.27, chin=1.27, eye_up=0.06, eye_low=0.043, brow=-0.185, brow_weight=1.5,
          nose=0.46, nose_width=0.21, mouth=0.765, mouth_width=0.295, upper_lip=0.078, lower_lip=0.108, iris=0.064),
    skin=srgb(164, 116, 88), lips=srgb(146, 84, 76), iris=srgb(74, 46, 28), hair=srgb(30, 24, 21),
    garment=srgb(126, 126, 120), hair_style="short", lashes=0.6, stubble=0.5, collar="shirt", seed=23)

CLARA = Person(
    "clara",
    Shape(cheek=0.765, jaw=0.625, chin_width=0.25, chin=1.22, eye_up=0.06, eye_low=0.042, eye_tilt=0.004, brow=-0.205,
          brow_weight=0.75, nose=0.455, nose_width=0.195, mouth=0.745, mouth_width=0.28, upper_lip=0.062, lower_lip=0.085),
    skin=srgb(232, 190, 170), lips=srgb(184, 104, 100), iris=srgb(72, 88, 100), hair=srgb(186, 182, 178),
    garment=srgb(118, 62, 74), hair_style="swept", lashes=0.7, age=0.85, seed=37, brow_colour=srgb(140, 124, 112))


def _upper_lid(s: Shape, e: Expression) -> Path:
    """Upper lid of the eye on the picture's right, outer corner to inner corner."""
    w, up = 0.5 - s.eye_inner, s.eye_up * e.eye_up
    at = lambda f: 0.5 - f * w
    sag = e.lid_outer
    return spline([(0.5, 0), (at(0.16), -0.5 * up + 0.6 * sag), (at(0.42), -up + 0.6 * sag), (at(0.72), -0.74 * up),
                   (s.eye_inner, s.eye_tilt)])


def _lower_lid(s: Shape, e: Expression) -> Path:
    """Lower lid of the same eye, inner corner to outer corner."""
    w, low = 0.5 - s.eye_inner, s.eye_low * e.eye_low
    at = lambda f: 0.5 - f * w
    return spline([(s.eye_inner, s.eye_tilt), (at(0.74), 0.62 * low + 0.5 * s.eye_tilt), (at(0.42), low),
                   (at(0.15), 0.58 * low), (0.5, 0)])


def _lip_line(x, s: Shape, e: Expression) -> np.ndarray:
    """Height of the line on which the lips meet, at distance `x` from the middle."""
    w = s.mouth_width * e.mouth_width
    return s.mouth + e.mouth_shift + e.corner * np.abs(np.asarray(x) / w) ** 1.8


def _opening(x, reach: float, e: Expression) -> np.ndarray:
    """Share (0 to 1) of the full opening at distance `x` from the middle; 0 at `reach`."""
    return np.maximum(1 - np.abs(np.asarray(x) / reach) ** e.opening_round, 0)


def _mouth(s: Shape, e: Expression) -> tuple[Path, Path, Path, Path]:
    """Outer upper, outer lower, inner upper, inner lower edge of the lips; each from picture left to right."""
    w = s.mouth_width * e.mouth_width
    reach = 0.925 * w
    upper, lower = s.upper_lip * e.lip_thin, s.lower_lip * e.lip_thin
    f = np.array([-1, -0.82, -0.58, -0.29, 0, 0.29, 0.58, 0.82, 1.0])
    x = f * w
    rise = np.array([0, 0.33, 0.70, 1.13, 0.96, 1.13, 0.70, 0.33, 0]) * upper
    fall = np.array([0, 0.36, 0.70, 0.95, 1.0, 0.95, 0.70, 0.36, 0]) * lower
    gap = _opening(x, 1.04 * w, e)
    gap[[0, -1]] = 0
    line = _lip_line(x, s, e)
    outer_up = spline(np.c_[x, line - rise - gap * e.open_up])
    outer_low = spline(np.c_[x, line + fall + gap * e.open_low])
    xi = np.array([-1, -0.86, -0.6, -0.3, 0, 0.3, 0.6, 0.86, 1.0]) * reach
    gap, line = _opening(xi, reach, e), _lip_line(xi, s, e)
    bow = np.array([0, 0, 0, -0.004, 0.006, -0.004, 0, 0, 0]) * (upper / 0.08)
    bow_low = bow * np.clip(1 - 8 * (e.open_up + e.open_low), 0, 1)
    return (outer_up, outer_low, spline(np.c_[xi, line - gap * e.open_up + bow]),
            spline(np.c_[xi, line + gap * e.open_low + bow_low]))


def _jaw(s: Shape, e: Expression) -> Path:
    """Outline from the eye line at picture left through the chin to picture right."""
    chin = s.chin + e.jaw_drop
    mouth = 0.78 + 0.55 * e.jaw_drop
    half = [(s.cheek, 0.0), (s.cheek - 0.004, 0.2), (s.cheek - 0.03, 0.42), (0.5 * (s.cheek - 0.03 + s.jaw) + 0.014, 0.6),
            (s.jaw, mouth), (0.5 * (s.jaw + s.chin_width) + 0.05, 0.5 * (mouth + chin) + 0.04),
            (s.chin_width, chin - 0.055), (0.5 * s.chin_width, chin - 0.014)]
    left = [(-x, y) for x, y in half]
    return spline(left + [(0.0, chin)] + half[::-1])


@dataclass(frozen=True)
class Contours:
    """What a finger is to find, and the open edges it is made of (face units; lids for the eye on the picture's right)."""

    upper_lid: Path
    lower_lid: Path
    lip_up: Path
    lip_low: Path
    mouth_up: Path
    mouth_low: Path
    outline: Path

    def truth(self) -> dict[str, Path]:
        """The published contours by name; left and right are the person's own."""
        left_eye = joined(self.upper_lid, self.lower_lid)
        return {
            "right_eye": left_eye.mirrored(),
            "left_eye": left_eye,
            "outer_lip": joined(self.lip_up, self.lip_low.reversed()),
            "inner_lip": joined(self.mouth_up, self.mouth_low.reversed()),
            "outline": self.outline,
        }


def contours(person: Person, expression: Expression) -> Contours:
    """All edges of one person's face with one expression."""
    s = person.shape
    return Contours(_upper_lid(s, expression), _lower_lid(s, expression), *_mouth(s, expression), _jaw(s, expression))
