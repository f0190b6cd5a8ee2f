# SPDX-License-Identifier: Apache-2.0
"""The pictures: who stands where with which expression, and the truth written beside each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import eyes, features, hair, head
from .canvas import Canvas, Pen
from .curves import Frame
from .people import ANNA, BEN, CLARA, EXPRESSIONS, Expression, Person, contours, srgb
from .relief import noise


@dataclass(frozen=True)
class Sitter:
    """One person in a picture."""

    person: Person
    expression: Expression
    frame: Frame


@dataclass(frozen=True)
class Scene:
    """One picture; sitters from the picture's left to its right."""

    name: str
    sitters: tuple[Sitter, ...]
    background: np.ndarray
    width: int = 900  # pixels
    height: int = 1100


def _single(person: Person, expression: str, background, roll: float = 0.0) -> Scene:
    frame = Frame(238.0, (450.0, 478.0), np.radians(roll))
    return Scene(f"{person.name}_{expression}", (Sitter(person, EXPRESSIONS[expression], frame),), background)


_BLUE, _WARM, _GREEN = srgb(150, 164, 176), srgb(182, 172, 160), srgb(158, 168, 156)

SCENES = (
    _single(ANNA, "smiling", _BLUE, 2.0),
    _single(ANNA, "surprised", _BLUE, -1.0),
    _single(ANNA, "sad", _BLUE, 1.5),
    _single(ANNA, "angry", _BLUE),
    _single(BEN, "smiling", _WARM, -2.0),
    _single(BEN, "angry", _WARM, 1.0),
    _single(CLARA, "sad", _GREEN, -1.5),
    Scene("ben_and_clara", (Sitter(BEN, EXPRESSIONS["neutral"], Frame(166.0, (252.0, 440.0), np.radians(3))),
                            Sitter(CLARA, EXPRESSIONS["smiling"], Frame(156.0, (640.0, 520.0), np.radians(-4)))), _WARM),
)


def _paint_background(canvas: Canvas, colour: np.ndarray, rng: np.random.Generator) -> None:
    """A wall in soft light: brighter at the upper left, darker towards the rim."""
    h, w = canvas.rgb.shape[:2]
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    far = np.hypot((x / w - 0.38) / 0.9, (y / h - 0.38) / 0.9)
    light = 1.05 - 0.62 * far**1.6 + 0.012 * noise((h, w), 0.08 * w, rng)
    canvas.rgb[:] = colour * light[..., None]


def _paint_sitter(canvas: Canvas, sitter: Sitter, rng: np.random.Generator) -> None:
    """One person from back to front."""
    person, e = sitter.person, sitter.expression
    c, pen = contours(person, e), Pen(canvas, sitter.frame)
    head.paint_neck(pen, person, c, e.jaw_drop)
    head.paint_garment(pen, person, rng)
    hair.paint_back(pen, person, rng)
    head.paint_ears(pen, person)
    head.paint_face(pen, person, e, c, rng)
    features.paint_folds(pen, person, e)
    features.paint_nose(pen, person)
    features.paint_mouth(pen, person, e, c)
    eyes.paint_eyes(pen, person, e, c, rng)
    features.paint_brows(pen, person, e, rng)
    skin = pen.clipped(pen.area(head.skull(person, c)))
    hair.paint_front(pen, person, rng, skin)


def render(scene: Scene) -> np.ndarray:
    """The picture as 8-bit BGR; the same every time."""
    canvas = Canvas(scene.width, scene.height)
    _paint_background(canvas, scene.background, np.random.default_rng(5))
    for sitter in scene.sitters:
        _paint_sitter(canvas, sitter, np.random.default_rng(sitter.person.seed))
    return canvas.picture(np.random.default_rng(7))


def _truth_paths(sitter: Sitter, prefix: str) -> list[str]:
    """SVG path elements of one face, in pixels of the picture."""
    found = contours(sitter.person, sitter.expression).truth()
    return [f'<path id="{prefix}{name}" d="{path.mapped(sitter.frame.to_picture).svg()}"/>' for name, path in found.items()]


def truth_svg(scene: Scene) -> str:
    """The contours as drawn; several faces are grouped as face_1, face_2 ... from left to right."""
    head_line = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{scene.width}" height="{scene.height}" '
                 f'viewBox="0 0 {scene.width} {scene.height}" fill="none" stroke="black">')
    lines = [head_line]
    if len(scene.sitters) == 1:
        lines += ["  " + p for p in _truth_paths(scene.sitters[0], "")]
    else:
        for number, sitter in enumerate(scene.sitters, 1):
            paths = _truth_paths(sitter, f"face_{number}.")
            lines += [f'  <g id="face_{number}">', *("    " + p for p in paths), "  </g>"]
    return "\n".join(lines + ["</svg>"]) + "\n"
