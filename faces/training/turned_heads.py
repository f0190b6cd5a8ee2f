# SPDX-License-Identifier: Apache-2.0
"""Heads turned aside and nodded, from frontal portraits: the face mesh has a depth for every point, so the face can be
looked at from elsewhere, and so can the labels.

What lies around the face (ears, hair, shoulders) follows on rings that move less the further out they lie, as in face
profiling (Zhu et al., Face alignment across large poses, CVPR 2016). What would hide behind the nose or a cheek does.
"""
import cv2
import numpy as np

from contours import SLICES
from teacher import silhouette_below_eyes

# Rings around the face's silhouette: how far out from its middle, how much of the turn they follow, and how far behind
# the silhouette they lie, in distances of the outer corners of the eyes.
RINGS = ((1.06, 1.0, 0.03), (1.2, 1.0, 0.18), (1.55, 0.55, 0.6), (2.1, 0.0, 1.2), (4.0, 0.0, 1.5))
AROUND = 36  # points of a ring


def turn_matrix(yaw, nod, across):
    """3 × 3: about the head's own upright axis, then about its own horizontal one; radians. `across` is the unit vector
    in the picture from the right eye to the left one. Positive yaw moves what is near the camera along it, positive nod
    down the face."""
    along = np.array([[across[0], across[1], 0.0], [-across[1], across[0], 0.0], [0.0, 0.0, 1.0]])
    c, s = np.cos(yaw), np.sin(yaw)
    about_upright = np.array([[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]])
    c, s = np.cos(nod), np.sin(nod)
    about_across = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    return along.T @ about_across @ about_upright @ along


class SolidHead:
    """Places in a picture with depths, in triangles, before and after the turn."""

    def __init__(self, skin, points):
        apart = np.linalg.norm(points[16] - points[0])
        self.across = (points[16] - points[0]) / apart
        self.middle = np.r_[skin[:, :2].mean(0), skin[:, 2].mean() + 0.4 * apart]  # of the skull, not of the skin
        hull = cv2.convexHull(skin[:, :2].astype(np.float32), returnPoints=False)[:, 0]
        centre = skin[hull, :2].mean(0)
        angles = np.arctan2(*(skin[hull, :2] - centre).T[::-1])
        order = np.argsort(angles)
        turns = np.linspace(-np.pi, np.pi, AROUND, endpoint=False)
        edge = np.stack([np.interp(turns, angles[order], skin[hull[order], k], period=2 * np.pi) for k in range(3)], -1)
        rings, follow = [skin], [np.ones(len(skin))]
        for out, share, behind in RINGS:
            rings.append(np.c_[centre + out * (edge[:, :2] - centre), edge[:, 2] + behind * apart])
            follow.append(np.full(AROUND, share))
        self.skin_count = len(skin)
        self.places, self.follow = np.vstack(rings), np.concatenate(follow)
        self.triangles = delaunay(self.places[:, :2])

    def turned(self, yaw, nod):
        """Where the places come to lie: (n, 3)."""
        turned = (self.places - self.middle) @ turn_matrix(yaw, nod, self.across).T + self.middle
        share = self.follow[:, None]
        return np.c_[self.places[:, :2] * (1 - share) + turned[:, :2] * share, turned[:, 2]]

    def carried(self, points, places):
        """Where (m, 2) points on the picture come to lie when the head's places are moved: (m, 2)."""
        corners = self.places[self.triangles][..., :2]
        weights = barycentric(points[:, None], corners[None])
        inside = weights.min(-1).argmax(1)
        rows = np.arange(len(points))
        return np.einsum("mk,mkd->md", weights[rows, inside], places[self.triangles[inside]][..., :2])


def delaunay(points):
    """Triangles (t, 3) over (n, 2) points, of which no two are at one place."""
    exact = points.astype(np.float32)
    low, high = np.floor(exact.min(0)).astype(int) - 1, np.ceil(exact.max(0)).astype(int) + 2
    plane = cv2.Subdiv2D((*low.tolist(), *(high - low).tolist()))
    plane.insert(exact.tolist())
    number = {tuple(place): i for i, place in enumerate(exact.tolist())}
    corners = plane.getTriangleList().reshape(-1, 3, 2).tolist()  # some of a frame around all points
    return np.array([[number[tuple(place)] for place in three] for three in corners
                     if all(tuple(place) in number for place in three)])


