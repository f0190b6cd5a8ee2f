# SPDX-License-Identifier: Apache-2.0
"""What people place differently from the teacher, learned from the training half of the hand-placed contours.

For an eye and for the mouth, in a frame that runs from corner to corner: offset = mean + W · (the few strongest ways
in which the teacher's points vary), by ridge regression. Outlines get no correction: cross-validated on the training
half none made them better. The mirror of each face counts as another one, so that both sides are treated alike.
"""
import numpy as np

from contours import MIRROR, MOUTH, SLICES

COMPONENTS, RIDGE = 4, 30.0
ACROSS = np.array([-1.0, 1.0])
CORNERS = {"eye": (SLICES["right_eye"], 8), "mouth": (MOUTH, 10)}  # first corner at 0, second at this index


def mirrored(points):
    return (points * ACROSS)[MIRROR]


def to_frame(part, origin, along):
    """From picture px into the frame whose x axis is `along`, as long as one unit, and back."""
    z = ((part - origin) @ [1.0, 1.0j]) / complex(*along)
    return np.stack([z.real, z.imag], -1)


def from_frame(part, origin, along):
    z = (part @ [1.0, 1.0j]) * complex(*along)
    return np.stack([z.real, z.imag], -1) + origin


class FeatureCorrection:
    def __init__(self, feature, pairs):
        """`pairs` of (140, 2) points: the teacher's and those on the hand-placed contours."""
        self.slice, self.corner = CORNERS[feature]
        said, offsets = [], []
        for teacher, truth in pairs:
            origin, along = self.frame_of(teacher)
            said.append(to_frame(teacher[self.slice], origin, along).ravel())
            offsets.append(to_frame(truth[self.slice], origin, along).ravel() - said[-1])
        said, offsets = np.array(said), np.array(offsets)
        self.mean, self.offset = said.mean(0), offsets.mean(0)
        _, _, directions = np.linalg.svd(said - self.mean, full_matrices=False)
        basis = directions[:COMPONENTS]
        along_basis = (said - self.mean) @ basis.T
        self.basis = basis / along_basis.std(0)[:, None]
        along_basis = along_basis / along_basis.std(0)
        self.weights = np.linalg.solve(along_basis.T @ along_basis + RIDGE * np.eye(len(basis)),
                                       along_basis.T @ (offsets - self.offset))

    def frame_of(self, points):
        part = points[self.slice]
        return part[0], part[self.corner] - part[0]

    def __call__(self, points):
        """The corrected part of (140, 2) points."""
        origin, along = self.frame_of(points)
        said = to_frame(points[self.slice], origin, along).ravel()
        # Faces unlike all of the training half are corrected as the most unlike of those would be.
        far = np.clip((said - self.mean) @ self.basis.T, -2.5, 2.5)
        return from_frame((said + self.offset + far @ self.weights).reshape(-1, 2), origin, along)


class Correction:
    def __init__(self, pairs):
        pairs = [pair for teacher, truth in pairs
                 for pair in ((teacher, truth), (mirrored(teacher), mirrored(truth)))]
        self.eye, self.mouth = FeatureCorrection("eye", pairs), FeatureCorrection("mouth", pairs)

    def __call__(self, points):
        """(140, 2) points of the teacher → the same with eyes and lips where people would place them."""
        result = points.copy()
        result[SLICES["right_eye"]] = self.eye(points)
        result[SLICES["left_eye"]] = self.eye(mirrored(points)) * ACROSS
        result[MOUTH] = self.mouth(points)
        return result
