#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""`cad2slam-cli serve`: what it answers, and that whoever sends rubbish harms nobody but himself."""

import json
import os
import random
import resource
import signal
import socket
import stat
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import cad2slam
from exports_test import CLI, OFFICE, run
from projector_files import content_of, corridor, file_of, random_poses

NAMES = ["inside", "extrapolated", "outside", "folded", "invalid"]


@unittest.skipUnless(os.path.exists(CLI), "the program is not there")
class ServeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        arrays, values = corridor()
        self.path = self.folder / "corridor.c2s"
        self.path.write_bytes(file_of(*content_of(arrays, values)))
        self.projector = cad2slam.load(self.path, native=False)
        self.poses = random_poses(arrays, values, 300)

    def ask(self, *lines):
        """Answers of a server on standard input."""
        text = "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines)
        done = subprocess.run([CLI, "serve", str(self.path)], input=text, capture_output=True, text=True, check=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def server(self, **options):
        path = self.folder / "socket"
        process = subprocess.Popen([CLI, "serve", str(self.path), "--socket", str(path)], stderr=subprocess.PIPE,
                                   **options)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        process.stderr.readline()
        return process, path

    @staticmethod
    def connect(path):
        connection = socket.socket(socket.AF_UNIX)
        connection.settimeout(60)
        connection.connect(str(path))
        return connection

    def compare(self, answer, expected):
        self.assertEqual(answer["status"], [NAMES[code] for code in expected.status])
        for pose, wanted, ok in zip(answer["poses"], expected.poses, expected.ok):
            if ok:
                np.testing.assert_allclose(pose, wanted, atol=1e-9)
            else:
                self.assertIsNone(pose)

    def test_answers_are_those_of_the_library(self):
        poses = [*self.poses.tolist(), [900.0, 900.0, 0.0], [1.5, 2.5]]
        full = np.array([[*pose, 0.0][:3] for pose in poses])
        there, back, rigid = self.ask({"id": 1, "op": "project", "poses": poses},
                                      {"id": "b", "op": "unproject", "poses": poses},
                                      {"op": "project", "poses": poses, "outside": "rigid"})
        self.assertEqual((there["id"], back["id"], "id" in rigid), (1, "b", False))
        self.compare(there, self.projector.slam_from_blueprint(full))
        self.compare(back, self.projector.blueprint_from_slam(full))
        self.compare(rigid, self.projector.slam_from_blueprint(full, "rigid"))
        single, empty, info = self.ask({"id": None, "op": "project", "pose": poses[0]}, {"op": "project", "poses": []},
                                       {"op": "info", "id": 1.5})
        np.testing.assert_allclose(single["pose"], there["poses"][0])
        self.assertEqual((single["status"], single["id"]), ("inside", None))
        self.assertEqual(empty, {"poses": [], "status": []})
        self.assertEqual(info["info"]["nodes"], len(self.projector.arrays["node_slam"]))
        self.assertEqual(info["info"]["slam"]["name"], "slam")

    def test_errors_are_objects(self):
        bad = ("x", "{", "[]", "3", "null", "{}", '{"op": "fly"}', '{"op": "project"}', '{"op": 3}',
               '{"op": "project", "poses": 3}', '{"op": "project", "poses": [[1]]}',
               '{"op": "project", "poses": [[1, 2, 3, 4]]}', '{"op": "project", "poses": [[1, "2"]]}',
               '{"op": "project", "poses": [[[1, 2]]]}', '{"op": "project", "poses": [1, 2]}',
               '{"op": "project", "poses": [[1, NaN]]}', '{"op": "project", "poses": [[1, 1e999]]}',
               '{"op": "project", "pose": [1, 2], "poses": [[1, 2]]}', '{"op": "project", "op": "info"}',
               '{"op": "info", "poses": []}', '{"op": "info", "id": [1]}', '{"op": "info", "id": {"a": 1}}',
               '{"op": "project", "pose": [1, 2], "outside": "clamp"}', '{"op": "info", "extra": 1}',
               '{"op": "info"} {"op": "info"}', "[" * 100000, '{"op":' * 100000, '"\\ud800"')
        good = {"op": "project", "pose": self.poses[0].tolist()}
        answers = self.ask(*(line for text in bad for line in (text, good)))
        self.assertEqual(len(answers), 2 * len(bad))
        for text, answer, after in zip(bad, answers[::2], answers[1::2]):
            self.assertEqual(answer["error"]["code"], "malformed", text[:100])
            self.assertIn("status", after)
        self.assertEqual(self.ask('{"id": 7, "op": "fly"}')[0]["id"], 7)
        self.assertEqual(self.ask("", "\r", json.dumps(good) + "\r")[0]["status"], "inside")

    def test_rubbish_is_survived(self):
        chance = random.Random(3)
        good = json.dumps({"id": 1, "op": "project", "poses": [[1.5, 2.5, 0.1], [2, 3]]}).encode()
        lines = []
        for _ in range(3000):
            line = bytearray(good)
            for _ in range(chance.randint(1, 5)):
                place = chance.randrange(len(line))
                line[place:place + chance.randint(0, 3)] = bytes(chance.choice(b'\x00\xff{}[]",:0e-\\u9') for _ in range(chance.randint(0, 3)))
            lines.append(bytes(line).replace(b"\n", b" "))
        done = subprocess.run([CLI, "serve", str(self.path)], input=b"\n".join(lines), capture_output=True, check=True)
        answers = done.stdout.splitlines()
        self.assertEqual(len(answers), sum(line.strip(b"\r") != b"" for line in lines))
        for answer in answers:
            document = json.loads(answer)
            self.assertTrue("error" in document or "poses" in document or "pose" in document)

    def test_socket(self):
        # Threads of a library, which must not take the signal that ends the server.
        process, path = self.server(env={**os.environ, "OPENBLAS_NUM_THREADS": "4"})
        self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o600)
        first, second, rude, greedy = (self.connect(path) for _ in range(4))
        request = json.dumps({"op": "project", "poses": self.poses.tolist()}).encode() + b"\n"
        first.sendall(request[:100])  # half a line holds nobody up
        second.sendall(request * 3)
        reader = second.makefile()
        for _ in range(3):
            self.compare(json.loads(reader.readline()), self.projector.slam_from_blueprint(self.poses))
        try:
            for _ in range(40):
                rude.sendall(b"x" * (1 << 20))
        except OSError:
            pass  # thrown out
        self.assertIn("too long", json.loads(self.receive_rest(rude).splitlines()[-1])["error"]["message"])
        # Who never reads is not written to without end, and the others do not wait for him.
        greedy.settimeout(5)
        try:
            while True:
                greedy.sendall(request * 20)
        except OSError:
            pass
        first.sendall(request[100:])
        self.compare(json.loads(first.makefile().readline()), self.projector.slam_from_blueprint(self.poses))
        greedy.close()
        second.sendall(b'{"op": "info"}')
        second.shutdown(socket.SHUT_WR)
        self.assertIn("info", json.loads(reader.readline()))
        for connection in (first, second, rude):
            connection.close()
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), 0)
        self.assertFalse(path.exists())

    @staticmethod
    def receive_rest(connection):
        rest = b""
        try:
            while part := connection.recv(1 << 16):
                rest += part
        except OSError:
            pass
        return rest

    def test_many_connections(self):
        _, path = self.server()
        crowd = []
        for _ in range(100):
            crowd.append(socket.socket(socket.AF_UNIX))
            crowd[-1].connect(str(path))
        for connection in crowd:
            connection.close()
        deadline = time.monotonic() + 60
        while True:  # until the server has seen that they are gone
            with self.connect(path) as connection:
                try:
                    connection.sendall(b'{"op": "info"}\n')
                    line = connection.makefile().readline()
                except OSError:
                    line = ""
            if line:
                break
            self.assertLess(time.monotonic(), deadline)
        self.assertIn("info", json.loads(line))

    def test_no_free_descriptor(self):
        """Callers wait for their turn, and the server meanwhile sleeps."""
        few = 12
        process, path = self.server(preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (few, few)))
        crowd = [self.connect(path) for _ in range(2 * few)]
        crowd[0].sendall(b'{"op": "info"}\n')
        self.assertIn("info", crowd[0].makefile().readline())

        def used_seconds():
            fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

        before = used_seconds()
        time.sleep(1.0)
        self.assertLess(used_seconds() - before, 0.2)
        for connection in crowd[:-1]:
            connection.close()
        crowd[-1].sendall(b'{"op": "info"}\n')
        self.assertIn("info", crowd[-1].makefile().readline())
        crowd[-1].close()

    def test_places_that_are_taken(self):
        process, path = self.server()
        self.assertIn("another server", run("serve", self.path, "--socket", path, fails=True))
        process.kill()
        process.wait()
        self.assertTrue(path.exists())  # left behind, and replaced
        process, path = self.server()
        with self.connect(path) as connection:
            connection.sendall(b'{"op": "info"}\n')
            self.assertIn("info", connection.makefile().readline())
        precious = self.folder / "precious"
        precious.write_text("kept")
        self.assertIn("no socket", run("serve", self.path, "--socket", precious, fails=True))
        self.assertEqual(precious.read_text(), "kept")
        self.assertIn("107 bytes", run("serve", self.path, "--socket", "x" * 200, fails=True))


