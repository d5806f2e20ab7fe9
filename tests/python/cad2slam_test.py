#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The projector in Python: what it computes."""

import math
import unittest

import numpy as np

import cad2slam
from cad2slam import Status
from projector_files import corridor, file_of, content_of, lattice_places, random_poses


def spline(t: float) -> float:
    d = abs(t)
    return 0.75 - d * d if d < 0.5 else 0.5 * (1.5 - d)**2 if d < 1.5 else 0.0


def by_definition(arrays, values, pose):
    """The forward function as docs/projector-file.md defines it, node by node."""
    cell, heading = float(values["cell_size_m"]), float(values["lattice_heading_rad"])
    dx, dy = pose[0] - float(values["lattice_x_m"]), pose[1] - float(values["lattice_y_m"])
    column = (math.cos(heading) * dx + math.sin(heading) * dy) / cell
    row = (-math.sin(heading) * dx + math.cos(heading) * dy) / cell
    total, place, linear = 0.0, np.zeros(2), np.zeros((2, 2))
    for tile, center, slam, stretch in zip(arrays["node_tile"], arrays["node_blueprint"], arrays["node_slam"],
                                           arrays["node_stretch"]):
        if values["weights"] == "smooth":
            weight = spline(column - tile[0] - 0.5) * spline(row - tile[1] - 0.5)
        else:
            distance = math.dist(pose[:2], center)
            own = math.floor(column) == tile[0] and math.floor(row) == tile[1]
            weight = 1.0 / (distance + 1e-3) if distance < float(values["radius_m"]) or own else 0.0
        c, s = math.cos(slam[2]), math.sin(slam[2])
        node = float(values["scale"]) * np.array([[c, -s], [s, c]]) @ np.diag(np.exp(stretch))
        total += weight
        place += weight * (slam[:2] + node @ (pose[:2] - center))
        linear += weight * node
    direction = linear @ [math.cos(pose[2]), math.sin(pose[2])]
    return np.array([*(place / total), math.atan2(direction[1], direction[0])])


def difference(a, b):
    off = np.abs(np.asarray(a) - b)
    off[..., 2] = np.abs(np.remainder(off[..., 2] + np.pi, 2.0 * np.pi) - np.pi)
    return np.nanmax(off)


def assert_same_to_rounding(a, b):
    """numpy works on several values at once and rounds those left over at the end of an array a little differently."""
    np.testing.assert_allclose(a, b, rtol=0.0, atol=1e-12)


