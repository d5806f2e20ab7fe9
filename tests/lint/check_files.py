#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Checks each source file as a whole: head, length, whitespace, its test. Prints one line per finding.

usage: check_files.py [ROOT]
"""

import re
import sys
from pathlib import Path

import lint_main

SPDX = ("SPDX-FileCopyrightText: 2026 The CAD2SLAM authors", "SPDX-License-Identifier: Apache-2.0")
MAX_LINES = 500
FOLDERS = ("app", "cmake", "docs", "engine", "packaging", "python", "resources", "sample_maps", "tests", "ui", ".ci")
_CODE = (".h", ".h.in", ".cpp", ".c", ".py", ".sh", ".cmake", ".cmake.in", "CMakeLists.txt")

# Longer files, each with its reason.
LONG_FILES = {
    "python/cad2slam.py": "one file by design: a robot gets it by copying it",
}

# Lines that no file may hold.
FORBIDDEN = (
    (re.compile(r"-march=native"), "AVX would change Eigen's alignment against Debian's libceres"),
    (re.compile(r"^(<<<<<<<|>>>>>>>|=======$)"), "merge marker"),
    (re.compile(r"(?<![\w.}])/(home|root|work)/"), "path of one machine"),
    (re.compile(r"\b(TODO|FIXME|XXX)\b"), "finish it or file an issue"),
    (re.compile(r"[ \t]+$"), "trailing whitespace"),
)
_GLOB = re.compile(r"\bfile\s*\(\s*GLOB")


def is_code(path: Path) -> bool:
    return path.name.endswith(_CODE) or path.parent.name == ".ci"


def files_under(root: Path) -> list[Path]:
    paths = [path for folder in FOLDERS for path in (root / folder).rglob("*")]
    return sorted(path for path in paths + [root / "CMakeLists.txt"]
                  if path.is_file() and is_code(path) and "__pycache__" not in path.parts)


def file_findings(name: str, text: str) -> list[str]:
    """Findings in one file, each starting with its place."""
    found = []
    lines = text.split("\n")
    first = 1 if lines[0].startswith("#!") else 0
    if any(spdx not in line for spdx, line in zip(SPDX, lines[first:first + 2] + ["", ""])):
        found.append(f"{name}:{first + 1}: the two SPDX lines are the head of each file")
    if name.endswith(".h") and "#pragma once" not in lines:
        found.append(f"{name}:1: header without #pragma once")
    if len(lines) - 1 > MAX_LINES and name not in LONG_FILES:
        found.append(f"{name}:{MAX_LINES + 1}: {len(lines) - 1} lines, at most {MAX_LINES} are readable")
    if not text.endswith("\n") or text.endswith("\n\n"):
        found.append(f"{name}:{len(lines)}: ends in exactly one line end")
    for number, line in enumerate(lines, 1):
        for pattern, reason in FORBIDDEN:
            if pattern.search(line):
                found.append(f"{name}:{number}: {reason}: {line.strip()[:60]}")
        if name.endswith("CMakeLists.txt") and _GLOB.search(line):
            found.append(f"{name}:{number}: sources are listed, never globbed")
    return found


def untested(root: Path) -> list[str]:
    """Engine sources without tests/engine/<same path>_test.cpp, less the accepted ones of untested.txt."""
    accepted_path = root / "tests/lint/untested.txt"
    lines = accepted_path.read_text(encoding="utf-8").splitlines() if accepted_path.exists() else []
    accepted = {line.split("#")[0].strip() for line in lines} - {""}
    sources = {path.relative_to(root / "engine/cad2slam").with_suffix("").as_posix()
               for path in (root / "engine/cad2slam").rglob("*.cpp")}
    without = {name for name in sources if not (root / f"tests/engine/{name}_test.cpp").exists()}
    return ([f"engine/cad2slam/{name}.cpp:1: has no tests/engine/{name}_test.cpp" for name in sorted(without - accepted)] +
            [f"tests/lint/untested.txt:1: engine/cad2slam/{name}.cpp is gone" for name in sorted(accepted - sources)])


def findings(root: Path) -> list[str]:
    found = []
    for path in files_under(root):
        name = path.relative_to(root).as_posix()
        if name not in ("tests/lint/check_files.py", "tests/lint/check_files_test.py"):
            found += file_findings(name, path.read_text(encoding="utf-8", errors="replace"))
    return found


if __name__ == "__main__":
    sys.exit(lint_main.run(findings, "files: every file is in order", untested))