def barycentric(points, corners):
    """Weights of the corners (…, 3, 2) at the points (…, 2): (…, 3)."""
    a, b, c = corners[..., 0, :], corners[..., 1, :], corners[..., 2, :]
    ab, ac, ap = b - a, c - a, points - a
    area = ab[..., 0] * ac[..., 1] - ab[..., 1] * ac[..., 0]
    area = np.where(np.abs(area) < 1e-9, 1e-9, area)
    second = (ap[..., 0] * ac[..., 1] - ap[..., 1] * ac[..., 0]) / area
    third = (ab[..., 0] * ap[..., 1] - ab[..., 1] * ap[..., 0]) / area
    return np.stack([1.0 - second - third, second, third], -1)


def planes(corners, values):
    """For triangles (t, 3, 2) and what holds at their corners (t, 3, k): the linear functions through it, as
    (t, 3, k) with rows for 1, x and y; triangles seen from the edge give 0."""
    system = np.concatenate([np.ones_like(corners[..., :1]), corners], -1)
    flat = np.abs(np.linalg.det(system)) < 1e-6
    system[flat] = np.eye(3)
    return np.linalg.solve(system, np.where(flat[:, None, None], 0.0, values))


def sources(head, places, size):
    """For every pixel of a (height, width) picture of the turned head the place that it shows: (h, w, 2), px."""
    height, width = size
    x, y = np.arange(width, dtype=np.float32) + 0.5, np.arange(height, dtype=np.float32) + 0.5
    shown = np.stack(np.meshgrid(x, y), -1)
    nearest = np.full(size, np.inf, np.float32)
    corners = places[head.triangles]
    values = np.concatenate([np.broadcast_to(np.eye(3), (len(corners), 3, 3)), corners[..., 2:],
                             head.places[head.triangles, :2]], -1)
    functions = planes(corners[..., :2], values).astype(np.float32)
    low = np.clip(np.ceil(corners[..., :2].min(1) - 0.5), 0, [width, height]).astype(int)
    high = np.clip(np.floor(corners[..., :2].max(1) + 0.5), 0, [width, height]).astype(int)
    for function, (left, top), (right, bottom) in zip(functions, low, high):
        if left >= right or top >= bottom or not function.any():
            continue
        part = slice(top, bottom), slice(left, right)
        here = function[0] + x[left:right, None] * function[1] + y[top:bottom, None, None] * function[2]
        seen = (here[..., :3].min(-1) >= -1e-4) & (here[..., 3] < nearest[part])
        nearest[part][seen] = here[..., 3][seen]
        shown[part][seen] = here[..., 4:][seen]
    return shown


def turned_outline(head, points, places):
    """(33, 2): the silhouette of the turned face as far out as its outline was drawn."""
    line = points[SLICES["outline"]]
    skin = head.places[:head.skin_count, :2]
    upwards = [head.across[1], -head.across[0]]
    drawn = line.astype(np.float32).reshape(-1, 1, 2)
    inside = np.array([cv2.pointPolygonTest(drawn, place, False) > 0 for place in skin.tolist()])
    inside |= (skin - line[[0, -1]].mean(0)) @ upwards > 0.0  # nobody drew a line above the eyes
    eyes = head.carried(points[[0, 16]], places)
    solid = np.vstack([head.carried(line, places), places[:head.skin_count, :2][inside]])
    return silhouette_below_eyes(solid, *eyes)


def turned_head(picture, points, skin, yaw, nod):
    """The picture, its (140, 2) points and the mesh (468, 3) after a turn of the head in radians."""
    head = SolidHead(skin, points)
    places = head.turned(yaw, nod)
    shown = (sources(head, places, picture.shape[:2]) - 0.5).astype(np.float32)
    moved = head.carried(points, places)
    moved[SLICES["outline"]] = turned_outline(head, points, places)
    turned = cv2.remap(picture, shown[..., 0], shown[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return turned, moved, places[:head.skin_count]
