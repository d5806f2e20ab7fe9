#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The reader in Python: hostile files end in ProjectorError, never in a crash or a wrong answer."""

import copy
import os
import random
import tempfile
import unittest
from pathlib import Path

import numpy as np

import cad2slam
from projector_files import content_of, corridor, file_of, random_poses, seal

FUZZ_ROUNDS = int(os.environ.get("CAD2SLAM_FUZZ_ROUNDS", "1000"))


def open_bytes(content: bytes) -> cad2slam.Projector:
    return cad2slam.Projector(*cad2slam.parse(content, "file.c2s"), "file.c2s")


class ReadingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        arrays, values = corridor(6)
        poses = random_poses(arrays, values, 5)
        answers = cad2slam.Projector(values, arrays).slam_from_blueprint(poses).poses
        cls.arrays, cls.values = {**arrays, "check_poses": np.hstack([poses, answers])}, values
        cls.header, cls.data = content_of(cls.arrays, values)
        cls.good = file_of(cls.header, cls.data)
        cls.poses, cls.answers = poses, answers

    def refused(self, content: bytes, why: str) -> None:
        with self.assertRaisesRegex(cad2slam.ProjectorError, "^file.c2s: .*" + why):
            open_bytes(content)

    def test_reads_from_disk(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "good.c2s"
            path.write_bytes(self.good)
            projector = cad2slam.load(path, native=False)
            np.testing.assert_array_equal(projector.slam_from_blueprint(self.poses).poses, self.answers)
            self.assertEqual(projector.metadata["slam_name"], "slam")
            np.testing.assert_array_equal(projector.arrays["anchors"], [[1.0, 2.0, 3.0, 4.0]])
            self.assertRaises(OSError, cad2slam.load, folder, native=False)
        self.assertRaises(FileNotFoundError, cad2slam.load, "no such file.c2s", native=False)
        self.assertRaises(cad2slam.ProjectorError, cad2slam.load, "/dev/zero", native=False)

    def test_what_is_no_projector_costs_neither_time_nor_memory(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe = Path(folder) / "pipe.c2s"
            os.mkfifo(pipe)  # nobody writes to it: opening it would wait for ever
            self.assertRaises(cad2slam.ProjectorError, cad2slam.load, pipe, native=False)
            for start, why in ((b"#ROSBAG V2.0\n", "no projector file"), (self.good, "bytes too many")):
                large = Path(folder) / "large.c2s"
                large.write_bytes(start)
                os.truncate(large, 1 << 42)  # of holes; more than any memory
                with self.assertRaisesRegex(cad2slam.ProjectorError, "large.c2s: .*" + why):
                    cad2slam.load(large, native=False)

    def test_large_files_are_read_whole(self):
        header, data = content_of({**self.arrays, "anchors": np.ones((50000, 4))}, self.values)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "large.c2s"
            path.write_bytes(file_of(header, data))
            self.assertGreater(path.stat().st_size, 1 << 20)
            self.assertEqual(len(cad2slam.load(path, native=False).arrays["anchors"]), 50000)
            path.write_bytes(file_of(header, data)[:-1])
            self.assertRaisesRegex(cad2slam.ProjectorError, "1 bytes are missing", cad2slam.load, path, native=False)

    def test_layout(self):
        self.refused(b"", "only 0 bytes")
        self.refused(self.good[:7], "only 7 bytes")
        self.refused(self.good[:200], "cut off inside its header")
        self.refused(b"\xff" * 8 + self.good[8:], "too long")
        self.refused(self.good[:-1], "1 bytes are missing")
        self.refused(self.good + b"\0", "1 bytes too many")
        self.refused(file_of(self.header, self.data[:-8]), "8 bytes are missing")

    def test_damage_is_seen(self):
        for place in (len(self.good) - 1, len(self.good) // 2):
            changed = bytearray(self.good)
            changed[place] ^= 1
            self.refused(bytes(changed), "SHA-256")
        self.refused(self.good.replace(b'"smooth"', b'"paper" '), "header was changed")

    def test_json(self):
        def with_text(text: bytes) -> bytes:
            return len(text).to_bytes(8, "little") + text

        for text in (b"[]", b"null", b"3"):
            self.refused(with_text(text), "no JSON object")
        self.refused(with_text(b"{"), "not valid JSON")
        self.refused(with_text(b"{}\0"), "not valid JSON")
        self.refused(with_text(b'{"a": "\xff"}'), "not valid JSON")
        self.refused(with_text(b"[" * 500000), "not valid JSON")
        self.refused(with_text(b'{"__metadata__": {"a": "b", "a": "c"}}'), "twice")
        self.refused(with_text(b'{"__metadata__": {}, "__metadata__": {}}'), "twice")
        self.refused(with_text(b"{}"), "metadata")
        self.refused(with_text(b'{"__metadata__": {"format": 3}}'), "all texts")
        for number in (b"1.0", b"NaN", b"Infinity", b"1e3"):
            self.refused(with_text(b'{"a": {"dtype": "F64", "shape": [%s], "data_offsets": [0, 8]}}' % number), "whole")
        for number in (b"-1", b"true", b"18446744073709551616", b"null", b'"1"'):
            self.refused(with_text(b'{"a": {"dtype": "F64", "shape": [%s], "data_offsets": [0, 8]}}' % number), "shape")

    def test_entries(self):
        def resealed(change) -> bytes:
            header = copy.deepcopy(self.header)
            change(header)
            return file_of(seal(header, self.data), self.data)

        def put(name, **values):
            return lambda header: header[name].update(values)

        tile = self.header["node_tile"]
        self.assertTrue(open_bytes(resealed(lambda header: None)))
        self.refused(resealed(put("node_tile", dtype="F64")), "does not fit its shape")
        self.refused(resealed(put("node_tile", dtype="U32")), "not I32")
        self.refused(resealed(put("node_tile", dtype="X9")), "unknown type")
        self.refused(resealed(put("node_tile", shape=[tile["shape"][0] * 2])), "2 columns")
        self.refused(resealed(put("node_tile", shape=[2**40, 2**40])), "does not fit its shape")
        self.refused(resealed(put("node_tile", data_offsets=[0, 8])), "does not fit its shape")
        self.refused(resealed(put("node_tile", data_offsets=[8, 0])), "does not fit its shape")
        self.refused(resealed(put("node_tile", data_offsets=self.header["edges"]["data_offsets"])), "")
        self.refused(resealed(put("node_tile", extra=1)), "does not say")
        self.refused(resealed(lambda header: header.pop("anchors")), "gap|many|missing")

    def test_content(self):
        def changed(values=None, **arrays) -> bytes:
            return file_of(*content_of({**self.arrays, **arrays}, {**self.values, **(values or {})}))

        def spoilt(name, value, row=3):
            array = self.arrays[name].copy()
            array[row] = value
            return changed(**{name: array})

        for key, value, why in (("format", "x", "not a projector"), ("format", "", "not a projector"),
                                ("version", "2.0", "version"), ("version", "", "version"), ("model", "x", "model"),
                                ("weights", "x", "weights"), ("outside", "x", "outside"), ("scale", "0", "scale"),
                                ("scale", "nan", "scale"), ("scale", "1_0", "scale"), ("scale", " 1", "scale"),
                                ("cell_size_m", "-1", "cell size"), ("cell_size_m", "1e999", "cell_size_m"),
                                ("radius_m", "0", "radius"), ("radius_m", "501", "radius"),
                                ("lattice_x_m", "", "lattice_x_m"), ("cell_size_m", "5", "tile")):
            self.refused(changed({key: value}), why)
        self.assertTrue(open_bytes(changed({"version": "1.7", "new_key": "x"})))
        self.assertTrue(open_bytes(changed(new_array=np.zeros((2, 2)))))
        self.refused(spoilt("node_slam", np.nan), "finite")
        self.refused(spoilt("anchors", np.inf, 0), "finite")
        self.refused(spoilt("node_stretch", 40.0), "stretched")
        self.refused(spoilt("node_blueprint", 900.0), "its tile")
        self.refused(spoilt("node_tile", self.arrays["node_tile"][4]), "two nodes")
        self.refused(spoilt("node_tile", 2**31 - 1), "outside any building")
        self.refused(spoilt("edges", 10**6), "edge")
        self.refused(spoilt("check_poses", 7.0), "check poses")
        self.refused(changed(node_slam=self.arrays["node_slam"][1:]), "different lengths")
        none = {name: self.arrays[name][:0] for name in ("node_blueprint", "node_slam", "node_stretch", "node_tile")}
        self.refused(changed(**none, edges=self.arrays["edges"][:0]), "no node")

    def test_mutated_files(self):
        """Without a new seal every change is an error, except of blanks behind the header, which mean nothing."""
        chance = random.Random(4)
        accepted = 0
        for _ in range(FUZZ_ROUNDS):
            content = bytearray(self.good)
            for _ in range(chance.randint(1, 4)):
                mutate(content, chance, chance.choice((8, 300, len(content))))
            if bytes(content) == self.good:
                continue
            try:
                projector = open_bytes(bytes(content))
            except cad2slam.ProjectorError:
                continue
            accepted += 1
            np.testing.assert_array_equal(projector.slam_from_blueprint(self.poses).poses, self.answers)
        self.assertLess(accepted, FUZZ_ROUNDS // 10)

    def test_mutated_and_sealed_files(self):
        """Whoever can seal can lie, but not crash a reader: an error, or a projector that keeps its promises."""
        chance = random.Random(5)
        for _ in range(FUZZ_ROUNDS // 5):
            arrays = {name: array.copy() for name, array in self.arrays.items()}
            values = dict(self.values)
            for _ in range(chance.randint(1, 3)):
                name = chance.choice(list(arrays))
                raw = bytearray(arrays[name].tobytes())
                mutate_in_place(raw, chance)
                arrays[name] = np.frombuffer(bytes(raw), arrays[name].dtype).reshape(arrays[name].shape)
            if chance.random() < 0.5:
                key = chance.choice([key for key in values if key not in ("format", "version")])
                values[key] = chance.choice(("", "0", "-1", "1e308", "1e-308", "nan", "3", "paper", "rigid", "\u2603"))
            if chance.random() < 0.7:
                arrays["check_poses"] = arrays["check_poses"][:0]
            try:
                projector = open_bytes(file_of(*content_of(arrays, values)))
            except cad2slam.ProjectorError:
                continue
            for direction in (projector.slam_from_blueprint, projector.blueprint_from_slam):
                for policy in ("error", "rigid"):
                    found = direction(self.poses, policy)
                    self.assertTrue(np.isnan(found.poses[~found.ok]).all())
            # An answer that is given comes back.
            there = projector.slam_from_blueprint(self.poses)
            back = projector.blueprint_from_slam(there.poses)
            there_scale = 1.0 + np.abs(there.poses[:, :2]).max(axis=1, initial=0.0)
            off = np.hypot(*(back.poses[:, :2] - self.poses[:, :2]).T)
            wrong = there.ok & back.ok & (off > 1e-5 * there_scale * (1.0 + 1.0 / projector._scale))
            self.assertFalse(wrong.any())


def mutate(content: bytearray, chance: random.Random, reach: int) -> None:
    kind = chance.randrange(6)
    place = chance.randrange(max(1, min(reach, len(content))))
    if kind == 0 and content:
        content[place] ^= 1 << chance.randrange(8)
    elif kind == 1 and content:
        content[place] = chance.choice(b'\x00\xff 0"{}[],:-9')
    elif kind == 2:
        del content[place:place + chance.randint(1, 64)]
    elif kind == 3:
        content[place:place] = bytes(chance.randrange(256) for _ in range(chance.randint(1, 16)))
    elif kind == 4:
        del content[place:]
    else:
        begin = chance.randrange(max(1, len(content)))
        content[place:place + 16] = content[begin:begin + 16]


def mutate_in_place(raw: bytearray, chance: random.Random) -> None:
    if raw:
        place = chance.randrange(len(raw))
        raw[place] = chance.choice((raw[place] ^ (1 << chance.randrange(8)), 0, 255, 0x7F, 0xF0))


if __name__ == "__main__":
    unittest.main()
