#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Runs every command and the Python code of README.md and compares what is printed, numbers aside.

usage: readme_test.py ROOT PROGRAMS [--update]      --update writes what was printed into README.md
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

_CONSOLE = re.compile(r"(?<=```console\n).*?(?=```)", re.DOTALL)
_PYTHON = re.compile(r"(?<=```python\n).*?(?=```)", re.DOTALL)
_NUMBER = re.compile(r"\d+(\.\d+)?(e[-+]?\d+)?")


def run_block(block: str, folder: str, programs: str) -> str:
    """The block with the output of its commands as it is now."""
    lines = []
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}")
    for command in re.findall(r"^\$ (.+)$", block, re.MULTILINE):
        done = subprocess.run(command, shell=True, cwd=folder, env=environment, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        lines += [f"$ {command}\n", done.stdout]
    return "".join(lines)


def without_numbers(text: str) -> str:
    return _NUMBER.sub("#", re.sub(r"\b[0-9a-f]{12}\.\.\.|\d+-\d+-\d+T[\d:]+Z", "#", text))


def main() -> int:
    root, programs, update = Path(sys.argv[1]).resolve(), str(Path(sys.argv[2]).resolve()), "--update" in sys.argv
    readme = root / "README.md"
    text = readme.read_text(encoding="utf-8")
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "sample_maps").symlink_to(root / "sample_maps")
        actual = _CONSOLE.sub(lambda match: run_block(match.group(), folder, programs), text)
        if update:
            readme.write_text(actual, encoding="utf-8")
        elif without_numbers(actual) != without_numbers(text):
            for wrote, prints in zip(_CONSOLE.findall(text), _CONSOLE.findall(actual)):
                if without_numbers(wrote) != without_numbers(prints):
                    print(f"README.md says\n{wrote}\nbut now it is\n{prints}")
                    failed += 1
        try:
            import numpy  # noqa: F401  pylint: disable=unused-import,import-outside-toplevel
        except ImportError:
            print("no numpy (Debian: python3-numpy), the Python code was not run")
            return failed
        for code in _PYTHON.findall(text):
            check = "\nassert arrays['node_slam'].shape == (len(arrays['node_blueprint']), 3) and 'version' in info\n"
            failed += subprocess.run([sys.executable, "-c", code + check], cwd=folder, check=False).returncode != 0
    return failed


if __name__ == "__main__":
    sys.exit(main())
