#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The class for fleet adapters of Open-RMF, around an API as the adapter template has it."""

import logging
import unittest
from types import SimpleNamespace

import numpy as np

import c2s_rmf
import cad2slam
from projector_files import corridor, random_poses


class RobotAPI:
    """Remembers what it was told."""

    def __init__(self):
        self.goals = []
        self.at = ("map_2", [0.0, 0.0, 0.0])

    def navigate(self, robot_name, pose, map_name, speed_limit=0.0):
        self.goals.append((robot_name, list(pose), map_name, speed_limit))
        return True

    def position(self, robot_name):
        return self.at[1]

    def get_data(self, robot_name):
        return SimpleNamespace(map=self.at[0], position=self.at[1], battery_soc=0.5)

    def stop(self, robot_name):
        return f"{robot_name} stopped"


class RmfTest(unittest.TestCase):
    def setUp(self):
        logging.disable(logging.CRITICAL)
        self.addCleanup(logging.disable, logging.NOTSET)
        arrays, values = corridor(outside="rigid")
        self.projector = cad2slam.Projector(values, arrays)
        self.robots = RobotAPI()
        self.api = c2s_rmf.ProjectedRobotAPI(self.robots, {"L1": self.projector}, {"L1": "map_2"})
        self.poses = random_poses(arrays, values, 20)

    def test_commands_go_to_the_robots_map(self):
        for pose in self.poses:
            self.assertTrue(self.api.navigate("tiny", pose, "L1", 0.7))
            name, goal, map_name, speed = self.robots.goals[-1]
            np.testing.assert_allclose(goal, self.projector.slam_from_blueprint(pose).poses)
            self.assertEqual((name, map_name, speed), ("tiny", "map_2", 0.7))

    def test_poses_come_back_to_rmf(self):
        for pose in self.poses:
            self.api.navigate("tiny", pose, "L1")
            self.robots.at = ("map_2", self.robots.goals[-1][1])
            data = self.api.get_data("tiny")
            np.testing.assert_allclose(data.position, pose, atol=1e-8)
            self.assertEqual((data.map, data.battery_soc), ("L1", 0.5))
            self.assertEqual(self.robots.get_data("tiny").map, "map_2")
            np.testing.assert_allclose(self.api.position("tiny"), pose, atol=1e-8)

    def test_fails_closed(self):
        beyond = [500.0, 500.0, 0.0]  # where the file itself would go on rigidly
        self.assertFalse(self.api.navigate("tiny", beyond, "L1"))
        self.assertFalse(self.api.navigate("tiny", self.poses[0], "L9"))
        self.assertFalse(self.api.navigate("tiny", [float("nan"), 0.0, 0.0], "L1"))
        self.assertEqual(self.robots.goals, [])
        self.robots.at = ("map_2", beyond)
        self.assertIsNone(self.api.get_data("tiny"))
        self.assertIsNone(self.api.position("tiny"))
        self.robots.at = ("map_3", [0.0, 0.0, 0.0])
        self.assertIsNone(self.api.get_data("tiny"))

    def test_localising_and_maps(self):
        told = []
        self.robots.localise = lambda *words: told.append(words) or True
        self.assertTrue(self.api.localise("tiny", self.poses[0], "L1"))
        np.testing.assert_allclose(told[0][1], self.projector.slam_from_blueprint(self.poses[0]).poses)
        self.assertEqual((told[0][0], told[0][2]), ("tiny", "map_2"))
        self.assertFalse(self.api.localise("tiny", [500.0, 500.0, 0.0], "L1"))
        self.assertEqual(len(told), 1)
        self.assertRaises(AttributeError, self.api.localize, "tiny", self.poses[0], "L1")  # as with the API itself
        self.robots.map = lambda robot_name: self.robots.at[0]
        self.assertEqual(self.api.map("tiny"), "L1")
        self.robots.at = ("map_3", self.robots.at[1])
        self.assertIsNone(self.api.map("tiny"))
        self.assertIsNone(self.api.position("tiny"))

    def test_no_level_is_guessed(self):
        api = c2s_rmf.ProjectedRobotAPI(self.robots, {"L1": self.projector, "L2": self.projector}, {"L2": "map_2"})
        self.robots.at = ("map_2", self.projector.slam_from_blueprint(self.poses[0]).poses)
        self.assertIsNone(api.position("tiny"))
        self.assertEqual(api.get_data("tiny").map, "L2")
        np.testing.assert_allclose(api.position("tiny"), self.poses[0], atol=1e-8)

    def test_all_robots_at_once(self):
        inside = self.projector.slam_from_blueprint(self.poses[0]).poses
        self.robots.get_data = lambda robot_name: [SimpleNamespace(robot_name="a", map="map_2", position=inside),
                                                   SimpleNamespace(robot_name="b", map="map_9", position=inside)]
        found = self.api.get_data()
        self.assertEqual([(item.robot_name, item.map) for item in found], [("a", "L1")])
        np.testing.assert_allclose(found[0].position, self.poses[0], atol=1e-8)

    def test_everything_else_is_the_apis(self):
        self.assertEqual(self.api.stop("tiny"), "tiny stopped")
        self.assertRaises(AttributeError, lambda: self.api.no_such_call)
        self.assertRaises(ValueError, c2s_rmf.Levels, {"L1": self.projector, "L2": self.projector}, {"L2": "L1"})


if __name__ == "__main__":
    unittest.main()
