#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The parts of the trainer that need neither portraits nor torch: labels under a mirror, hold-out, metric, windows,
warps, scenes."""
import copy
import importlib.machinery
import importlib.util
import sys
import unittest
import unittest.mock
from pathlib import Path

MISSING = [name for name in ("numpy", "cv2") if importlib.util.find_spec(name) is None]
if MISSING:
    print(f"skipped: needs {' and '.join(MISSING)} (python3-numpy, python3-opencv)")
    sys.exit(77)
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "faces" / "training"))

import cv2
import numpy as np

import augmentation
import contours
import crops
import detector_scenes
import photos
import portraits
import tasks
import trainer_packages
import turned_heads
import warps
from contours import CLOSED, CONTOURS, MIRROR, SLICES
from correction import Correction
from truth_points import truth_labels


def drawn_face(apart=120.0, middle=(200.0, 180.0)):
    """(107, 2) points of a plain, slightly lopsided face."""
    points = np.zeros((contours.COUNT, 2))

    def ring(count, x, y, rx, up, down):
        turn = 2.0 * np.pi * np.arange(count) / count
        way = np.stack([-np.cos(turn), np.sin(turn)], -1)  # from the left by the lower edge
        return [x, y] + way * np.where(way[:, 1:] > 0, [[rx, down]], [[rx, up]])
    points[SLICES["right_eye"]] = ring(16, -0.35, 0.0, 0.15, 0.06, 0.05)
    points[SLICES["left_eye"]] = ring(16, -0.34, 0.01, 0.16, 0.06, 0.05) * [-1, 1]
    points[SLICES["outer_lip"]] = ring(20, 0.01, 0.75, 0.28, 0.09, 0.12)
    points[SLICES["inner_lip"]] = ring(20, 0.01, 0.75, 0.26, 0.02, 0.03)
    turn = np.linspace(np.pi, 0.0, 33)
    points[SLICES["outline"]] = np.stack([0.8 * np.cos(turn), 1.25 * np.sin(turn)], -1)
    points[SLICES["irises"]] = [[-0.35, 0.0], [0.34, 0.01]]
    return points * apart + middle


def skin_of(points):
    """(468, 3): half an ellipsoid around the face, as the teacher's mesh of it."""
    middle, half = points[:105].mean(0), 0.5 * np.ptp(points[:105], axis=0) * [1.02, 1.15]
    at = np.arange(468) + 0.5  # evenly on a disc (Vogel 1979)
    out, turn = np.sqrt(at / 468), at * np.pi * (3.0 - np.sqrt(5.0))
    flat = np.stack([out * np.cos(turn), out * np.sin(turn)], -1)
    return np.c_[middle + flat * half, -half[0] * np.sqrt(1.0 - out ** 2)]


def portrait_of(points):
    rng = np.random.default_rng(7)
    picture = cv2.resize(rng.integers(0, 255, (45, 40, 3)).astype(np.uint8), (400, 450))
    return portraits.Portrait(picture, points, skin_of(points), 1.0)


class Mirror(unittest.TestCase):
    def test_twice_is_nothing(self):
        np.testing.assert_array_equal(MIRROR[MIRROR], np.arange(contours.COUNT))

    def test_a_mirrored_face_is_numbered_like_a_face(self):
        face = drawn_face()
        seen = (face * [-1.0, 1.0])[MIRROR]
        for points in (face, seen):
            right, left = points[SLICES["right_eye"]], points[SLICES["left_eye"]]
            self.assertEqual(np.argmin(right[:, 0]), 0)  # outer corner
            self.assertEqual(np.argmax(left[:, 0]), 0)
            self.assertGreater(left[8, 0], right[8, 0])
            for name in CONTOURS[:4]:
                ring = points[SLICES[name]]
                half = len(ring) // 2
                self.assertGreater(ring[1:half, 1].mean(), ring[half + 1:, 1].mean())  # lower edge first
            for name in ("outer_lip", "inner_lip", "outline"):
                self.assertLess(points[SLICES[name]][0, 0], points[SLICES[name]].mean(0)[0])

    def test_a_crop_in_a_mirror_is_the_flipped_crop(self):
        face = portrait_of(drawn_face())
        frame = crops.Frame(np.array([200.0, 200.0]), 150.0)
        plain, to_picture = crops.take_crop(face.picture, frame, 100)
        frame.mirrored = True
        mirrored, to_picture_mirrored = crops.take_crop(face.picture, frame, 100)
        np.testing.assert_array_equal(mirrored, plain[:, ::-1])
        at = crops.mapped(crops.inverse(to_picture), face.points)
        at_mirrored = crops.mapped(crops.inverse(to_picture_mirrored), face.points)
        np.testing.assert_allclose(at_mirrored, np.array([100.0, 0.0]) + at * [-1.0, 1.0], atol=1e-9)


