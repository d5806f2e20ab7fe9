#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The guides do what they say: their commands and their Python run, in order, on files of the sample office."""

import csv
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import yaml

import c2s_rmf
import cad2slam
from docs_test import CLI, DOCS, blocks
from exports_test import OFFICE, collection

SITE = DOCS.parent / "sample_maps" / "office"
X, Y = 12.5, 7.25  # a place on the mesh that the guides name


def pixel(frame: dict, x: float, y: float, height: int) -> tuple[float, float]:
    """Column and row, counted from the top left corner, of a place in metres."""
    column, row = (np.array([x, y]) - frame["origin"][:2]) / frame["resolution"]
    return float(column), float(height - row)


@unittest.skipUnless(os.path.exists(CLI) and os.path.exists(OFFICE), "the program or the sample is not there")
class GuidesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("office.c2s", "floor_2.c2s", "robot_a.c2s", "robot_b.c2s"):
            shutil.copy(OFFICE, self.folder / name)
        shutil.copy(SITE / "blueprint.yaml", self.folder)
        for source, target in (("blueprint", "plan"), ("slam_1", "scan")):
            shutil.copy(SITE / f"{source}.png", self.folder)
            shutil.copy(SITE / f"{source}.yaml", self.folder / f"{target}.yaml")
        self.write("zones.geojson", ("Polygon", [self.square(0.6)], {"speed_percent": 30}))
        self.write("blocked.geojson", ("Polygon", [self.square(0.4)], {}))
        self.write("places.geojson", ("Point", [X, Y], {"name": "dock", "heading_rad": 0.5}))
        self.write("lanes.geojson", ("LineString", [[X, Y], [X - 0.5, Y - 0.5]], {"name": "lane"}))
        (self.folder / "poses.csv").write_text(f"x,y,theta\n{X},{Y},0.5\n")
        (self.folder / "office.building.yaml").write_text(yaml.safe_dump(self.building()))

    @staticmethod
    def square(half):
        return [[X + u * half, Y + v * half] for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]

    def write(self, name, *features):
        (self.folder / name).write_text(json.dumps(collection(*features)))

    def building(self):
        """The anchors of the sample, as the traffic editor would have them."""
        frames = [(yaml.safe_load((SITE / f"{name}.yaml").read_text()), self.height(SITE / f"{name}.png"))
                  for name in ("blueprint", "slam_1")]
        marks, seen, pairs = [], [], []
        for row in csv.DictReader((SITE / "anchors_1.csv").read_text().splitlines()):
            for side, (frame, height), found in (("blueprint", frames[0], marks), ("slam", frames[1], seen)):
                column, line = pixel(frame, float(row[f"{side}_x"]), float(row[f"{side}_y"]), height)
                found.append({"id": f"{side} {row['id']}", "name": "", "x": column, "y": line})
            pairs.append({"ids": [f"blueprint {row['id']}", f"slam {row['id']}"]})
        vertices = [[*pixel(frames[0][0], x, y, frames[0][1]), 0, ""] for x, y in ((X, Y), (X - 0.5, Y - 0.5))]
        return {"levels": {"L1": {"drawing": {"filename": "plan.png"}, "features": marks, "constraints": pairs,
                                  "layers": {"scan": {"filename": "scan.png", "features": seen}},
                                  "vertices": vertices, "lanes": [[0, 1, {}]]}}}

    @staticmethod
    def height(png: Path) -> int:
        return int.from_bytes(png.read_bytes()[20:24], "big")

    def run_commands(self, guide):
        path = f"{Path(CLI).parent}:{os.environ['PATH']}"
        commands = [line for block in blocks(guide, "sh") for line in block.splitlines() if line.strip()]
        self.assertGreater(len(commands), 1)
        for command in commands:
            done = subprocess.run(["bash", "-o", "pipefail", "-c", command], capture_output=True, text=True,
                                  cwd=self.folder, env={**os.environ, "PATH": path})
            self.assertEqual(done.returncode, 0, f"{guide}: {command}\n{done.stdout}{done.stderr}")
            for written in re.findall(r"(?:-o|>) (\S+)", command):
                self.assertTrue((self.folder / written).exists(), command)

    def run_code(self, guide, **names):
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        code = blocks(guide, "python")
        self.assertTrue(code)
        for block in code:
            exec(block, names)
        return names

    def test_nav2(self):
        self.run_commands("guide-nav2.md")
        self.assertEqual(yaml.safe_load((self.folder / "speed.yaml").read_text())["mode"], "scale")
        back = (self.folder / "there_and_back.csv").read_text().splitlines()[1].split(",")
        np.testing.assert_allclose([float(field) for field in back[:3]], [X, Y, 0.5], atol=1e-6)
        names = self.run_code("guide-nav2.md", cad2slam=cad2slam)
        self.assertTrue(names["goal"].ok)
        request, answer = re.findall(r"^    ({.*})$", (DOCS / "guide-nav2.md").read_text(), re.MULTILINE)
        done = subprocess.run([CLI, "serve", "office.c2s"], input=request + "\n", capture_output=True, text=True,
                              cwd=self.folder, check=True)
        self.assertEqual(json.loads(done.stdout).keys(), json.loads(answer.replace("...", "0")).keys())

    def test_open_rmf(self):
        before = cad2slam.load(OFFICE, native=False).slam_from_blueprint([X, Y, 0.0]).poses
        self.run_commands("guide-open-rmf.md")
        # The sample's anchors have gone through pixels and back: the projector solved from them is the same.
        after = cad2slam.load(self.folder / "office.c2s", native=False).slam_from_blueprint([X, Y, 0.0]).poses
        np.testing.assert_allclose(after, before, atol=1e-5)
        self.assertIn("L1", yaml.safe_load((self.folder / "transforms.yaml").read_text())["reference_coordinates"])
        told = []

        class RobotAPI:
            def __init__(self, config):
                pass

            def navigate(self, *words):
                return told.append(words) or True

        names = self.run_code("guide-open-rmf.md", c2s_rmf=c2s_rmf, RobotAPI=RobotAPI, config=None, config_yaml={})
        self.assertTrue(names["api"].navigate("tiny", [X, Y, 0.0], "L1"))
        np.testing.assert_allclose(told[0][1], after, atol=1e-9)
        self.assertEqual(told[0][2], "map_2")

    def test_vda5050(self):
        self.run_commands("guide-vda5050.md")
        for x, expected in ((X, 0), (X + 500.0, 1)):
            rejected = []
            order = {"nodes": [{"nodePosition": {"x": x, "y": Y}}, {"nodePosition": {"x": X, "y": Y, "theta": 1.0}}]}
            self.run_code("guide-vda5050.md", cad2slam=cad2slam, order=order,
                          reject=lambda order, why: rejected.append(why))
            self.assertEqual(len(rejected), expected)


if __name__ == "__main__":
    unittest.main()
