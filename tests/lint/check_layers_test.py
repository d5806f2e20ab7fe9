#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Plants violations in a small tree and expects each to be found, and nothing else."""

import tempfile
import unittest
from pathlib import Path

import check_layers

CMAKE = """
add_library(cad2slam_projector)
target_sources(cad2slam_projector
  PRIVATE cad2slam/io/projector_file.cpp cad2slam/io/private.cpp
  PUBLIC FILE_SET HEADERS BASE_DIRS . FILES cad2slam/core/result.h cad2slam/projection/projector.h)
target_sources(cad2slam_engine PRIVATE cad2slam/solver/mesh_solver.cpp)
"""


class CheckLayersTest(unittest.TestCase):
    def findings(self, files: dict[str, str]) -> list[str]:
        """Findings in a tree that holds `files`: path -> what it includes."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, include in files.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(f"#pragma once\n#include {include}\n", encoding="utf-8")
            (root / "engine").mkdir(exist_ok=True)
            (root / "engine/CMakeLists.txt").write_text(CMAKE, encoding="utf-8")
            return check_layers.findings(root)

    def assert_found(self, file: str, include: str, reason: str) -> None:
        found = self.findings({file: include})
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{file}:2: "), found[0])
        self.assertIn(reason, found[0])

    def assert_clean(self, file: str, include: str) -> None:
        self.assertEqual(self.findings({file: include}), [])

    def test_engine_without_qt(self):
        for include in ("<QObject>", "<QtCore/QObject>", '"qpainter.h"', "<Qt>"):
            with self.subTest(include):
                self.assert_found("engine/cad2slam/geometry/pose2.h", include, "no Qt")

    def test_libraries_stay_in_their_module(self):
        for file, include, reason in (
            ("engine/cad2slam/map/map_frame.cpp", "<ceres/ceres.h>", "Ceres stays"),
            ("engine/cad2slam/projection/raster_warper.cpp", "<suitesparse/cholmod.h>", "CHOLMOD stays"),
            ("engine/cad2slam/mesh/mesh.cpp", "<Eigen/CholmodSupport>", "CHOLMOD stays"),
            ("engine/cad2slam/map/map_frame.cpp", "<yaml-cpp/yaml.h>", "yaml-cpp stays"),
            ("engine/cad2slam/solver/mesh_solver.cpp", "<nlohmann/json.hpp>", "nlohmann/json stays"),
            ("engine/cad2slam/io/map_file.h", "<yaml-cpp/yaml.h>", "public headers"),
        ):
            with self.subTest(file=file, include=include):
                self.assert_found(file, include, reason)
        self.assert_clean("engine/cad2slam/solver/mesh_solver.cpp", "<ceres/ceres.h>")
        self.assert_clean("engine/cad2slam/solver/mesh_solver.cpp", "<suitesparse/cholmod.h>")
        self.assert_clean("engine/cad2slam/io/map_file.cpp", "<yaml-cpp/yaml.h>")
        self.assert_clean("engine/cad2slam/io/project_file.cpp", "<nlohmann/json.hpp>")
        self.assert_clean("engine/cad2slam/map/occupancy_grid.h", "<opencv2/core/mat.hpp>")

    def test_order_of_the_modules(self):
        for file, include, reason in (
            ("engine/cad2slam/core/ids.h", '"cad2slam/geometry/pose2.h"', "core lies below geometry"),
            ("engine/cad2slam/mesh/mesh.h", '"cad2slam/solver/solution.h"', "mesh lies below solver"),
            ("engine/cad2slam/solver/mesh_solver.h", '"cad2slam/projection/projector.h"', "below projection"),
            ("engine/cad2slam/planning/path.h", '"cad2slam/simulation/scan.h"', "planning lies below simulation"),
            ("engine/cad2slam/map/map_frame.cpp", '"cad2slam/io/map_file.h"', "map lies below io"),
            ("engine/cad2slam/io/project_file.cpp", '"cad2slam/solver/mesh_solver.h"', "values only"),
            ("engine/cad2slam/io/map_file.cpp", '"cad2slam/projection/projector.h"', "values only"),
            ("engine/cad2slam/misc/helper.h", '"cad2slam/core/result.h"', "no place in the layers"),
        ):
            with self.subTest(file=file, include=include):
                self.assert_found(file, include, reason)
        self.assert_clean("engine/cad2slam/evaluation/scans.cpp", '"cad2slam/simulation/scan.h"')
        self.assert_clean("engine/cad2slam/io/project_file.h", '"cad2slam/solver/solver_settings.h"')
        self.assert_clean("engine/cad2slam/io/projector_file.h", '"cad2slam/projection/projector.h"')
        self.assert_clean("engine/cad2slam/solver/mesh_solver.cpp", "<Eigen/Core>")

    def test_robots_library_is_closed(self):
        self.assert_found("engine/cad2slam/projection/projector.h", "<opencv2/core.hpp>", "robots' library")
        self.assert_found("engine/cad2slam/io/projector_file.cpp", "<yaml-cpp/yaml.h>", "robots' library")
        self.assert_found("engine/cad2slam/projection/projector.h", '"cad2slam/mesh/mesh.h"', "holds everything")
        self.assert_found("engine/cad2slam/io/private.h", "<opencv2/core.hpp>", "robots' library")
        self.assert_clean("engine/cad2slam/io/projector_file.cpp", '"cad2slam/core/result.h"')
        self.assert_clean("engine/cad2slam/io/projector_file.cpp", '"cad2slam/io/private.h"')
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "engine").mkdir()
            (root / "engine/CMakeLists.txt").write_text("add_library(renamed)", encoding="utf-8")
            self.assertIn("no sources", check_layers.findings(root)[0])

    def test_desktop_app(self):
        for file, include, reason in (
            ("ui/panels/report_panel.cpp", "<ceres/ceres.h>", "never with Ceres"),
            ("ui/document/project_document.cpp", "<yaml-cpp/yaml.h>", "through the engine"),
            ("ui/document/project_document.cpp", "<nlohmann/json.hpp>", "through the engine"),
            ("ui/views/map_view.cpp", '"services/solve_service.h"', "start no work"),
            ("ui/views/map_view.h", '"ui/services/solve_service.h"', "start no work"),
            ("ui/models/anchor_table_model.cpp", '"ui/panels/anchor_panel.h"', "who shows"),
            ("ui/services/autosave.cpp", '"ui/main_window.h"', "neither panels nor windows"),
            ("app/gui_main.cpp", "<ceres/ceres.h>", "never with Ceres"),
            ("ui/main_window.cpp", '"app/version.h"', "no program"),
            ("engine/cad2slam/core/result.h", '"ui/convert.h"', "neither the desktop app"),
        ):
            with self.subTest(file=file, include=include):
                self.assert_found(file, include, reason)
        self.assert_clean("ui/views/map_view.h", "<QGraphicsView>")
        self.assert_clean("ui/services/solve_service.cpp", '"cad2slam/solver/mesh_solver.h"')
        self.assert_clean("app/cli_commands.cpp", "<nlohmann/json.hpp>")

    def test_include_spellings(self):
        for text in ('#  include "cad2slam/geometry/pose2.h"', '\t#include\t"cad2slam/geometry/pose2.h"  // why'):
            self.assertRegex(text, check_layers._INCLUDE)
        self.assertNotRegex('// #include "cad2slam/geometry/pose2.h"', check_layers._INCLUDE)


if __name__ == "__main__":
    unittest.main()