class Mix(unittest.TestCase):
    """Of two nets of one layer each; needs ONNX, as the trainer does."""

    def setUp(self):
        if importlib.util.find_spec("onnx") is None:
            self.skipTest("needs python3-onnx")
        loader = importlib.machinery.SourceFileLoader("mix", str(photos.HERE / "mix"))
        self.mix = loader.load_module()

    @staticmethod
    def net(weights):
        from onnx import helper, numpy_helper
        tensor = numpy_helper.from_array(np.array(weights, np.float32), "weights")
        return helper.make_model(helper.make_graph([], "net", [], [], [tensor]))

    def test_weights_lie_between(self):
        from onnx import numpy_helper
        mixed = self.mix.mixed(self.net([1.0, 2.0]), self.net([3.0, -2.0]), 0.25)
        np.testing.assert_allclose(numpy_helper.to_array(mixed.graph.initializer[0]), [1.5, 1.0])

    def test_other_layers_are_refused(self):
        with self.assertRaises(SystemExit):
            self.mix.mixed(self.net([1.0, 2.0]), self.net([1.0]), 0.5)


class HoldOut(unittest.TestCase):
    def test_both_pictures_of_a_person_stay_out(self):
        held_out = photos.held_out_people()
        self.assertEqual(len(held_out), 34)
        for person in held_out:
            for picture in (f"london/{person}_03.jpg", f"london/{person}_08.jpg"):
                self.assertTrue(photos.is_held_out(picture, held_out))
        self.assertFalse(photos.is_held_out("ukmp/" + min(held_out) + ".jpg", held_out))

    def test_every_fifth_photograph_in_the_wild_stays_out(self):
        kept_out = photos.listed(photos.HERE / "holdout_wild.txt")
        self.assertEqual(len(kept_out), 103)
        for name in kept_out:
            self.assertTrue(photos.is_held_out("wild/" + name, photos.held_out()))
            self.assertFalse(photos.is_held_out("congress/" + name, photos.held_out()))
        everything = [name.split("/")[1] for name in photos.names_of(photos.DEFAULT_FACES, ("wild",))]
        if everything:
            self.assertEqual(set(everything[::5]), kept_out)

    def test_training_and_hold_out_share_nobody(self):
        if not photos.DEFAULT_FACES.exists():
            self.skipTest("needs ../shared/faces")
        training = {photos.person_of(name) for name in photos.training_names(photos.DEFAULT_FACES)}
        self.assertTrue(training)
        self.assertFalse(training & photos.held_out_people())
        self.assertFalse(training & {"wild/" + name for name in photos.listed(photos.HERE / "holdout_wild.txt")})
        with_truth = {photos.person_of(name) for name in photos.read_truth(photos.truth_file(photos.DEFAULT_FACES))}
        self.assertLessEqual(photos.held_out_people(), with_truth)