class FunctionTest(unittest.TestCase):
    VARIANTS = ({"weights": "smooth"}, {"weights": "paper"}, {"model": "rigid", "scale": "1.3"},
                {"weights": "paper", "radius_m": "9"}, {"weights": "paper", "radius_m": "0.001"})

    def test_agrees_with_the_definition(self):
        for changes in self.VARIANTS:
            with self.subTest(**changes):
                arrays, values = corridor(12, **changes)
                poses = random_poses(arrays, values, 200)
                found = cad2slam.Projector(values, arrays).slam_from_blueprint(poses)
                expected = np.array([by_definition(arrays, values, pose) for pose in poses])
                answered = found.status != Status.FOLDED  # the paper's weights fold at their jumps
                self.assertGreater(answered.sum(), 150)
                self.assertTrue((found.status[answered] == Status.INSIDE).all())
                self.assertLess(difference(found.poses[answered], expected[answered]), 1e-12)

    def test_there_and_back_is_the_start(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        poses = random_poses(arrays, values, 20000)
        there = projector.slam_from_blueprint(poses)
        back = projector.blueprint_from_slam(there.poses)
        self.assertTrue(there.ok.all() and (back.status == Status.INSIDE).all())
        self.assertLess(difference(back.poses, poses), 1e-8)

    def test_corners_and_borders_come_back(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        cells = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 2.0], [3.0, 2.5], [0.0, 23.0]])
        poses = np.column_stack([lattice_places(values, cells + 1e-12), np.zeros(len(cells))])
        there = projector.slam_from_blueprint(poses, "rigid")
        back = projector.blueprint_from_slam(there.poses, "rigid")
        self.assertTrue(back.ok.all())
        self.assertLess(difference(back.poses, poses), 1e-8)

    def test_any_shape(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        poses = random_poses(arrays, values, 12)
        flat = projector.slam_from_blueprint(poses)
        square = projector.slam_from_blueprint(poses.reshape(3, 4, 3))
        single = projector.slam_from_blueprint(poses[5].tolist())
        np.testing.assert_array_equal(square.poses.reshape(12, 3), flat.poses)
        assert_same_to_rounding(single.poses, flat.poses[5])
        self.assertEqual(single.status, Status.INSIDE)
        places = projector.slam_from_blueprint(poses[:, :2])
        assert_same_to_rounding(places.poses[:, :2], flat.poses[:, :2])
        self.assertEqual(projector.slam_from_blueprint(np.zeros((0, 3))).poses.shape, (0, 3))
        for wrong in (3.0, [1.0], np.zeros((2, 4))):
            self.assertRaises(ValueError, projector.slam_from_blueprint, wrong)
        self.assertRaises(ValueError, projector.slam_from_blueprint, poses, "clamp")

    def test_chunks_do_not_show(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        poses = random_poses(arrays, values, 40000)
        poses[17::1000] = np.nan
        whole = projector.slam_from_blueprint(poses)
        part = projector.slam_from_blueprint(poses[20000:20100])
        assert_same_to_rounding(whole.poses[20000:20100], part.poses)
        np.testing.assert_array_equal(whole.status == Status.INVALID, np.isnan(poses[:, 0]))

    def test_outside_follows_the_policy(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        court = [*lattice_places(values, np.array([12.3, 12.0])), 0.3]
        for direction in (projector.slam_from_blueprint, projector.blueprint_from_slam):
            place = court if direction == projector.slam_from_blueprint else projector.slam_from_blueprint(
                court, "rigid").poses
            self.assertEqual(direction(place).status, Status.OUTSIDE)
            self.assertTrue(np.isnan(direction(place).poses).all())
            self.assertEqual(direction(place, "rigid").status, Status.EXTRAPOLATED)
            self.assertEqual(direction([np.nan, 0.0, 0.0]).status, Status.INVALID)
            self.assertEqual(direction([0.0, 0.0, np.inf]).status, Status.INVALID)
            for far in (1e6, 1e12, 1e300):
                self.assertEqual(direction([far, -far, 0.0]).status, Status.OUTSIDE)
                direction([far, -far, 0.0], "rigid")
        says_rigid = cad2slam.Projector({**values, "outside": "rigid"}, arrays)
        self.assertEqual(says_rigid.slam_from_blueprint(court).status, Status.EXTRAPOLATED)

    def test_extrapolation_comes_back(self):
        arrays, values = corridor()
        projector = cad2slam.Projector(values, arrays)
        random = np.random.default_rng(3)
        poses = np.column_stack([lattice_places(values, random.uniform(-3.0, 27.0, (2000, 2))), random.random(2000)])
        there = projector.slam_from_blueprint(poses, "rigid")
        back = projector.blueprint_from_slam(there.poses, "rigid")
        answered = there.ok & back.ok
        self.assertGreater(answered.sum(), 1500)
        # Beyond the mesh two nearest places may carry to the same target; at the mesh there is one.
        inside = there.status == Status.INSIDE
        self.assertLess(difference(back.poses[inside], poses[inside]), 1e-8)
        again = projector.slam_from_blueprint(back.poses[answered], "rigid")
        self.assertLess(difference(again.poses, there.poses[answered]), 1e-8)

    def test_jacobian_is_the_derivative(self):
        arrays, values = corridor()
        for weights in ("smooth", "paper"):
            projector = cad2slam.Projector({**values, "weights": weights, "radius_m": "50"}, arrays)
            points = random_poses(arrays, values, 50)[:, :2]
            jacobian = projector.jacobian(points)
            for axis in range(2):
                step = 1e-6 * np.eye(2)[axis]
                ahead, behind = (projector.slam_from_blueprint(points + side * step, "rigid").poses for side in (1, -1))
                slope = (ahead - behind)[:, :2] / 2e-6
                smooth = np.isfinite(slope).all(axis=1)  # the paper's weights have kinks at the nodes
                self.assertGreater(smooth.sum(), 40)
                np.testing.assert_allclose(slope[smooth], jacobian[smooth, :, axis], atol=1e-5)

    def test_folds_are_named(self):
        arrays, values = row_of_tiles(5)
        arrays["node_slam"][2, 0] = 5.5
        projector = cad2slam.Projector(values, arrays)
        x = np.arange(0.01, 5.0, 0.01)
        poses = np.column_stack([x, np.full_like(x, 0.5), np.zeros_like(x)])
        there = projector.slam_from_blueprint(poses)
        self.assertGreater((there.status == Status.FOLDED).sum(), 10)
        back = projector.blueprint_from_slam(there.poses)
        right = np.abs(back.poses[:, 0] - x) < 1e-6
        self.assertTrue((right | ~back.ok).all())  # the start or no answer, never a wrong place

    def test_overlaps_are_named(self):
        tile = np.array([(room * 50 + k % 4, k // 4) for room in range(2) for k in range(16)], np.int32)
        arrays, values = plain(tile)
        arrays["node_slam"][16:, 0] -= 49.7
        projector = cad2slam.Projector(values, arrays)
        there = projector.slam_from_blueprint([2.0, 2.0, 0.0])
        self.assertEqual(there.status, Status.INSIDE)
        self.assertEqual(projector.blueprint_from_slam(there.poses).status, Status.FOLDED)
        self.assertEqual(projector.blueprint_from_slam([0.1, 2.0, 0.0]).status, Status.INSIDE)

    def test_far_apart_tiles_cost_nothing(self):
        tile = np.array([(0, 0), (10**9 - 1, -10**9), (-10**9, 5)], np.int32)
        projector = cad2slam.Projector(*plain(tile)[::-1])
        found = projector.slam_from_blueprint([[0.5, 0.5, 0.0], [1e9 - 0.5, -1e9 + 0.5, 0.0], [1e9 + 9.0, 0.0, 0.0],
                                               [5.0, 5.0, 0.0]])
        self.assertEqual(found.status.tolist(), [Status.INSIDE, Status.INSIDE, Status.OUTSIDE, Status.OUTSIDE])


def plain(tile: np.ndarray):
    """Tiles of 1 m that stay where they are."""
    values = corridor(4, cell_size_m="1", lattice_x_m="0", lattice_y_m="0", lattice_heading_rad="0")[1]
    center = tile + 0.5
    count = len(tile)
    arrays = {"node_blueprint": center, "node_slam": np.column_stack([center, np.zeros(count)]),
              "node_stretch": np.zeros((count, 2)), "node_tile": tile, "edges": np.zeros((0, 2), np.uint32),
              "anchors": np.zeros((0, 4)), "check_poses": np.zeros((0, 6))}
    return arrays, values


def row_of_tiles(count: int):
    return plain(np.array([(k, 0) for k in range(count)], np.int32))


class CheckPoseTest(unittest.TestCase):
    def test_a_projector_must_reproduce_its_own_check_poses(self):
        arrays, values = corridor()
        poses = random_poses(arrays, values, 4)
        there = cad2slam.Projector(values, arrays).slam_from_blueprint(poses).poses
        for off, accepted in ((0.0, True), (1e-7, True), (1e-5, False)):
            for column in range(3):
                wrong = there.copy()
                wrong[2, column] += off
                content = file_of(*content_of({**arrays, "check_poses": np.hstack([poses, wrong])}, values))
                if accepted:
                    cad2slam.Projector(*cad2slam.parse(content, "x"))
                else:
                    with self.assertRaisesRegex(cad2slam.ProjectorError, "check poses"):
                        cad2slam.Projector(*cad2slam.parse(content, "x"))


if __name__ == "__main__":
    unittest.main()
