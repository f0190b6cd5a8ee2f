# SPDX-License-Identifier: Apache-2.0
"""Points from the teacher: MediaPipe's 478-point face mesh, started from YuNet's box.

Two passes find the face; then the answers for several views (mirrored, shifted, scaled, turned) are averaged, which
takes out much of what depends on where the window happens to lie.
"""
from dataclasses import dataclass

import cv2
import numpy as np

from contours import COUNT, MIRROR, OUTLINE, at_lengths, length_along
from crops import Frame, angle_of, frame_around, mapped, take_crop

INPUT_PX = 256
MARGIN = 1.5  # window per extent of the box, then of the points
SKIN = 468    # of 478 points; the others are the irises
PRESENCE_OF_FACE = 8.0  # below this the teacher is not sure that there is a face: 12.5 and more on clean portraits
SMALLEST_BOX = 120.0  # px; smaller faces are enlarged for the detector and the mesh

# Which of the mesh's points are our features', in our order.
RIGHT_EYE = [33, 7, 163, 144, 145, 153, 154, 155, 133, 173, 157, 158, 159, 160, 161, 246]
LEFT_EYE = [263, 249, 390, 373, 374, 380, 381, 382, 362, 398, 384, 385, 386, 387, 388, 466]
OUTER_LIP = [61, 146, 91, 181, 84, 17, 314, 405, 321, 375, 291, 409, 270, 269, 267, 0, 37, 39, 40, 185]
INNER_LIP = [78, 95, 88, 178, 87, 14, 317, 402, 318, 324, 308, 415, 310, 311, 312, 13, 82, 81, 80, 191]
IRISES = [468, 473]
RIMS = [[469, 470, 471, 472], [474, 475, 476, 477]]
RIGHT_BROW = [46, 53, 52, 65, 55, 107, 66, 105, 63, 70]
LEFT_BROW = [276, 283, 282, 295, 285, 336, 296, 334, 293, 300]
NOSE = [115, 48, 64, 98, 97, 2, 326, 327, 294, 278, 344]

# Views of the last pass: shift of the window by its side, scale, turn in radians, mirrored.
VIEWS = [(sx, sy, scale, turn, mirrored)
         for mirrored in (False, True)
         for sx, sy, scale, turn in ((0.0, 0.0, 1.0, 0.0), (0.02, 0.015, 1.06, 0.05))]
ONE_VIEW = VIEWS[:1]


def silhouette_below_eyes(mesh, right, left, count=OUTLINE):
    """`count` points along the hull of the projected mesh (n, 2) from ear to ear by the chin, starting at the level
    of the eyes on the side of the right one."""
    across = (left - right) / np.linalg.norm(left - right)
    axes = np.stack([across, [-across[1], across[0]]])
    middle = (left + right) / 2
    flat = ((mesh - middle) @ axes.T).astype(np.float32)
    hull = cv2.convexHull(flat)[:, 0].astype(float)
    start = next(i for i in range(len(hull)) if hull[i, 1] <= 0.0 < hull[(i + 1) % len(hull), 1])
    hull = np.roll(hull, -start, axis=0)
    hull = np.vstack([hull, hull[:1]])
    last = next(i for i in range(1, len(hull)) if hull[i, 1] > 0.0 >= hull[i + 1, 1])

    def crossing(a, b):
        return a + (b - a) * (a[1] / (a[1] - b[1]))
    below = np.vstack([crossing(hull[0], hull[1]), hull[1:last + 1], crossing(hull[last], hull[last + 1])])
    if below[0, 0] > below[-1, 0]:
        below = below[::-1]
    return at_lengths(below, np.linspace(0.0, length_along(below)[-1], count)) @ axes + middle


def outer_rims(mesh):
    """(2, 2): from the centre of each iris outwards by its radius, along the line between both centres."""
    right, left = mesh[IRISES]
    outwards = (right - left) / np.linalg.norm(right - left)
    radii = [np.linalg.norm(mesh[rim] - mesh[centre], axis=1).mean() for centre, rim in zip(IRISES, RIMS)]
    return np.array([right + radii[0] * outwards, left - radii[1] * outwards])


