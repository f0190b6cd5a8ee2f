# SPDX-License-Identifier: Apache-2.0
"""What the net of dark glasses is shown, and what it answers: whether dark glasses hide the eyes.

The window lies upright along the eyes, `EYES_BY_APART` times as wide as their outer corners are apart. The answer is
one number, above 0 for dark glasses.
"""
import numpy as np

from augmentation import Jitter, covered, degraded, jittered, relit, turned_aside, with_glare
from crops import EYES_BY_APART, EYES_PX, eyes_frame, inverse, mapped, warp
from drawn_glasses import with_glasses, with_one_hidden, with_shadow
from portraits import turned, warped

APART_PX = 60.0
DRAWN_AT = 2  # times the net's pixels, so that rims are smooth
JITTER = Jitter(0.05, 0.15, 0.12)


class GlassesBatches:
    """Batch number `step` is the same whenever it is made. Half of the portraits, of which none wears dark glasses, get
    some."""

    def __init__(self, portraits, seed, size=64):
        self.seed, self.size = seed, size
        plain = [portrait.shrunk(APART_PX * DRAWN_AT) for portrait in portraits]
        heads = plain + turned(plain, seed)
        self.portraits = heads + warped(heads, "closed", seed)
        weights = np.array([p.weight for p in self.portraits])
        self.shares = weights / weights.sum()

    def sample(self, portrait, rng):
        """8-bit crop, and 1 for dark glasses, else 0."""
        size = DRAWN_AT * EYES_PX
        frame = eyes_frame(portrait.points)
        frame.mirrored = bool(rng.random() < 0.5)
        to_picture = jittered(frame.to_picture(size), size, JITTER, rng)
        crop, eyes = warp(portrait.picture, to_picture, size), mapped(inverse(to_picture), portrait.points[:32])
        if frame.mirrored:  # the eye on the picture's left comes first, its outer corner first
            eyes = np.concatenate([eyes[16:], eyes[:16]])
        if rng.random() < 0.3:
            crop, eyes = turned_aside(crop, eyes, rng)
        if rng.random() < 0.3:
            crop = with_shadow(crop, eyes, rng)
        is_dark = rng.random() < 0.5
        if not is_dark and rng.random() < 0.2:
            crop = with_one_hidden(crop, eyes, rng)
        elif is_dark or rng.random() < 0.4:
            crop = with_glasses(crop, eyes, is_dark, rng)
            if rng.random() < 0.2:
                crop = with_glare(crop, eyes[:16].mean(0), np.ptp(eyes[:16], 0).max(), rng)
        if rng.random() < 0.15:
            crop = covered(crop, rng)
        crop = crop.reshape(EYES_PX, DRAWN_AT, EYES_PX, DRAWN_AT, 3).mean((1, 3)).astype(np.uint8)
        return degraded(crop, rng), float(is_dark)

    def __call__(self, step):
        """(B, 3, s, s) pixels as the net wants them, (B, 1) answers."""
        rng = np.random.default_rng([self.seed, step])
        chosen = rng.choice(len(self.portraits), self.size, p=self.shares)
        pairs = [self.sample(self.portraits[i], rng) for i in chosen]
        pixels = (relit(np.stack([crop for crop, _ in pairs]), rng) - np.float32(127.5)) / np.float32(255.0)
        return pixels.transpose(0, 3, 1, 2), np.array([[dark] for _, dark in pairs], np.float32)
