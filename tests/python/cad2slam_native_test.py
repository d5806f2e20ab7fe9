#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Python's own projector and the C library give the same: numbers to 1e-9, statuses exactly, the same refusals."""

import os
import random
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import cad2slam
from cad2slam_test import difference, plain
from projector_files import content_of, corridor, file_of, random_poses, seal

try:
    import cad2slam_native
except ImportError:
    cad2slam_native = None


@unittest.skipIf(cad2slam_native is None, "the C library is not there: set CAD2SLAM_LIBRARY")
class NativeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def both(self, arrays, values):
        path = self.folder / "file.c2s"
        path.write_bytes(file_of(*content_of(arrays, values)))
        return cad2slam.load(path, native=False), cad2slam.load(path, native=True)

    def compare(self, pure, native, poses, share_that_may_differ=0.0):
        for direction in ("slam_from_blueprint", "blueprint_from_slam"):
            for policy in (None, "error", "rigid"):
                mine = getattr(pure, direction)(poses, policy)
                theirs = getattr(native, direction)(poses, policy)
                self.assertLessEqual((mine.status != theirs.status).mean(), share_that_may_differ)
                both = mine.ok & theirs.ok
                far = both & (np.abs(theirs.poses[:, :2]).max(axis=1) > 1e6)
                if (both & ~far).any():
                    self.assertLess(difference(mine.poses[both & ~far], theirs.poses[both & ~far]), 1e-9)
                np.testing.assert_allclose(mine.poses[far], theirs.poses[far], rtol=1e-12)
        return mine.status

    def test_same_numbers_as_c(self):
        for changes in ({}, {"weights": "paper"}, {"model": "rigid", "scale": "1.7", "outside": "rigid"}):
            with self.subTest(**changes):
                arrays, values = corridor(**changes)
                pure, native = self.both(arrays, values)
                inside = random_poses(arrays, values, 1000)
                around = np.random.default_rng(2).uniform(-30.0, 30.0, (1000, 3))
                there = pure.slam_from_blueprint(inside).poses
                invalid = [[np.nan, 0.0, 0.0], [0.0, np.inf, 0.0], [1e7, 1e7, 0.0], [1e9, 0.0, 0.0]]
                self.compare(pure, native, np.vstack([inside, around, there, invalid]))

    def test_same_where_the_mesh_folds(self):
        tile = np.array([(c, r) for c in range(12) for r in range(6)], np.int32)
        arrays, values = plain(tile)
        arrays["node_slam"] += np.random.default_rng(6).normal(0.0, 0.6, arrays["node_slam"].shape)
        pure, native = self.both(arrays, values)
        # Rounding decides where Newton's method ends in a mesh as crumpled as this.
        poses = np.random.default_rng(7).uniform(-2.0, 14.0, (2000, 3))
        status = self.compare(pure, native, poses, share_that_may_differ=0.005)
        self.assertGreater((status == cad2slam.Status.FOLDED).sum(), 0)

    def test_same_on_a_bundled_sample(self):
        path = os.environ.get("CAD2SLAM_OFFICE_PROJECTOR", "")
        if not os.path.exists(path):
            self.skipTest("no projector of the office sample")
        pure, native = cad2slam.load(path, native=False), cad2slam.load(path, native=True)
        poses = np.random.default_rng(8).uniform([-10.0, -10.0, -4.0], [80.0, 60.0, 4.0], (5000, 3))
        self.compare(pure, native, poses)
        self.assertEqual(pure.metadata, native.metadata)

    def test_same_refusals(self):
        """What one reader refuses the other refuses; nothing else is accepted by either."""
        arrays, values = corridor(6)
        header, data = content_of(arrays, values)
        chance = random.Random(9)
        accepted = 0
        for _ in range(int(os.environ.get("CAD2SLAM_FUZZ_ROUNDS", "100"))):
            changed = {name: dict(entry) for name, entry in header.items()}
            raw = bytearray(data)
            kind = chance.randrange(3)
            name = chance.choice([name for name in changed if name != "__metadata__"])
            if kind == 0:
                place = chance.randrange(len(raw))
                raw[place] = chance.choice((0, 255, 0x7F, raw[place] ^ 64))
            elif kind == 1:
                key = chance.choice(("dtype", "shape", "data_offsets"))
                changed[name][key] = chance.choice(("F32", "I64", [3, 2], [0, 0], [2**63, 2], [-1, 2], 7, [1.5, 2], True))
            else:
                key = chance.choice(list(changed["__metadata__"]))
                changed["__metadata__"][key] = chance.choice(
                    ("", "0", "-0", "+1", "1e5", "inf", "nan", "0x10", "1,5", " 1", "rigid", "2.0", "1", "\u2603"))
            path = self.folder / "file.c2s"
            path.write_bytes(file_of(seal(changed, bytes(raw)), bytes(raw)))
            verdicts = []
            for native in (False, True):
                try:
                    cad2slam.load(path, native=native)
                    verdicts.append("accepted")
                except cad2slam.ProjectorError:
                    verdicts.append("refused")
            needless = kind == 2 and verdicts == ["accepted", "refused"]  # C also reads what only people look at
            self.assertTrue(verdicts[0] == verdicts[1] or needless, changed)
            accepted += verdicts == ["accepted", "accepted"]
        self.assertGreater(accepted, 10)

    def test_errors(self):
        self.assertRaises(FileNotFoundError, cad2slam.load, "no such file.c2s", native=True)
        self.assertRaises(OSError, cad2slam.load, self.folder, native=True)
        (self.folder / "bad.c2s").write_bytes(b"x" * 100)
        with self.assertRaisesRegex(cad2slam.ProjectorError, "bad.c2s"):
            cad2slam.load(self.folder / "bad.c2s")
        _, native = self.both(*corridor(6))
        self.assertRaises(ValueError, native.slam_from_blueprint, [[1.0]])
        self.assertRaises(ValueError, native.slam_from_blueprint, [1.0, 2.0], "clamp")
        self.assertRaises(AttributeError, lambda: native.nonsense)
        self.assertEqual(native.slam_from_blueprint(np.zeros((0, 2))).poses.shape, (0, 3))

    def test_threads(self):
        arrays, values = corridor()
        pure, native = self.both(arrays, values)
        poses = random_poses(arrays, values, 20000)
        expected = native.slam_from_blueprint(poses).poses
        wrong = []
        threads = [threading.Thread(target=lambda: wrong.extend(
            [1] * (not np.array_equal(native.slam_from_blueprint(poses).poses, expected)))) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_does_without_the_library(self):
        path = self.folder / "file.c2s"
        path.write_bytes(file_of(*content_of(*corridor(6))))
        program = f"import cad2slam; print(type(cad2slam.load({str(path)!r})).__name__)"
        for library, expected in ((os.environ.get("CAD2SLAM_LIBRARY", "libcad2slam.so.0"), "NativeProjector"),
                                  ("no such library.so", "Projector"), ("libm.so.6", "Projector")):
            done = subprocess.run([sys.executable, "-c", program], env={**os.environ, "CAD2SLAM_LIBRARY": library},
                                  capture_output=True, text=True, check=True)
            self.assertEqual(done.stdout.strip(), expected)


if __name__ == "__main__":
    unittest.main()
