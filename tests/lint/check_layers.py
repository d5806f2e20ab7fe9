#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Checks every #include against the layers of CONTRIBUTING.md. Prints one line per finding; exit code 1 if any.

usage: check_layers.py [ROOT]
"""

import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

import lint_main

# What a module of the engine may include besides itself.
_BASE = {"core", "geometry"}
_PLACES = _BASE | {"map", "anchors", "mesh"}
_FUNCTION = _PLACES | {"solver", "projection"}
MODULES = {
    "core": set(),
    "geometry": {"core"},
    "map": _BASE,
    "anchors": _BASE | {"map"},
    "mesh": _BASE | {"map"},
    "solver": _PLACES,
    "projection": _PLACES | {"solver"},
    "planning": _FUNCTION,
    "simulation": _FUNCTION,
    "evaluation": _FUNCTION | {"planning", "simulation"},
    "exports": _FUNCTION,
    "io": _BASE,  # and VALUE_HEADERS
    "c_api": _BASE | {"io"},
}

# Values that files hold: no algorithm behind them.
VALUE_HEADERS = {
    "cad2slam/anchors/anchor.h",
    "cad2slam/exports/feature.h",
    "cad2slam/exports/level_transform.h",
    "cad2slam/exports/pose_grid.h",
    "cad2slam/exports/triangle_mesh.h",
    "cad2slam/map/map_frame.h",
    "cad2slam/map/occupancy_grid.h",
    "cad2slam/mesh/tile_lattice.h",
    "cad2slam/planning/start_goal.h",
    "cad2slam/projection/projector_data.h",
    "cad2slam/simulation/true_warp.h",
    "cad2slam/solver/solution.h",
    "cad2slam/solver/solver_settings.h",
}

QT = r"Q[A-Z]\w*|Qt\w*(/.*)?|q[a-z]+\.h"
CERES = r"ceres/.*|glog/.*"
CHOLMOD = r"(.*/)?(cholmod|SuiteSparse_config|SuiteSparseQR|umfpack|metis|amd|camd|colamd)\w*\.h(pp)?|Eigen/CholmodSupport"
OPENCV = r"opencv2/.*"
YAML = r"yaml-cpp/.*"
JSON = r"nlohmann/.*"


class Rule(NamedTuple):
    where: str  # regular expression on the file's path from the root
    what: str  # regular expression on what is included
    reason: str


RULES = [
    Rule(r"engine/.*", QT, "the engine knows no Qt"),
    Rule(r"engine/.*", r"(ui|app)/.*", "the engine knows neither the desktop app nor the programs"),
    Rule(r"engine/cad2slam/(?!solver/).*", CERES, "Ceres stays in engine/cad2slam/solver"),
    Rule(r"engine/cad2slam/(?!solver/).*", CHOLMOD, "CHOLMOD stays in engine/cad2slam/solver"),
    Rule(r"engine/cad2slam/(?!io/).*", YAML, "yaml-cpp stays in engine/cad2slam/io"),
    Rule(r"engine/cad2slam/(?!io/).*", JSON, "nlohmann/json stays in engine/cad2slam/io"),
    Rule(r"engine/cad2slam/.*\.h", YAML + "|" + JSON, "public headers do not show the libraries behind a reader"),
    Rule(r"(ui|app)/.*", CERES + "|" + CHOLMOD, "the programs solve through the engine, never with Ceres itself"),
    Rule(r"(ui|app)/.*", YAML, "the programs read maps through the engine"),
    Rule(r"ui/.*", JSON, "the desktop app reads projects through the engine"),
    Rule(r"ui/.*", r"app/.*", "the desktop library knows no program"),
    Rule(r"ui/views/.*", r"(ui/)?services/.*", "views show values and send signals, they start no work"),
    Rule(r"ui/(document|models)/.*", r"(ui/)?(views|tools|panels|dialogs|main_window|services)/.*|(ui/)?main_window\.h",
         "state does not know who shows or computes it"),
    Rule(r"ui/services/.*", r"(ui/)?(tools|panels|dialogs|main_window)/.*|(ui/)?main_window\.h",
         "services know neither panels nor windows"),
]

# The part of the engine that robots link.
PROJECTOR_FORBIDDEN = Rule(r"", "|".join((QT, CERES, CHOLMOD, OPENCV, YAML)),
                           "the robots' library knows neither Ceres nor OpenCV nor yaml-cpp")

# (file, include) pairs that break a rule on purpose, with the reason.
ALLOWED = {
    # Reading a projector ends in one: robots get the function, not its arrays.
    ("engine/cad2slam/io/projector_file.h", "cad2slam/projection/projector.h"),
    # Answers of the server are written as the projector gives them.
    ("engine/cad2slam/io/pose_protocol.h", "cad2slam/projection/projector.h"),
    # Headers between sources of io: not installed.
    ("engine/cad2slam/io/guarded_yaml.h", "yaml-cpp/eventhandler.h"),
    ("engine/cad2slam/io/guarded_yaml.h", "yaml-cpp/yaml.h"),
    ("engine/cad2slam/io/json_reader.h", "nlohmann/json.hpp"),
    ("engine/cad2slam/io/strict_json.h", "nlohmann/json.hpp"),
}

_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')
_SOURCES = {".h", ".hpp", ".c", ".cpp", ".in"}


class Include(NamedTuple):
    file: str
    line: int
    target: str


def includes_under(root: Path, folder: str) -> Iterator[Include]:
    """Every #include line below a folder of the tree, files in order of their names."""
    for path in sorted((root / folder).rglob("*")):
        if path.suffix not in _SOURCES or not path.is_file():
            continue
        name = path.relative_to(root).as_posix()
        for number, text in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            match = _INCLUDE.match(text)
            if match:
                yield Include(name, number, match.group(1))


