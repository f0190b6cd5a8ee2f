# SPDX-License-Identifier: Apache-2.0
"""Square windows on a picture, as the nets see them: the same as in `crop.cpp` and `contour_nets.cpp` of `faces/contours`."""
from dataclasses import dataclass

import cv2
import numpy as np

from contours import SLICES, WINDOW

SHRINK_FROM = 1.5  # picture px per crop px, above which areas are averaged first

# Inputs of the nets, px, and how much of the picture they see.
FACE_PX, EYE_PX, MOUTH_PX, OUTLINE_PX, EYES_PX, JAW_PX = 128, 64, 96, 96, 64, 64
FACE_BY_BOX, FACE_BY_POINTS = 1.25, 1.45
EYE_BY_WIDTH, MOUTH_BY_EXTENT, OUTLINE_BY_EXTENT, EYES_BY_APART = 2.0, 1.6, 1.35, 1.9


@dataclass
class Frame:
    """A window: its centre and side in px, its angle in radians."""
    centre: np.ndarray
    side: float
    angle: float = 0.0
    mirrored: bool = False

    def to_picture(self, size):
        """2 × 3 matrix from px of a crop of `size` px to px of the picture, both counted from the corner."""
        scale = self.side / size
        c, s = np.cos(self.angle) * scale, np.sin(self.angle) * scale
        x = -1.0 if self.mirrored else 1.0
        linear = np.array([[c * x, -s], [s * x, c]])
        return np.c_[linear, self.centre - linear @ [0.5 * size, 0.5 * size]]


def mapped(matrix, points):
    return points @ matrix[:, :2].T + matrix[:, 2]


def inverse(matrix):
    return cv2.invertAffineTransform(matrix)


def angle_of(vector):
    return float(np.arctan2(vector[1], vector[0]))


def frame_around(points, angle, margin):
    """A window upright along `angle` around the points, `margin` times their larger extent."""
    across = np.array([np.cos(angle), np.sin(angle)])
    axes = np.stack([across, [-across[1], across[0]]])
    turned = points @ axes.T
    low, high = turned.min(0), turned.max(0)
    return Frame((low + high) / 2 @ axes, margin * (high - low).max(), angle)


def box_frame(box, right_eye, left_eye):
    """Around a detected box (x, y, width, height)."""
    x, y, width, height = box
    return Frame(np.array([x + width / 2, y + height / 2]), FACE_BY_BOX * max(width, height),
                 angle_of(np.subtract(left_eye, right_eye)))


def face_frame(points):
    return frame_around(points[WINDOW], angle_of(points[16] - points[0]), FACE_BY_POINTS)


def eye_frame(eye, mirrored):
    along = (eye[0] - eye[8]) if mirrored else (eye[8] - eye[0])
    return Frame((eye.min(0) + eye.max(0)) / 2, EYE_BY_WIDTH * np.linalg.norm(along), angle_of(along), mirrored)


def eyes_frame(points):
    """Around the middle between both eyes' outer corners, upright along them."""
    across = points[16] - points[0]
    return Frame((points[0] + points[16]) / 2, EYES_BY_APART * np.linalg.norm(across), angle_of(across))


def mouth_frame(lips):
    """(40, 2) points of both lips."""
    return frame_around(lips, angle_of(lips[10] - lips[0]), MOUTH_BY_EXTENT)


def outline_frame(points):
    """Upright along the eyes, around eyes, mouth and outline."""
    return frame_around(points[:SLICES["outline"].stop], angle_of(points[16] - points[0]), OUTLINE_BY_EXTENT)


def warp(picture, to_picture, size):
    """What a window shows: (size, size, 3) 8-bit. `to_picture` as from `Frame.to_picture`; outside the picture its
    border is repeated."""
    half = np.array([0.5, 0.5])
    matrix = to_picture.copy()
    matrix[:, 2] = mapped(to_picture, half) - half  # OpenCV counts from the middle of pixel (0, 0)
    return cv2.warpAffine(picture, matrix, (size, size), flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
                          borderMode=cv2.BORDER_REPLICATE)


def take_crop(picture, frame, size):
    """The window's pixels, areas averaged where it shrinks, and the matrix from crop to picture px."""
    to_picture = frame.to_picture(size)
    scale = frame.side / size
    if scale <= SHRINK_FROM:
        return warp(picture, to_picture, size), to_picture
    reach = 0.5 * frame.side * (abs(np.cos(frame.angle)) + abs(np.sin(frame.angle))) + 0.02 * frame.side + 3.0
    limit = np.array(picture.shape[1::-1])
    low = np.clip(np.floor(frame.centre - reach), 0, limit - 1).astype(int)
    high = np.maximum(np.clip(np.ceil(frame.centre + reach), 0, limit), low + 1).astype(int)
    window = picture[low[1]:high[1], low[0]:high[0]]
    shrunk = np.maximum(1, np.round((high - low) / scale)).astype(int)
    zoom = shrunk / (high - low)
    source = cv2.resize(window, tuple(int(v) for v in shrunk), interpolation=cv2.INTER_AREA)
    to_source = np.c_[to_picture[:, :2] * zoom[:, None], (to_picture[:, 2] - low) * zoom]
    return warp(source, to_source, size), to_picture
