#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Buildings of Open-RMF's traffic editor become anchors and lanes."""

import copy
import csv
import json
import os
import random
import subprocess
import tempfile
import unittest
from pathlib import Path

import yaml

from exports_test import CLI, run

BUILDING = {
    "coordinate_system": "reference_image",
    "levels": {
        "L1": {
            "drawing": {"filename": "plan.png"},
            "features": [{"id": "{a}", "name": "corner", "x": 10.5, "y": 20.0}, {"id": "{b}", "name": "", "x": 90, "y": 60},
                         {"id": "{c}", "name": "", "x": 50, "y": 50}],
            "layers": {"scan": {"filename": "scan.png", "transform": {"scale": 0.05, "yaw": -1.2},
                                "features": [{"id": "{x}", "name": "", "x": 5, "y": 6},
                                             {"id": "{y}", "name": "door", "x": 30, "y": 8.25}]},
                       "other": {"filename": "other.png", "features": [{"id": "{z}", "name": "", "x": 1, "y": 1}]}},
            "constraints": [{"ids": ["{a}", "{x}"]}, {"ids": ["{y}", "{b}"]}, {"ids": ["{c}", "{z}"]},
                            {"ids": ["{a}", "{gone}"]}, {"ids": ["{a}", "{x}"]}],
            "vertices": [[10, 20, 0, ""], [40, 20, 0, "dock", {"is_charger": [4, True]}], [40, 70, 0, ""]],
            "lanes": [[0, 1, {"bidirectional": [4, True]}], [1, 2, {}], [1, 99, {}]],
            "walls": [[0, 1, {}]],
        },
    },
}


def pgm(width, height):
    return b"P5\n%d %d\n255\n" % (width, height) + b"\xfe" * (width * height)


@unittest.skipUnless(os.path.exists(CLI), "the program is not there")
class RmfImportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, size, resolution, origin in (("plan", (100, 80), 0.1, [0, -8.0, 0]), ("scan", (40, 30), 0.05, [2, 3, 0])):
            (self.folder / f"{name}.pgm").write_bytes(pgm(*size))
            (self.folder / f"{name}.yaml").write_text(
                f"image: {name}.pgm\nresolution: {resolution}\norigin: {origin}\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        self.maps = ["--blueprint", self.folder / "plan.yaml", "--slam", self.folder / "scan.yaml"]
        self.out = self.folder / "anchors.csv"

    def building(self, document):
        path = self.folder / "site.building.yaml"
        path.write_text(document if isinstance(document, str) else yaml.safe_dump(document, sort_keys=False))
        return path

    def test_constraints_become_anchors(self):
        run("convert", "rmf", self.building(BUILDING), *self.maps, "--layer", "scan", "-o", self.out)
        rows = list(csv.DictReader(self.out.read_text().splitlines()))
        places = [[float(row[key]) for key in ("blueprint_x", "blueprint_y", "slam_x", "slam_y")] for row in rows]
        # Pixel rows grow down from the top: y = origin + (height - row) * resolution.
        expected = [[1.05, -8.0 + (80 - 20) * 0.1, 2 + 5 * 0.05, 3 + (30 - 6) * 0.05],
                    [9.0, -8.0 + (80 - 60) * 0.1, 2 + 30 * 0.05, 3 + (30 - 8.25) * 0.05]]
        for place, wanted in zip(places, expected, strict=True):
            for a, b in zip(place, wanted):
                self.assertAlmostEqual(a, b, places=9)
        self.assertEqual([row["name"] for row in rows], ["corner", "door"])

    def test_lanes(self):
        out = self.folder / "lanes.geojson"
        run("convert", "rmf-lanes", self.building(BUILDING), "--blueprint", self.folder / "plan.yaml", "-o", out)
        features = json.loads(out.read_text())["features"]
        kinds = [feature["geometry"]["type"] for feature in features]
        self.assertEqual(kinds, ["LineString", "LineString", "Point"])
        self.assertEqual(features[2]["properties"]["name"], "dock")
        for found, wanted in zip(features[0]["geometry"]["coordinates"], [[1.0, -2.0], [4.0, -2.0]]):
            for a, b in zip(found, wanted):
                self.assertAlmostEqual(a, b, places=9)

    def test_what_does_not_fit_is_named(self):
        building = self.building(BUILDING)
        self.assertIn("'other', 'scan'", run("convert", "rmf", building, *self.maps, "-o", self.out, fails=True))
        self.assertIn("'L1'", run("convert", "rmf", building, *self.maps, "--level", "L2", "-o", self.out, fails=True))
        lying = copy.deepcopy(BUILDING)
        lying["levels"]["L1"]["features"][0]["x"] = 2000
        self.assertIn("outside its picture", run("convert", "rmf", self.building(lying), *self.maps, "--layer", "scan",
                                                 "-o", self.out, fails=True))
        for change in ({"features": 3}, {"features": [3]}, {"features": [{"id": "{a}", "x": "nan", "y": 1}]},
                       {"features": BUILDING["levels"]["L1"]["features"] * 2}, {"constraints": [{"ids": ["{a}"]}]},
                       {"layers": [1]}, {"layers": {"scan": 3}}, {"constraints": 7}, {"constraints": []},
                       {"drawing": [3]}):
            bad = copy.deepcopy(BUILDING)
            bad["levels"]["L1"].update(change)
            message = run("convert", "rmf", self.building(bad), *self.maps, "--layer", "scan", "-o", self.out, fails=True)
            self.assertIn("site.building.yaml", message)
        for text in ("", "levels: 3", "levels: {L1: 3}", "levels: [", "a: &a [*a]", "levels: &l {L1: *l}", "[" * 20000,
                     "levels:\n  L1: {lanes: [[-1, 2]]}", "\x00\x01", "levels: {L1: {vertices: [[1]]}}",
                     "f: &f [{id: a, x: 1, y: 2}]\nlevels: {L1: {features: *f, layers: {scan: {features: *f}}}}",
                     "levels: {L1: {lanes: " + "[" * 60 + "]" * 60 + "}}"):
            self.assertIn("site.building.yaml", run("convert", "rmf", self.building(text), *self.maps, "--layer", "scan",
                                                    "-o", self.out, fails=True))

    def test_truncated_files(self):
        text = yaml.safe_dump(BUILDING)
        chance = random.Random(8)
        for _ in range(40):
            path = self.folder / "cut.building.yaml"
            path.write_text(text[:chance.randrange(len(text))])
            done = subprocess.run([CLI, "convert", "rmf", str(path), *map(str, self.maps), "--layer", "scan", "-o",
                                   str(self.out)], capture_output=True, text=True)
            self.assertIn(done.returncode, (0, 1), done.stderr)


if __name__ == "__main__":
    unittest.main()