@dataclass
class Seen:
    """A face as the teacher sees it, px of the picture."""
    points: np.ndarray  # (140, 2), ours
    skin: np.ndarray    # (468, 3), its mesh from the forehead to the chin, the third coordinate away from the camera

    @property
    def box(self):
        """(2, 2): least and largest corner of the mesh."""
        return np.stack([self.skin[:, :2].min(0), self.skin[:, :2].max(0)])


class Teacher:
    def __init__(self, faces):
        models = faces / "models"
        self.mesh = cv2.dnn.readNetFromONNX(str(models / "teacher_face_mesh.onnx"))
        self.detector = cv2.FaceDetectorYN.create(str(models / "yunet.onnx"), "", (320, 320), 0.6, 0.3, 5000)

    def face_in(self, picture):
        """The largest face: YuNet's row of box (x, y, width, height) and marks, px; None where there is none."""
        scale = min(1.0, 640.0 / max(picture.shape[:2]))
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        self.detector.setInputSize(small.shape[1::-1])
        _, rows = self.detector.detect(small)
        if rows is None:
            return None
        return max(rows[:, :14].astype(float) / scale, key=lambda row: row[2] * row[3])

    def answer(self, picture, frame):
        """Mesh points (478, 3) in px of the picture, the third away from the camera, and the presence score."""
        crop, to_picture = take_crop(picture, frame, INPUT_PX)
        self.mesh.setInput(cv2.dnn.blobFromImage(crop, 1.0 / 255.0, swapRB=True))
        points, presence = self.mesh.forward(["t473", "t472"])
        points = points.reshape(-1, 3).astype(float)
        solid = np.c_[mapped(to_picture, points[:, :2]), points[:, 2] * (frame.side / INPUT_PX)]
        return solid, float(presence.reshape(-1)[0])

    @staticmethod
    def frame_of(mesh):
        flat = mesh[:, :2]
        return frame_around(flat[:SKIN], angle_of(flat[LEFT_EYE[0]] - flat[RIGHT_EYE[0]]), MARGIN)

    @staticmethod
    def points_of(mesh):
        """Our (140, 2) points."""
        mesh = mesh[:, :2]
        outline = silhouette_below_eyes(mesh[:SKIN], mesh[RIGHT_EYE[0]], mesh[LEFT_EYE[0]])
        return np.vstack([mesh[RIGHT_EYE + LEFT_EYE + OUTER_LIP + INNER_LIP], outline, mesh[IRISES], outer_rims(mesh),
                          mesh[RIGHT_BROW + LEFT_BROW + NOSE]])

    def locate(self, picture, views=VIEWS):
        """What is seen of the largest face; nothing where no face is sure."""
        row = self.face_in(picture)
        enlarged = 1.0
        if row is None or max(row[2:4]) < SMALLEST_BOX:
            enlarged = 2.0
            picture = cv2.resize(picture, None, fx=2, fy=2, interpolation=cv2.INTER_CUBIC)
            row = self.face_in(picture)
        if row is None:
            return None
        x, y, width, height = row[:4]
        frame = Frame(np.array([x + width / 2, y + height / 2]), MARGIN * max(width, height),
                      angle_of(row[6:8] - row[4:6]))
        mesh, presence = self.answer(picture, frame)
        if presence < PRESENCE_OF_FACE:
            return None
        if views is not ONE_VIEW:  # the views are the last pass
            mesh, _ = self.answer(picture, self.frame_of(mesh))
        base = self.frame_of(mesh)
        total, skin = np.zeros((COUNT, 2)), None
        for sx, sy, scale, turn, mirrored in views:
            frame = Frame(base.centre + base.side * np.array([sx, sy]), base.side * scale, base.angle + turn, mirrored)
            seen, _ = self.answer(picture, frame)
            skin = seen[:SKIN] if skin is None else skin
            total += self.points_of_mirrored(seen) if mirrored else self.points_of(seen)
        return Seen(total / len(views) / enlarged, skin / enlarged)

    @classmethod
    def points_of_mirrored(cls, mesh):
        """The same from a mesh that was found in a mirror, where the person's right is their left."""
        across = np.array([-1.0, 1.0])
        return (cls.points_of(mesh[:, :2] * across) * across)[MIRROR]
