#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""How fast poses are projected from Python and through the server. Prints microseconds of processor time per pose.

usage: bench.py [NODES]        with PYTHONPATH=python, and CAD2SLAM_LIBRARY and CAD2SLAM_CLI where they are built
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import cad2slam
from projector_files import block, content_of, file_of, random_poses

POSES = 1_000_000


def measure(what, count, work):
    start = time.process_time()
    result = work()
    print(f"{what:<44} {(time.process_time() - start) / count * 1e6:8.3f} us")
    return result


def bench_server(path, poses):
    lines = [json.dumps({"op": "project", "poses": batch.tolist()}) + "\n" for batch in np.array_split(poses, 1000)]
    single = [json.dumps({"op": "project", "pose": pose.tolist()}) + "\n" for pose in poses[:100_000]]
    for what, text, count in (("server, batches of 1000", "".join(lines), POSES),
                              ("server, one pose a line", "".join(single), len(single))):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([os.environ["CAD2SLAM_CLI"], "serve", str(path)], input=text, stdout=subprocess.DEVNULL, text=True,
                       check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        print(f"{what:<44} {seconds / count * 1e6:8.3f} us, {count / seconds:10.0f} poses/s on one core")


def main():
    side = int(max(4, (int(sys.argv[1]) if len(sys.argv) > 1 else 4000)**0.5))
    arrays, values = block(side, side)
    poses = random_poses(arrays, values, POSES)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bench.c2s"
        path.write_bytes(file_of(*content_of(arrays, values)))
        print(f"{side * side} nodes, {POSES} poses")
        for native in (False, True):
            try:
                kind = "C library" if native else "numpy"
                projector = measure(f"{kind}, loading (whole file)", 1, lambda: cad2slam.load(path, native=native))
            except ImportError:
                continue
            there = measure(f"{kind}, blueprint to SLAM", POSES, lambda: projector.slam_from_blueprint(poses))
            measure(f"{kind}, SLAM to blueprint", POSES // 10,
                    lambda: projector.blueprint_from_slam(there.poses[:POSES // 10]))
            measure(f"{kind}, one call for one pose", 1000,
                    lambda: [projector.slam_from_blueprint(pose) for pose in poses[:1000]])
        if os.path.exists(os.environ.get("CAD2SLAM_CLI", "")):
            bench_server(path, poses)


if __name__ == "__main__":
    main()
