# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Only the version, which stands in the CMakeLists.txt of the whole project and nowhere else."""

import re
from pathlib import Path

from setuptools import setup

HERE = Path(__file__).resolve().parent


def version() -> str:
    packed = HERE / "PKG-INFO"  # in a source distribution, which has no folder above
    text = packed.read_text() if packed.exists() else (HERE.parent / "CMakeLists.txt").read_text()
    return re.search(r"^Version: (\S+)" if packed.exists() else r"project\(cad2slam VERSION (\S+)", text, re.M).group(1)


setup(version=version())