def projector_files(cmake: str) -> set[str]:
    """The files of the targets for robots, as named in engine/CMakeLists.txt, with the private header of each source."""
    files: set[str] = set()
    for block in re.findall(r"target_sources\(\s*cad2slam_(?:projector|c)\b([^)]*)\)", cmake):
        files.update(re.findall(r"cad2slam/[\w/]+\.(?:h|cpp)", block))
    return files | {re.sub(r"\.cpp$", ".h", file) for file in files}


def module_finding(include: Include) -> str | None:
    """Why this include breaks the order of the engine's modules, or None."""
    own, target = re.match(r"engine/cad2slam/(\w+)/", include.file), re.match(r"cad2slam/(\w+)/", include.target)
    if not own or not target:
        return None
    own_module, target_module = own.group(1), target.group(1)
    for module in (own_module, target_module):
        if module not in MODULES:
            return f"module '{module}' has no place in the layers: add it to check_layers.py and CONTRIBUTING.md"
    if target_module == own_module or target_module in MODULES[own_module]:
        return None
    if own_module == "io":
        return None if include.target in VALUE_HEADERS else "io sees values only"
    return f"{own_module} lies below {target_module}"


def projector_finding(include: Include, robots: set[str]) -> str | None:
    """Why this include does not fit the robots' library, or None."""
    if include.file.removeprefix("engine/") not in robots:
        return None
    if re.fullmatch(PROJECTOR_FORBIDDEN.what, include.target):
        return PROJECTOR_FORBIDDEN.reason
    if include.target.startswith("cad2slam/") and include.target not in robots:
        return "the robots' library holds everything that it includes (target cad2slam_projector)"
    return None


def findings(root: Path) -> list[str]:
    """One sentence per include that breaks a rule."""
    robots = projector_files((root / "engine/CMakeLists.txt").read_text(encoding="utf-8"))
    if not robots:
        return ["engine/CMakeLists.txt: no sources of target cad2slam_projector found"]
    found = []
    for folder in ("engine", "ui", "app"):
        for include in includes_under(root, folder):
            if (include.file, include.target) in ALLOWED:
                continue
            reasons = [rule.reason for rule in RULES
                       if re.fullmatch(rule.where, include.file) and re.fullmatch(rule.what, include.target)]
            reasons += filter(None, (module_finding(include), projector_finding(include, robots)))
            found += [f"{include.file}:{include.line}: includes {include.target}: {reason}" for reason in reasons]
    return found


if __name__ == "__main__":
    sys.exit(lint_main.run(findings, "layers: every include is in order"))
