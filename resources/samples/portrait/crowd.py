# SPDX-License-Identifier: Apache-2.0
"""Any number of people who differ as people do, each with every expression, for learning and measuring on.

Means and standard deviations are those of 68 neutral portraits with contours placed by hand (Face Research Lab London
Set, DeBruine & Jones 2017) and of the same people's smiles, in the cues of `core/study/expression_cues.hpp`.
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from .curves import Frame
from .people import ANNA, BEN, CLARA, EXPRESSIONS, Expression, Person, Shape, srgb
from .scene import Scene, Sitter

# A portrait's smile against the drawn one: corners lifted 0.48 (0.26) times as far, mouth widened 0.74 (0.47) times.
# That the other expressions are shown as strongly is an assumption.
_STRENGTH, _STRENGTH_SPREAD = 0.65, 0.25
_PART_SPREAD = 0.3  # how much each part of an expression, the corners or the lids, goes its own way: an assumption

# Change with the strength of an expression; what is not named here is either on or off.
_FACTORS = ("mouth_width", "lip_thin", "eye_up", "eye_low")
_SHIFTS = ("corner", "mouth_shift", "open_up", "open_low", "jaw_drop", "cheek_lift", "lid_outer", "brow_inner",
           "brow_middle", "brow_outer", "brow_close", "frown", "forehead", "teeth")


def _shape(rng: np.random.Generator) -> Shape:
    """A resting face."""
    s, near = Shape(), lambda mean, spread: float(np.clip(rng.normal(mean, spread), mean - 2.5 * spread, mean + 2.5 * spread))
    lips, lids, width = near(1.07, 0.2), near(1.0, 0.11), near(1.0, 0.03)
    return replace(
        s, cheek=s.cheek * width, jaw=s.jaw * width * near(1.0, 0.02), chin=near(1.275, 0.07), eye_up=s.eye_up * lids,
        eye_low=s.eye_low * lids, eye_tilt=near(0.018, 0.012), mouth=near(0.755, 0.03), mouth_width=near(0.287, 0.016),
        upper_lip=s.upper_lip * lips * near(1.0, 0.08), lower_lip=s.lower_lip * lips * near(1.0, 0.08))


def _resting(rng: np.random.Generator) -> Expression:
    """What a person's mouth and lids do when they do nothing."""
    return Expression(corner=float(np.clip(rng.normal(0.018, 0.026), -0.04, 0.07)), lid_outer=float(rng.normal(-0.014, 0.006)))


def _shown(kind: str, resting: Expression, rng: np.random.Generator) -> Expression:
    """An expression as this person shows it once: more or less of the drawn one, on top of the resting face."""
    full, plain = EXPRESSIONS[kind], EXPRESSIONS["neutral"]
    strength = float(np.clip(rng.normal(_STRENGTH, _STRENGTH_SPREAD), 0.2, 1.1))
    part = lambda: strength * float(np.clip(rng.normal(1.0, _PART_SPREAD), 0.2, 1.8))
    changed = {name: getattr(resting, name) + part() * (getattr(full, name) - getattr(plain, name))
               for name in _FACTORS + _SHIFTS}
    changed["cheek_lift"] = min(changed["cheek_lift"], 1.0)
    changed["frown"] = min(changed["frown"], 1.0)
    changed["forehead"] = min(changed["forehead"], 1.0)
    rest = {f.name: getattr(full, f.name) for f in fields(Expression) if f.name not in changed}
    if changed["open_up"] + changed["open_low"] < 0.05:  # behind lips so near there is nothing to be seen
        changed["teeth"], rest["tongue"] = 0.0, False
    return Expression(**changed, **rest)


def _person(number: int, rng: np.random.Generator) -> Person:
    """A face of its own with the colours and the hair of one of the sitters."""
    like = (ANNA, BEN, CLARA)[int(rng.integers(3))]
    tone = float(rng.uniform(0.75, 1.15))
    return replace(like, name=f"person{number:03d}", shape=_shape(rng), skin=np.clip(like.skin * tone, 0, 0.9).astype(np.float32),
                   lips=np.clip(like.lips * tone, 0, 0.9).astype(np.float32), seed=int(rng.integers(1 << 30)))


def crowd(people: int, seed: int) -> list[Scene]:
    """Every expression of every person, one a picture, named person001_smiling and so on; the same for the same seed."""
    scenes = []
    for number in range(1, people + 1):
        rng = np.random.default_rng([seed, number])
        person, resting = _person(number, rng), _resting(rng)
        for kind in EXPRESSIONS:
            frame = Frame(238.0, (450.0, 478.0), float(np.radians(rng.normal(0.0, 2.0))))
            scenes.append(Scene(f"{person.name}_{kind}", (Sitter(person, _shown(kind, resting, rng), frame),),
                                srgb(160, 164, 166)))
    return scenes
