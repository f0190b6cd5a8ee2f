# SPDX-License-Identifier: Apache-2.0
"""What the net of hidden jaws is shown, and what it answers: whether a beard, and whether hair, hides the jaw.

The window is that of the outline's net, whose layers it starts from, in fewer pixels. The labels are what somebody saw in the photographs
in the wild.
"""
import numpy as np

from augmentation import Jitter, covered, degraded, jittered, relit, turned_aside
from crops import JAW_PX, outline_frame, warp
from photos import ROOT

KINDS = ("jaw_beard", "jaw_hair")
NOT_PLAIN = {"group", "no_face", "painting"}
APART_PX = 60.0
JITTER = Jitter(0.05, 0.12, 0.1)


def wild_words():
    """"wild/file.jpg" → the words of its label."""
    lines = (ROOT / "tests" / "faces" / "wild_labels.txt").read_text(encoding="utf-8").splitlines()
    return {f"wild/{line.split()[0]}": set(line.split()[1:]) for line in lines if line and not line.startswith("#")}


class JawBatches:
    """Batch number `step` is the same whenever it is made. A third of it has a beard, a third hair before the jaw."""

    def __init__(self, portraits, seed, size=48):
        self.seed, self.size = seed, size
        words = wild_words()
        portraits = [p for p in portraits if p.name in words and not words[p.name] & NOT_PLAIN]
        self.portraits = [p.shrunk(APART_PX) for p in portraits]
        self.hidden = np.array([[kind in words[p.name] for kind in KINDS] for p in portraits], np.float32)
        free = 1.0 - self.hidden.max(1)
        self.shares = sum(part / part.sum() for part in (free, *self.hidden.T)) / 3.0

    def sample(self, portrait, rng):
        frame = outline_frame(portrait.points)
        frame.mirrored = bool(rng.random() < 0.5)
        crop = warp(portrait.picture, jittered(frame.to_picture(JAW_PX), JAW_PX, JITTER, rng), JAW_PX)
        if rng.random() < 0.3:
            crop, _ = turned_aside(crop, np.zeros((1, 2)), rng)
        if rng.random() < 0.2:
            crop = covered(crop, rng)
        return degraded(crop, rng)

    def __call__(self, step):
        """(B, 3, s, s) pixels as the net wants them, (B, 2) answers."""
        rng = np.random.default_rng([self.seed, step])
        chosen = rng.choice(len(self.portraits), self.size, p=self.shares)
        crops = np.stack([self.sample(self.portraits[i], rng) for i in chosen])
        pixels = (relit(crops, rng) - np.float32(127.5)) / np.float32(255.0)
        return pixels.transpose(0, 3, 1, 2), self.hidden[chosen]
