#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""pip installs the Python package from the source tree, with the version of the whole project, without network."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ.get("CAD2SLAM_SOURCE", Path(__file__).resolve().parents[2]))


class InstallingTest(unittest.TestCase):
    @unittest.skipIf(subprocess.run([sys.executable, "-c", "import setuptools, pip, wheel"],
                                    capture_output=True).returncode, "no pip, setuptools and wheel")
    def test_pip_installs_from_the_source_tree(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder) / "tree"
            shutil.copytree(SOURCE / "python", tree / "python")  # building writes beside the sources
            shutil.copy(SOURCE / "CMakeLists.txt", tree)
            target = Path(folder) / "target"
            subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps",
                            "--no-build-isolation", "--target", str(target), str(tree / "python")], check=True)
            version = re.search(r"project\(cad2slam VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
            self.assertTrue((target / f"cad2slam-{version}.dist-info").is_dir())
            program = "import cad2slam, c2s_rmf; print(cad2slam.Status.INSIDE)"
            subprocess.run([sys.executable, "-c", program], check=True, capture_output=True,
                           env={**os.environ, "PYTHONPATH": str(target)})


if __name__ == "__main__":
    unittest.main()