@unittest.skipUnless(os.path.exists(CLI), "the program is not there")
class RobotToRobotTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.arrays, self.values = corridor(blueprint_image_sha256="ab" * 32)
        self.first = self.file("first.c2s")
        self.second = self.file("second.c2s", turn=0.7)

    def file(self, name, turn=0.0, **changes):
        arrays = {key: array.copy() for key, array in self.arrays.items()}
        x, y, heading = arrays["node_slam"].T
        arrays["node_slam"] = np.column_stack([np.cos(turn) * x - np.sin(turn) * y + 5.0,
                                               np.sin(turn) * x + np.cos(turn) * y, heading + turn])
        path = self.folder / name
        values = {key: value for key, value in {**self.values, **changes}.items() if value}
        path.write_bytes(file_of(*content_of(arrays, values)))
        return path

    def test_goes_through_the_blueprint(self):
        first, second = (cad2slam.load(path, native=False) for path in (self.first, self.second))
        poses = random_poses(self.arrays, self.values, 200)
        start, goal = first.slam_from_blueprint(poses).poses, second.slam_from_blueprint(poses).poses
        text = "".join("%r,%r,%r\n" % tuple(pose) for pose in start.tolist())
        rows = [line.split(",") for line in run("project", "--from", self.first, "--to", self.second, text=text).split()]
        self.assertEqual({row[3] for row in rows}, {"inside"})
        found = np.array([[float(field) for field in row[:3]] for row in rows])
        np.testing.assert_allclose(found[:, :2], goal[:, :2], atol=1e-8)
        np.testing.assert_allclose(np.cos(found[:, 2] - goal[:, 2]), 1.0, atol=1e-12)
        source = self.folder / "poses.csv"
        source.write_text(text)
        self.assertEqual(len(run("project", source, "--from", self.first, "--to", self.second).split()), 200)
        self.assertIn("extrapolated", run("project", "--from", self.first, "--to", self.second, "--outside", "rigid",
                                          text="300,300,0\n"))
        self.assertIn("no answer", run("project", "--from", self.first, "--to", self.second, text="300,300,0\n", fails=True))

    def test_another_blueprint_is_refused(self):
        for name, changes, why in (("a", {"blueprint_image_sha256": "cd" * 32}, "different blueprints"),
                                   ("b", {"blueprint_image_sha256": ""}, "does not say"),
                                   ("c", {"blueprint_resolution_m_per_px": "0.1"}, "different resolutions"),
                                   ("d", {"blueprint_origin_x_m": "1"}, "different resolutions")):
            other = self.file(name + ".c2s", **changes)
            self.assertIn(why, run("project", "--from", self.first, "--to", other, text="1,2\n", fails=True))

    def test_wrong_usage(self):
        for arguments in (["--to", "slam"], [self.first, "--to", "here"], ["--from", self.first, "--to", "slam"],
                          ["a", "b", "--from", self.first, "--to", self.second], [self.first, "a", "b", "--to", "slam"]):
            done = subprocess.run([CLI, "project", *map(str, arguments)], input="", capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, arguments)


if __name__ == "__main__":
    unittest.main()