class Metric(unittest.TestCase):
    """Two eyes 100 apart at their outer corners, a square mouth, an open outline."""

    @staticmethod
    def face(shift=(0.0, 0.0)):
        def box(left, top, right, bottom):
            return np.array([[left, top], [right, top], [right, bottom], [left, bottom]], float) + shift
        return {"right_eye": box(0, 0, 30, 10), "left_eye": box(70, 0, 100, 10), "outer_lip": box(30, 60, 70, 80),
                "outline": np.array([[-20, 0], [50, 130], [120, 0]], float) + shift}

    def test_outer_corners_give_the_scale(self):
        self.assertAlmostEqual(contours.outer_inter_ocular_distance(self.face()), 100.0)

    def test_same_contours_have_no_error(self):
        for name in self.face():
            self.assertLess(contours.contour_error(self.face(), self.face(), name), 1e-9)

    def test_a_shifted_square_worked_by_hand(self):
        # A square of 40 whose line has 60 points, 8/3 apart, moved right by 2: 15 points on each upright side are 2
        # away, of the level sides' 30 only those that stand out; the rest lie on the other line.
        truth, found = self.face(), self.face()
        truth["outer_lip"] = np.array([[0, 0], [40, 0], [40, 40], [0, 40]], float)
        found["outer_lip"] = truth["outer_lip"] + [2.0, 0.0]
        # Truth: 16 points at x = 0 (both corners) are 2 away; of 16 at x = 40 the 14 between the corners are 2 away,
        # the two corners lie on the level sides. Found: the same from the other side.
        self.assertAlmostEqual(contours.contour_error(truth, found, "outer_lip"), 2.0 * 30 / 60, places=6)

    def test_outline_may_be_longer_than_the_truth(self):
        found = self.face()
        found["outline"] = np.array([[-60, -74.2857143], [-20, 0], [50, 130], [120, 0], [160, -74.2857143]])
        self.assertLess(contours.contour_error(self.face(), found, "outline"), 1e-6)


class Labels(unittest.TestCase):
    def test_hand_placed_labels_lie_on_the_drawn_line_and_keep_their_order(self):
        face = drawn_face()
        drawn = {}
        for name in CONTOURS:  # as people draw them: from the left over the top
            ring = contours.resampled(face[SLICES[name]], 12, CLOSED[name]) + [2.0, -1.0]
            if CLOSED[name]:
                start = np.argmin(ring[:, 0])
                ring = np.roll(ring, -start, 0)
                if ring[1:6, 1].mean() > ring[7:, 1].mean():
                    ring = np.roll(ring[::-1], 1, 0)
            drawn[name] = ring
        labels = truth_labels(drawn, face)
        for name in CONTOURS:
            self.assertLess(contours.distances(labels[SLICES[name]], drawn[name], CLOSED[name]).max(), 1e-9)
            self.assertLess(np.linalg.norm(labels[SLICES[name]] - face[SLICES[name]], axis=1).max(), 15.0, name)

    def test_a_constant_difference_is_learned(self):
        rng = np.random.default_rng(1)
        pairs = []
        for _ in range(20):
            said = drawn_face() + rng.normal(0, 0.3, (contours.COUNT, 2))
            truth = said.copy()
            for name in ("right_eye", "left_eye"):
                truth[SLICES[name]] += [0.0, 2.0]
            pairs.append((said, truth))
        corrected = Correction(pairs)(drawn_face())
        moved = corrected - drawn_face()
        np.testing.assert_allclose(moved[:32].mean(0), [0.0, 2.0], atol=0.15)
        np.testing.assert_allclose(moved[SLICES["outline"]], 0.0)


