#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The specification of the projector file does what it says: its code runs, its bytes are those of the example."""

import os
import re
import subprocess
import unittest
from pathlib import Path

import numpy as np

import cad2slam

DOCS = Path(os.environ.get("CAD2SLAM_SOURCE", Path(__file__).resolve().parents[2])) / "docs"
CLI = os.environ.get("CAD2SLAM_CLI", "")


def blocks(name, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", (DOCS / name).read_text(), re.MULTILINE | re.DOTALL)


class SpecificationTest(unittest.TestCase):
    def test_code(self):
        code = blocks("projector-file.md", "python")
        self.assertEqual(len(code[0].splitlines()), 10)
        names = {}
        folder = os.getcwd()
        os.chdir(DOCS)
        self.addCleanup(os.chdir, folder)
        for block in code:
            exec(block, names)
        projector = cad2slam.load("example.c2s", native=False)
        for name, array in projector.arrays.items():
            np.testing.assert_array_equal(names["arrays"][name], array)
        for x, y, heading in np.random.default_rng(1).uniform([0.0, 0.0, -3.0], [2.0, 1.0, 3.0], (50, 3)):
            np.testing.assert_allclose(names["forward"](x, y, heading),
                                       projector.slam_from_blueprint([x, y, heading]).poses, atol=1e-12)

    def test_bytes(self):
        content = (DOCS / "example.c2s").read_bytes()
        rows = re.findall(r"^    ([0-9a-f]{8}): ([0-9a-f ]+?)(?:  .*)?$", (DOCS / "projector-file.md").read_text(), re.M)
        self.assertGreater(len(rows), 15)
        for place, digits in rows:
            shown = bytes.fromhex(digits.replace(" ", ""))
            self.assertEqual(content[int(place, 16):][:len(shown)], shown, place)

    @unittest.skipUnless(os.path.exists(CLI), "the program is not there")
    def test_the_program_reads_the_example(self):
        shown = subprocess.run([CLI, "info", str(DOCS / "example.c2s")], capture_output=True, text=True, check=True)
        self.assertIn("2 poses, all reproduced", shown.stdout)


if __name__ == "__main__":
    unittest.main()
