#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Plants one fault at a time and expects it to be found."""

import tempfile
import unittest
from pathlib import Path

import check_files

CPP_HEAD = "".join(f"// {line}\n" for line in check_files.SPDX)
HASH_HEAD = "".join(f"# {line}\n" for line in check_files.SPDX)


class CheckFilesTest(unittest.TestCase):
    def assert_found(self, name: str, text: str, reason: str) -> None:
        found = check_files.file_findings(name, text)
        self.assertEqual(len(found), 1, found)
        self.assertIn(reason, found[0])

    def test_good_files(self):
        self.assertEqual(check_files.file_findings("engine/a.h", CPP_HEAD + "#pragma once\n"), [])
        self.assertEqual(check_files.file_findings("engine/a.cpp", CPP_HEAD + "\nint a;\n" * 200), [])
        self.assertEqual(check_files.file_findings("packaging/a.sh", "#!/bin/sh\n" + HASH_HEAD), [])

    def test_faults(self):
        self.assert_found("engine/a.cpp", "int a;\n", "SPDX")
        self.assert_found("engine/a.cpp", "\n", "SPDX")
        self.assert_found("engine/a.h", CPP_HEAD, "#pragma once")
        self.assert_found("engine/a.cpp", CPP_HEAD + "int a;\n" * 499, "501 lines")
        self.assert_found("engine/a.cpp", CPP_HEAD + "int a;", "line end")
        self.assert_found("engine/a.cpp", CPP_HEAD + "int a;\n\n", "line end")
        self.assert_found("engine/a.cpp", CPP_HEAD + "int a; \n", "trailing")
        self.assert_found("engine/a.cpp", CPP_HEAD + "// TODO later\n", "finish it")
        self.assert_found("engine/a.cpp", CPP_HEAD + 'auto p = "/home/me/map.yaml";\n', "one machine")
        self.assert_found("CMakeLists.txt", HASH_HEAD + "add_compile_options(-march=native)\n", "AVX")
        self.assert_found("ui/CMakeLists.txt", HASH_HEAD + "file(GLOB sources *.cpp)\n", "globbed")
        self.assert_found("ui/a.cpp", CPP_HEAD + "<<<<<<< HEAD\n", "merge marker")

    def test_every_source_has_a_test(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name in ("engine/cad2slam/map/a.cpp", "engine/cad2slam/map/b.cpp", "tests/engine/map/a_test.cpp"):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(CPP_HEAD, encoding="utf-8")
            self.assertEqual(check_files.untested(root),
                             ["engine/cad2slam/map/b.cpp:1: has no tests/engine/map/b_test.cpp"])
            (root / "tests/lint").mkdir()
            accepted = root / "tests/lint/untested.txt"
            accepted.write_text("# reasons\nmap/b  # values only\n", encoding="utf-8")
            self.assertEqual(check_files.untested(root), [])
            accepted.write_text("map/b\nmap/gone\n", encoding="utf-8")
            self.assertEqual(len(check_files.untested(root)), 1)


if __name__ == "__main__":
    unittest.main()