class Augmentation(unittest.TestCase):
    def test_points_move_with_the_pixels(self):
        """A white dot is found where its label says, whatever window is taken."""
        dot = np.array([[210.0, 190.0]])
        picture = np.zeros((400, 400, 3), np.uint8)
        cv2.circle(picture, (209, 189), 3, (255, 255, 255), -1)  # pixel (209, 189) covers 209 … 210
        rng = np.random.default_rng(3)
        jitter = augmentation.Jitter(0.1, 0.2, 0.2)
        for _ in range(20):
            frame = crops.Frame(np.array([205.0, 195.0]), 120.0, mirrored=bool(rng.integers(2)))
            to_picture = augmentation.jittered(frame.to_picture(96), 96, jitter, rng)
            crop = crops.warp(picture, to_picture, 96)
            at = crops.mapped(crops.inverse(to_picture), dot - 0.5)
            crop, at = augmentation.turned_aside(crop, at, rng)
            weight = crop[..., 0].astype(float)
            y, x = np.mgrid[0:96, 0:96] + 0.5
            found = np.array([(x * weight).sum(), (y * weight).sum()]) / weight.sum()
            self.assertLess(np.linalg.norm(found - at[0]), 0.6)

    def test_the_same_step_gives_the_same_batch(self):
        face = portrait_of(drawn_face())
        for name, task in tasks.TASKS.items():
            first, again = (tasks.Batches(task, [face], 5, 4)(9) for _ in range(2))
            for one, other in zip(first, again):
                np.testing.assert_array_equal(one, other)
            self.assertEqual(first[0].shape, (4, 3, task.size, task.size), name)
            self.assertEqual(first[1].shape, (4, task.points, 2), name)
            self.assertLess(np.abs(first[1]).max(), 1.5, name)

    def test_opened_mouths_are_open_and_the_rest_stays(self):
        face = drawn_face()
        _, moved = warps.opened_mouth(portrait_of(face).picture, face, np.random.default_rng(2))
        np.testing.assert_array_equal(moved[:32], face[:32])
        inner = moved[SLICES["inner_lip"]]
        self.assertGreater(inner[5, 1] - inner[15, 1], face[SLICES["inner_lip"]][5, 1] - inner[15, 1] + 3.0)
        self.assertGreater(moved[SLICES["outline"]][16, 1], face[SLICES["outline"]][16, 1] + 3.0)

    def test_closed_lids_meet(self):
        face = drawn_face()
        for seed in range(6):
            _, moved = warps.closed_eyes(portrait_of(face).picture, face, np.random.default_rng(seed))
            for name in ("right_eye", "left_eye"):
                before, after = face[SLICES[name]], moved[SLICES[name]]
                opening = [(ring[1:8] - ring[:8:-1])[:, 1] for ring in (before, after)]
                self.assertTrue((opening[1] >= -1e-6).all())
                self.assertLess(opening[1].max(), 0.75 * opening[0].max())


    def test_other_lips_move_their_rim_and_nothing_else(self):
        face = drawn_face()
        moved_by = []
        for seed in range(8):
            picture = np.zeros((450, 400, 3), np.uint8)
            low, high = face[SLICES["outer_lip"]][5], face[SLICES["outer_lip"]][15]  # below and above the middle
            for x, y in (low, high):
                cv2.circle(picture, (int(x), int(y)), 2, (255, 255, 255), -1)
            with unittest.mock.patch("warps.blend"):  # the colours stay
                shown, moved = warps.other_lips(picture, face, np.random.default_rng(seed))
            stays = np.ones(contours.COUNT, bool)
            stays[SLICES["outer_lip"]] = False
            np.testing.assert_array_equal(moved[stays], face[stays])
            y, x = np.nonzero(shown[..., 0] > 100)
            for at in moved[SLICES["outer_lip"]][[5, 15]]:
                self.assertLess(np.hypot(x + 0.5 - at[0], y + 0.5 - at[1]).min(), 2.5)
            moved_by.append(np.ptp(moved[SLICES["outer_lip"]][:, 1]) / np.ptp(face[SLICES["outer_lip"]][:, 1]))
        self.assertGreater(max(moved_by), 1.2)
        self.assertLess(min(moved_by), 0.95)


class TurnedHeads(unittest.TestCase):
    SEEN = slice(0, 72)  # eyes and lips

    def test_no_turn_changes_nothing(self):
        face = portrait_of(drawn_face())
        picture, points, skin = turned_heads.turned_head(face.picture, face.points, face.skin, 0.0, 0.0)
        self.assertLess(np.abs(picture.astype(int) - face.picture).max(), 3)
        np.testing.assert_allclose(points[self.SEEN], face.points[self.SEEN], atol=1e-6)
        np.testing.assert_allclose(skin, face.skin, atol=1e-9)

    def test_labels_move_with_the_pixels(self):
        face = portrait_of(drawn_face())
        for i in (4, 20, 37, 47, 105):
            picture = np.zeros((450, 400, 3), np.uint8)
            x, y = face.points[i]
            cv2.circle(picture, (int(x), int(y)), 3, (255, 255, 255), -1)
            for yaw, nod in ((0.4, 0.0), (-0.5, 0.0), (0.0, 0.3), (0.3, -0.2)):
                shown, points, _ = turned_heads.turned_head(picture, face.points, face.skin, yaw, nod)
                weight = shown[..., 0].astype(float)
                self.assertGreater(weight.sum(), 1000.0)
                rows, columns = np.mgrid[0:450, 0:400] + 0.5
                found = np.array([(columns * weight).sum(), (rows * weight).sum()]) / weight.sum()
                self.assertLess(np.linalg.norm(found - points[i]), 1.5, (i, yaw, nod))

    def test_a_head_in_a_mirror_turns_the_other_way(self):
        face = portrait_of(drawn_face())
        across, shift = [-1.0, 1.0], [400.0, 0.0]
        mirrored_skin = face.skin * [-1.0, 1.0, 1.0] + [400.0, 0.0, 0.0]
        mirrored = ((face.points * across) + shift)[MIRROR]
        _, points, _ = turned_heads.turned_head(face.picture, face.points, face.skin, 0.4, 0.1)
        _, seen, _ = turned_heads.turned_head(face.picture[:, ::-1], mirrored, mirrored_skin, -0.4, 0.1)
        self.assertLess(np.abs(((seen * across) + shift)[MIRROR] - points)[self.SEEN].max(), 0.3)

    def test_the_far_side_becomes_narrow_and_hides(self):
        face = portrait_of(drawn_face())
        _, points, _ = turned_heads.turned_head(face.picture, face.points, face.skin, 0.6, 0.0)

        def width(seen, name):
            return np.ptp(seen[SLICES[name]][:, 0])
        self.assertLess(width(points, "left_eye") / width(face.points, "left_eye"), 0.85)
        self.assertGreater(width(points, "right_eye"), width(points, "left_eye"))
        middle = points[SLICES["outer_lip"]].mean(0)[0]
        outline = points[SLICES["outline"]]
        self.assertLess(outline[:, 0].max() - middle, 0.75 * (middle - outline[:, 0].min()))
        hull = cv2.convexHull(np.float32(outline))
        for at in points[SLICES["outer_lip"]]:
            self.assertGreater(cv2.pointPolygonTest(hull, at.tolist(), False), 0.0)


