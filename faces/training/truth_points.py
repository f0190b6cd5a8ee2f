# SPDX-License-Identifier: Apache-2.0
"""Hand-placed contours as labels: the teacher's points moved onto the lines that people drew.

A hand-placed eye has 8 points, a lip 12, an outline 19; our 16, 20 and 33 keep their places along the line: each stays
at its share of the way between the two corners.
"""
import numpy as np

from contours import CLOSED, CONTOURS, SLICES, at_lengths, length_along


def shares(line):
    """Share of the way along an open line at each of its points."""
    along = length_along(line)
    return along / along[-1]


def arcs(ring):
    """Lower and upper edge of a closed feature, both from its first corner to the one half way round."""
    half = len(ring) // 2
    return ring[:half + 1], np.vstack([ring[:1], ring[:half - 1:-1]])


def placed_on(line, like):
    """Points on an open line at the shares at which those of `like` lie along theirs."""
    return at_lengths(line, shares(like) * length_along(line)[-1])


def truth_arcs(name, ring):
    """The drawn ring starts at the picture's left and goes over the top; ours start at the outer corner of the eye,
    at the right corner of the mouth, which for the left eye is the far end."""
    upper, lower = arcs(ring)
    return (lower[::-1], upper[::-1]) if name == "left_eye" else (lower, upper)


def truth_labels(truth, teacher):
    """(140, 2) points on the hand-placed contours, spread as the teacher's; the rest stays the teacher's."""
    points = teacher.copy()
    for name in CONTOURS:
        own = teacher[SLICES[name]]
        if not CLOSED[name]:
            points[SLICES[name]] = placed_on(truth[name], own)
            continue
        lower, upper = (placed_on(drawn, like)
                        for drawn, like in zip(truth_arcs(name, truth[name]), arcs(own)))
        points[SLICES[name]] = np.vstack([lower, upper[-2:0:-1]])
    return points
