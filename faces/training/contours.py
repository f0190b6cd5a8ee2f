# SPDX-License-Identifier: Apache-2.0
"""How the points of a face are numbered, what a mirror does to them, and the distance between contours.

Points are (x, y) in pixels of a picture whose corner is (0, 0); right and left are the person's own. The numbering is
that of `faces/contours/contour_nets.cpp`: an eye and a brow start at their outer end, a lip at the right corner of the
mouth, and all of them take their lower edge first. The nose goes from the top of its right wing round below to that of
the left.
An iris is its centre and, further on, a point of its rim on the outer side, along the line between the eyes' centres.
"""
import numpy as np

EYE, LIP, OUTLINE, BROW, NOSE = 16, 20, 33, 10, 11  # points of each feature
SLICES = {
    "right_eye": slice(0, 16), "left_eye": slice(16, 32),
    "outer_lip": slice(32, 52), "inner_lip": slice(52, 72),
    "outline": slice(72, 105), "irises": slice(105, 107), "rims": slice(107, 109),
    "right_brow": slice(109, 119), "left_brow": slice(119, 129), "nose": slice(129, 140),
}
COUNT = 140
WINDOW = slice(0, 107)  # the points that say where the window of the face net lies
MOUTH = slice(32, 72)
CONTOURS = ("right_eye", "left_eye", "outer_lip", "inner_lip", "outline")
CLOSED = {name: name != "outline" for name in CONTOURS}
SAMPLES = 60  # points to which contours are resampled to be compared


def mirror_order():
    """Index of the point that a mirror puts where point i is numbered: (140,)."""
    lip = [(LIP // 2 - i) % LIP for i in range(LIP)]
    return np.array([*range(16, 32), *range(0, 16), *(32 + i for i in lip), *(52 + i for i in lip),
                     *range(104, 71, -1), 106, 105, 108, 107,
                     *range(119, 129), *range(109, 119), *range(139, 128, -1)])


MIRROR = mirror_order()
MOUTH_MIRROR = MIRROR[MOUTH] - MOUTH.start
OUTLINE_MIRROR = MIRROR[SLICES["outline"]] - SLICES["outline"].start


def features_of(points):
    """The five contours among (140, 2) points, by name."""
    return {name: points[SLICES[name]] for name in CONTOURS}


def length_along(line):
    """Arc length at each point of an open line (n, 2): (n,)."""
    return np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]


def at_lengths(line, lengths):
    """Points of an open line (n, 2) at the given arc lengths."""
    along = length_along(line)
    return np.stack([np.interp(lengths, along, line[:, k]) for k in (0, 1)], -1)


def resampled(line, count, closed):
    """`count` points at equal distances along a line; of a closed one the last is not the first again."""
    line = np.asarray(line, float)
    if closed:
        line = np.vstack([line, line[:1]])
    return at_lengths(line, np.linspace(0.0, length_along(line)[-1], count, endpoint=not closed))


def distances(points, line, closed):
    """Distance of each of the points (n, 2) to the line: (n,)."""
    line = np.asarray(line, float)
    if closed:
        line = np.vstack([line, line[:1]])
    start, step = line[:-1], np.diff(line, axis=0)
    offset = points[:, None] - start
    at = (offset * step).sum(-1) / np.maximum((step * step).sum(-1), 1e-12)
    return np.linalg.norm(offset - np.clip(at, 0.0, 1.0)[..., None] * step, axis=-1).min(1)


def outer_inter_ocular_distance(contours):
    """How far both eyes together reach along the line through their centres."""
    right, left = contours["right_eye"], contours["left_eye"]
    along = resampled(left, SAMPLES, True).mean(0) - resampled(right, SAMPLES, True).mean(0)
    along /= np.linalg.norm(along)
    return float((left @ along).max() - (right @ along).min())


def contour_error(truth, found, name):
    """Percent of the truth's outer inter-ocular distance; the definition of `faces/evaluation/contour_error.hpp`."""
    closed = CLOSED[name]
    error = distances(resampled(truth[name], SAMPLES, closed), found[name], closed).mean()
    if closed:
        error = 0.5 * (error + distances(resampled(found[name], SAMPLES, True), truth[name], True).mean())
    return 100.0 * error / outer_inter_ocular_distance(truth)