@unittest.skipUnless(importlib.util.find_spec("torch"), "needs python3-torch")
class GoingOn(unittest.TestCase):
    def test_an_exported_net_goes_on_where_it_stood(self):
        import tempfile

        import torch

        import nets
        torch.manual_seed(3)
        pixels = torch.rand(6, 3, 64, 64) - 0.5
        trained = nets.ContourNet(5, 64, (8, 12), 8)
        for _ in range(3):
            trained.train()(2.0 * pixels)  # statistics of its own
        with tempfile.TemporaryDirectory() as folder:
            for rank in (None, 4):
                net = trained if rank is None else nets.factorised(copy.deepcopy(trained), rank)
                file = Path(folder) / "net.onnx"
                nets.export(net, 64, file)
                again = nets.started_from(nets.ContourNet(5, 64, (8, 12), 8), file, pixels)
                with torch.no_grad():
                    np.testing.assert_allclose(again.eval()(pixels), net.eval()(pixels), atol=1e-5)
                    np.testing.assert_allclose(again.train()(pixels), net.eval()(pixels), atol=2e-3)
            with self.assertRaisesRegex(SystemExit, "has other layers"):
                nets.started_from(nets.ContourNet(6, 64, (8, 12), 8), file, pixels)


class Packages(unittest.TestCase):
    def test_what_is_missing_is_named(self):
        with unittest.mock.patch("importlib.util.find_spec", return_value=None):
            with self.assertRaisesRegex(SystemExit, "apt-get install python3-torch"):
                trainer_packages.require("torch")


class Scenes(unittest.TestCase):
    def test_faces_are_answered_where_they_are(self):
        centre, size = np.array([83.0, 61.0]), 40.0
        marks = np.array([centre, centre + [-8.0, -5.0], centre + [8.0, -5.0]])
        score, values, counts = detector_scenes.answer_for([(marks, size)])
        self.assertEqual(score[7, 10], 1.0)
        self.assertEqual(counts.sum(), 9.0)
        here = (np.array([10, 7]) + 0.5) * detector_scenes.CELL
        np.testing.assert_allclose(here + values[:2, 7, 10] * detector_scenes.CELL, centre, atol=1e-4)
        np.testing.assert_allclose(here + values[3:5, 7, 10] * size, marks[1], atol=1e-4)

    def test_backgrounds_of_every_kind_can_be_drawn(self):
        rng = np.random.default_rng(1)
        face = detector_scenes.Face(portrait_of(drawn_face()))
        for _ in range(60):
            picture = detector_scenes.background(rng, [face])
            self.assertEqual((picture.shape, picture.dtype), ((160, 160, 3), np.uint8))


if __name__ == "__main__":
    unittest.main()
