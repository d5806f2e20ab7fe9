#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Each export of the command line program, checked by a reader that shares nothing with its writer."""

import json
import os
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

import numpy as np
import yaml

import cad2slam

CLI = os.environ.get("CAD2SLAM_CLI", "")
OFFICE = os.environ.get("CAD2SLAM_OFFICE_PROJECTOR", "")


def run(*arguments, fails=False, text=None):
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, input=text)
    if not fails and done.returncode:
        raise AssertionError(done.stderr)
    if fails and done.returncode != 1:
        raise AssertionError(f"exit code {done.returncode}: {done.stdout}{done.stderr}")
    return done.stderr if fails else done.stdout


def collection(*features):
    return {"type": "FeatureCollection", "features": [
        {"type": "Feature", "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties}
        for kind, coordinates, properties in features]}


def distance_to_line(points, line):
    """Of each point to a polyline."""
    best = np.full(len(points), np.inf)
    for a, b in zip(line, line[1:]):
        along = b - a
        part = np.clip((points - a) @ along / max(along @ along, 1e-300), 0.0, 1.0)
        best = np.minimum(best, np.linalg.norm(points - (a + part[:, None] * along), axis=1))
    return best


def dense(line, step=0.02):
    line = np.asarray(line, float)
    pieces = [a + np.linspace(0.0, 1.0, max(2, int(np.linalg.norm(b - a) / step)), endpoint=False)[:, None] * (b - a)
              for a, b in zip(line, line[1:])]
    return np.vstack([*pieces, line[-1:]])


def read_pgm(path):
    content = path.read_bytes()
    fields = content.split(None, 4)
    width, height, largest = int(fields[1]), int(fields[2]), int(fields[3])
    assert fields[0] == b"P5" and largest == 255
    return np.frombuffer(content[-width * height:], np.uint8).reshape(height, width)


def unfiltered(kind, line, above):
    """One row of a PNG with a byte for each pixel."""
    if kind == 0:
        return line
    if kind == 1:
        return np.cumsum(line, dtype=np.uint8)
    if kind == 2:
        return line + above
    row = np.zeros(len(line) + 1, int)  # the pixel before the first one is 0
    up = np.concatenate([[0], above]).astype(int)
    for k, value in enumerate(line.tolist(), 1):
        left, over, corner = row[k - 1], up[k], up[k - 1]
        by_paeth = min((left, over, corner), key=lambda candidate: abs(left + over - corner - candidate))
        row[k] = (value + ((left + over) // 2 if kind == 3 else by_paeth)) % 256
    return row[1:].astype(np.uint8)


def read_png(path):
    """A grey picture with 8 bits for each pixel."""
    content, place, data = path.read_bytes(), 8, b""
    while place < len(content):
        length, kind = struct.unpack(">I4s", content[place:place + 8])
        chunk = content[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", chunk)
            assert form == [8, 0, 0, 0, 0]
        data += chunk if kind == b"IDAT" else b""
        place += 12 + length
    lines = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, width + 1)
    picture = np.zeros((height + 1, width), np.uint8)  # the row above the first one is 0
    for row, line in enumerate(lines, 1):
        picture[row] = unfiltered(line[0], line[1:], picture[row - 1])
    return picture[1:]


@unittest.skipUnless(os.path.exists(CLI) and os.path.exists(OFFICE), "the program or the sample is not there")
class ExportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.projector = cad2slam.load(OFFICE, native=False)
        middles = cls.projector.arrays["node_blueprint"]
        # A place well inside: all around it lies on the mesh.
        counts = [(np.abs(middles - place).max(axis=1) < 3.0).sum() for place in middles[::7]]
        cls.middle = middles[::7][int(np.argmax(counts))]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, document, name="in.geojson"):
        path = self.folder / name
        path.write_text(json.dumps(document))
        return path

    def square(self, half):
        x, y = self.middle
        return [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half],
                [x - half, y - half]]

    def to_slam(self, points):
        found = self.projector.slam_from_blueprint(points, "rigid")
        return found.poses[:, :2]

    def test_features(self):
        x, y = self.middle
        path = [[x - 2.5, y - 2.0], [x + 2.5, y + 2.0], [x + 2.0, y - 2.0]]
        document = collection(("Polygon", [self.square(2.0), self.square(0.5)], {"name": "zone", "kept": [1, {"a": 2}]}),
                              ("LineString", path, {"speed": 3}),
                              ("MultiPoint", [[x, y], [x + 1.0, y]], {"name": "places"}),
                              ("Point", [x, y, 7.0], {"theta": 0.5}))
        document["features"][1]["id"] = "lane 7"
        for error in (0.1, 0.01, 0.001):
            out = self.folder / "slam.geojson"
            run("export", "features", OFFICE, self.write(document), "--to", "slam", "--chord-error", error, "-o", out)
            warped = json.loads(out.read_text())["features"]
            self.assertEqual(warped[0]["properties"]["kept"], [1, {"a": 2}])
            self.assertEqual(warped[1]["id"], "lane 7")
            lines = [(self.square(2.0), warped[0]["geometry"]["coordinates"][0]),
                     (self.square(0.5), warped[0]["geometry"]["coordinates"][1]),
                     (path, warped[1]["geometry"]["coordinates"])]
            for before, after in lines:
                exact = self.to_slam(dense(before))
                after = np.array(after)
                self.assertLess(distance_to_line(exact, after).max(), error)
                self.assertLess(distance_to_line(dense(after), exact).max(), error + 0.01)
                np.testing.assert_allclose(after[[0, -1]], exact[[0, -1]], atol=1e-9)
            pose = self.projector.slam_from_blueprint([x, y, 0.5]).poses
            np.testing.assert_allclose(warped[3]["geometry"]["coordinates"], pose[:2], atol=1e-9)
            self.assertAlmostEqual(warped[3]["properties"]["theta"], pose[2], places=9)
            self.assertEqual(np.shape(warped[2]["geometry"]["coordinates"]), (2, 2))

            back = self.folder / "back.geojson"
            run("export", "features", OFFICE, out, "--to", "blueprint", "--chord-error", error, "-o", back)
            again = json.loads(back.read_text())["features"]
            ring = np.array(again[0]["geometry"]["coordinates"][0])
            self.assertLess(distance_to_line(ring, np.array(self.square(2.0))).max(), 2.5 * error)

    def test_csv_is_the_same(self):
        x, y = self.middle
        source = self.folder / "in.csv"
        source.write_text(f"feature,kind,part,x,y,theta,name\n1,point,1,{x},{y},0.5,\"a \"\"b\"\", c\"\n"
                          f"2,path,1,{x},{y},,way\n2,path,1,{x + 1},{y},,way\n")
        out = self.folder / "out.csv"
        run("export", "features", OFFICE, source, "--to", "slam", "-o", out)
        rows = out.read_text().splitlines()
        pose = self.projector.slam_from_blueprint([x, y, 0.5]).poses
        self.assertEqual(rows[0], "feature,kind,part,x,y,theta,name")
        self.assertTrue(rows[1].endswith(',"a ""b"", c"'))
        np.testing.assert_allclose([float(field) for field in rows[1].split(",")[3:6]], pose, atol=1e-9)
        places = self.folder / "places.csv"
        places.write_text(f"x;y\n{x};{y}\n{x + 1};{y}\n")
        run("export", "features", OFFICE, places, "--to", "slam", "-o", out)
        self.assertEqual(len(out.read_text().splitlines()), 3)

    def test_wrong_features_are_refused(self):
        out = self.folder / "out.geojson"
        far = self.write(collection(("Point", [9e5, 9e5], {"name": "Mars"})), "far.geojson")
        message = run("export", "features", OFFICE, far, "--to", "slam", "--outside", "error", "-o", out, fails=True)
        self.assertIn("far.geojson: 'Mars': the place (900000, 900000) lies outside the mesh; with 'outside rigid'", message)
        self.assertFalse(out.exists())
        for text in ("", "{", "[]", '{"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]}',
                     '{"type": "Point", "coordinates": ["a", 0]}', '{"type": "Point", "coordinates": [1e999, 0]}',
                     '{"type": "Circle", "coordinates": [0, 0]}', '{"type": "FeatureCollection", "features": 3}',
                     '{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null}]}',
                     '{"type": "MultiPolygon", "coordinates": []}', '[' * 100000):
            path = self.folder / "bad.geojson"
            path.write_text(text)
            self.assertIn("bad.geojson", run("export", "features", OFFICE, path, "--to", "slam", "-o", out, fails=True))

    def mask(self, *arguments):
        out = self.folder / "mask.yaml"
        run("export", *arguments, "-o", out)
        description = yaml.safe_load(out.read_text())
        self.assertEqual(description["origin"][2], 0)
        return description, read_pgm(self.folder / description["image"])

    @staticmethod
    def pixels(description, picture, points):
        column, row = ((np.asarray(points) - description["origin"][:2]) / description["resolution"]).T
        return picture[picture.shape[0] - 1 - np.floor(row).astype(int), np.floor(column).astype(int)]

    def test_keepout_mask_leaves_nothing_out(self):
        zone = self.write(collection(("Polygon", [self.square(1.5), self.square(0.8)], {}),
                                     ("LineString", [self.square(2.5)[0], self.square(2.5)[1]], {})))
        random = np.random.default_rng(1)
        for buffer in (0.0, 0.3):
            description, picture = self.mask("keepout", OFFICE, zone, "--buffer", buffer)
            self.assertEqual((description["mode"], description["negate"]), ("trinary", 0))
            self.assertEqual(set(np.unique(picture)), {0, 254})
            spread = self.middle + random.uniform(-3.0, 3.0, (40000, 2))
            ring = np.abs(spread - self.middle).max(axis=1)
            in_zone = (ring <= 1.5) & (ring >= 0.8)
            inside = self.to_slam(spread[in_zone])
            turned = random.uniform(-np.pi, np.pi, len(inside))
            near = inside + buffer * random.random((len(inside), 1)) * np.column_stack([np.cos(turned), np.sin(turned)])
            self.assertTrue((self.pixels(description, picture, near) == 0).all())
            line = self.to_slam(dense([self.square(2.5)[0], self.square(2.5)[1]]))
            self.assertTrue((self.pixels(description, picture, line) == 0).all())
            # And not much more: what is farther away is free.
            borders = np.vstack([self.to_slam(dense(self.square(half))) for half in (1.5, 0.8)] + [line])
            outside = self.to_slam(spread[~in_zone])
            distance = np.array([np.linalg.norm(borders - place, axis=1).min() for place in outside[:3000]])
            far = distance > buffer + 0.02 + 0.01 + 1.8 * description["resolution"]
            self.assertGreater(far.sum(), 300)
            self.assertTrue((self.pixels(description, picture, outside[:3000][far]) == 254).all())

    def test_keepout_of_everything_but_the_zones(self):
        x, y = self.middle
        zone = self.write(collection(("Polygon", [self.square(1.0)], {}), ("LineString", [[x, y], [x + 2.5, y]], {})))
        description, picture = self.mask("keepout", OFFICE, zone, "--buffer", 0.25, "--only-inside")
        rows, columns = np.nonzero(picture == 254)
        self.assertGreater(len(rows), 100)
        resolution = description["resolution"]
        corners = np.array([(0, 0), (1, 0), (0, 1), (1, 1)])
        lower_left = np.column_stack([columns, picture.shape[0] - 1 - rows])
        places = (lower_left[:, None] + corners).reshape(-1, 2) * resolution + description["origin"][:2]
        ring = np.abs(self.projector.blueprint_from_slam(places, "rigid").poses[:, :2] - self.middle).max(axis=1)
        lane = self.to_slam(dense([[x, y], [x + 2.5, y]]))
        on_lane = np.array([np.linalg.norm(lane - place, axis=1).min() for place in places]) <= 0.25
        self.assertTrue((on_lane | (ring <= 1.0)).all())

    def test_speed_mask(self):
        zones = self.write(collection(("Polygon", [self.square(2.0)], {"speed_percent": 70}),
                                      ("Polygon", [self.square(1.0)], {"speed_percent": 20})))
        description, picture = self.mask("speed", OFFICE, zones, "--buffer", 0.0)
        self.assertEqual(description["mode"], "scale")
        # As map_server reads it: 100 * (occupancy - free) / (occupied - free).
        occupancy = (255.0 - picture) / 255.0
        value = np.rint(100.0 * (occupancy - description["free_thresh"]) /
                        (description["occupied_thresh"] - description["free_thresh"]))
        self.assertEqual(set(np.unique(value)), {0.0, 20.0, 70.0})
        around = self.to_slam(self.middle + np.array([[0.0, 0.0], [1.5, 0.0], [2.8, 2.8]]))
        self.assertEqual(self.pixels(description, value, around).tolist(), [20.0, 70.0, 0.0])
        for wrong in (0, 101, "fast"):
            path = self.write(collection(("Polygon", [self.square(2.0)], {"speed_percent": wrong})))
            self.assertIn("1 to 100", run("export", "speed", OFFICE, path, "-o", self.folder / "x.yaml", fails=True))

    def test_warped_blueprint(self):
        """Each pixel of the map in the other frame shows what the projector finds at its middle."""
        site = Path(os.environ["CAD2SLAM_SOURCE"]) / "sample_maps" / "office"
        for to, source in (("slam", "blueprint"), ("blueprint", "slam_1")):
            out = self.folder / f"{to}.yaml"
            run("warp", OFFICE, "--to", to, site / f"{source}.yaml", "-o", out)
            target = yaml.safe_load(out.read_text())
            warped = read_png(self.folder / target["image"])
            before = yaml.safe_load((site / f"{source}.yaml").read_text())
            picture = read_png(site / before["image"])
            rows, columns = np.random.default_rng(7).integers(0, warped.shape, (20000, 2)).T
            middles = np.column_stack([columns + 0.5, warped.shape[0] - rows - 0.5]) * target["resolution"]
            back = self.projector.blueprint_from_slam if to == "slam" else self.projector.slam_from_blueprint
            found = back(middles + target["origin"][:2], "error")
            column, row = ((found.poses[found.ok, :2] - before["origin"][:2]) / before["resolution"]).T
            row, column = picture.shape[0] - 1 - np.floor(row).astype(int), np.floor(column).astype(int)
            reach = 3  # pixels in which there must be no border of anything
            clear = ((row >= reach) & (column >= reach) & (row < picture.shape[0] - reach) &
                     (column < picture.shape[1] - reach))
            near = np.stack([picture[row[clear] + u, column[clear] + v]
                             for u in range(-reach, reach + 1) for v in range(-reach, reach + 1)])
            same = near.min(axis=0) == near.max(axis=0)
            shown = warped[rows[found.ok], columns[found.ok]][clear]
            self.assertGreater(same.sum(), 1000)
            self.assertGreater(len(np.unique(near[0, same])), 1)
            np.testing.assert_array_equal(self.states(target, shown[same]), self.states(before, near[0, same]))

    @staticmethod
    def states(description, grey):
        """Free -1, unknown 0 and occupied 1, as map_server reads a trinary map."""
        occupancy = (255.0 - grey) / 255.0
        return (occupancy > description["occupied_thresh"]).astype(int) - (occupancy < description["free_thresh"])

    def test_waypoints(self):
        x, y = self.middle
        points = self.write(collection(("Point", [x, y], {"name": "dock: \"1\"", "heading_rad": 2.5}),
                                       ("Point", [x + 1, y], {})))
        out = self.folder / "waypoints.yaml"
        run("export", "waypoints", OFFICE, points, "-o", out)
        waypoints = yaml.safe_load(out.read_text())["waypoints"]
        self.assertEqual(list(waypoints), ["waypoint0", "waypoint1"])
        pose = self.projector.slam_from_blueprint([x, y, 2.5]).poses
        w, qx, qy, qz = waypoints["waypoint0"]["orientation"]
        np.testing.assert_allclose(waypoints["waypoint0"]["pose"], [*pose[:2], 0.0], atol=1e-9)
        np.testing.assert_allclose([np.cos(pose[2]), np.sin(pose[2]), qx, qy], [w * w - qz * qz, 2 * w * qz, 0, 0],
                                   atol=1e-9)

    def test_rmf_transform(self):
        lanes = self.write(collection(("LineString", self.square(2.0), {"name": "lane \"A\""})))
        out = self.folder / "rmf.yaml"
        for arguments in ((lanes,), ()):
            run("export", "rmf", OFFICE, *arguments, "--level", "L: 1", "-o", out)
            document = yaml.safe_load(out.read_text())
            references = document["reference_coordinates"]["L: 1"]
            source, target = (np.array(references[key]) @ [1.0, 1.0j] for key in ("rmf", "robot"))
            np.testing.assert_allclose(self.to_slam(np.column_stack([source.real, source.imag])) @ [1.0, 1.0j], target,
                                       atol=1e-9)
            # Least squares in complex numbers: target = a source + b.
            a, b = np.linalg.lstsq(np.column_stack([source, np.ones_like(source)]), target, rcond=None)[0]
            transform = document["rmf_fleet"]["transforms"]["L: 1"]
            off = a * source + b - (transform["scale"] * np.exp(1j * transform["rotation"]) * source +
                                    complex(*transform["translation"]))
            self.assertLess(np.abs(off).max(), 0.1)

    @unittest.skipUnless(shutil.which("cct"), "no cct (Debian package proj-bin)")
    def test_tinshift_through_proj(self):
        out = self.folder / "office.json"
        for vertices in (10000, 500):
            printed = run("export", "tinshift", OFFICE, "--vertices", vertices, "-o", out)
            document = json.loads(out.read_text())
            self.assertLessEqual(len(document["vertices"]), vertices)
            tolerance = float(printed.split("up to ")[1].split(" m")[0]) + 0.002
            nodes = self.projector.arrays["node_blueprint"]
            points = nodes + np.random.default_rng(2).uniform(-0.2, 0.2, nodes.shape)

            def through_proj(places, *flags):
                text = "".join(f"{x:.12f} {y:.12f} 0 0\n" for x, y in places)
                done = subprocess.run(["cct", "-d", "10", *flags, "+proj=tinshift", f"+file={out}"], input=text,
                                      capture_output=True, text=True, check=True)
                return np.array([[float(v) for v in row.split()[:2]] for row in done.stdout.splitlines()])

            there = through_proj(points)
            self.assertLess(np.abs(there - self.to_slam(points)).max(), tolerance * 1.2)
            self.assertLess(np.abs(through_proj(there, "-I") - points).max(), 1e-6)

    def test_g2o(self):
        out = self.folder / "office.g2o"
        run("export", "g2o", OFFICE, "-o", out)
        poses, points, fixed, edges, sightings = {}, {}, set(), [], []
        for line in out.read_text().splitlines():
            tag, *fields = line.split()
            numbers = [float(field) for field in fields]
            if tag == "VERTEX_SE2":
                poses[int(numbers[0])] = numbers[1:]
            elif tag == "VERTEX_XY":
                points[int(numbers[0])] = numbers[1:]
            elif tag == "FIX":
                fixed.add(int(numbers[0]))
            elif tag == "EDGE_SE2":
                edges.append(numbers)
            elif tag == "EDGE_SE2_XY":
                sightings.append(numbers)
            else:
                self.fail(line)
        arrays = self.projector.arrays
        self.assertEqual((len(poses), len(edges), len(points)),
                         (len(arrays["node_slam"]), len(arrays["edges"]), len(arrays["anchors"])))
        self.assertEqual(fixed, set(points))
        np.testing.assert_allclose([poses[k][:2] for k in range(len(poses))], arrays["node_slam"][:, :2], atol=1e-12)
        # Neighbours see each other where the measurement says, but for how much the mesh bends and stretches.
        for i, j, dx, dy, turn, xx, xy, xt, yy, yt, tt in edges[::37]:
            x, y, heading = poses[int(i)]
            ahead = np.array(poses[int(j)][:2]) - [x, y]
            seen = np.array([[np.cos(heading), np.sin(heading)], [-np.sin(heading), np.cos(heading)]]) @ ahead
            self.assertLess(np.linalg.norm(seen - [dx, dy]), 0.25 * np.hypot(dx, dy))
            self.assertEqual((turn, xt, yt, tt), (0.0, 0.0, 0.0, 10.0))
            np.testing.assert_allclose(np.linalg.eigvalsh([[xx, xy], [xy, yy]]), [1.0, 10.0], atol=1e-9)
            np.testing.assert_allclose(np.array([[xx, xy], [xy, yy]]) @ [dx, dy], [dx, dy], atol=1e-9)
        for node, point, dx, dy, xx, xy, yy in sightings:
            x, y, heading = poses[int(node)]
            seen = [x + np.cos(heading) * dx - np.sin(heading) * dy, y + np.sin(heading) * dx + np.cos(heading) * dy]
            self.assertLess(np.linalg.norm(np.array(seen) - points[int(point)]), 0.5)

    def test_grids(self):
        for to in ("slam", "blueprint"):
            out = self.folder / f"to_{to}.npy"
            run("export", "grid", OFFICE, "--to", to, "--step", 0.3, "-o", out)
            grid = np.load(out)
            info = json.loads(out.with_suffix(".json").read_text())
            self.assertEqual(list(grid.shape), info["shape"])
            nodes = self.projector.arrays["node_blueprint"]
            places = nodes + np.random.default_rng(3).uniform(-0.29, 0.29, nodes.shape)
            images = self.to_slam(places)
            if to == "blueprint":
                places, images = images, places
            column, row = ((places - [info["first_x_m"], info["first_y_m"]]) / info["step_m"]).T
            c, r = np.floor(column).astype(int), np.floor(row).astype(int)
            u, v = (column - c)[:, None], (row - r)[:, None]
            bilinear = ((1 - u) * (1 - v) * grid[r, c] + u * (1 - v) * grid[r, c + 1] +
                        (1 - u) * v * grid[r + 1, c] + u * v * grid[r + 1, c + 1])[:, :2]
            self.assertTrue(np.isfinite(bilinear).all())
            off = np.linalg.norm(bilinear - images, axis=1)
            self.assertLess(np.quantile(off, 0.99), 1.5 * info["max_deviation_m"] + 1e-6)


if __name__ == "__main__":
    unittest.main()
