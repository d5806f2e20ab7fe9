#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Plants sentences in a small tree and expects each to be found that no pattern knows, and nothing else."""

import tempfile
import unittest
from pathlib import Path

import check_sentences

PATTERNS = '''
constexpr const char* kPatterns[] = {
    QT_TRANSLATE_NOOP("Engine", "the mesh has %1 centres for %2 tiles"),
    QT_TRANSLATE_NOOP("Engine",
                      "the mesh has no node, "
                      "so it is \\"empty\\""),
    QT_TRANSLATE_NOOP("Engine", "%1 must be a list"),
};
'''


class CheckSentencesTest(unittest.TestCase):
    def findings(self, files: dict[str, str]) -> list[str]:
        """Findings in a tree that holds `files`: path -> content."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, content in ({check_sentences.PATTERNS: PATTERNS} | files).items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(content, encoding="utf-8")
            return check_sentences.findings(root)

    def said(self, code: str) -> list[str]:
        return self.findings({"ui/a.cpp": code})

    def assert_clean(self, code: str) -> None:
        self.assertEqual(self.said(code), [])

    def assert_found(self, code: str, line: int, *shown: str) -> None:
        found = self.said(code)
        self.assertEqual(len(found), len(shown), found)
        for finding, text in zip(found, shown):
            self.assertTrue(finding.startswith(f"ui/a.cpp:{line}: "), finding)
            self.assertIn(text, finding)

    def test_known_sentences(self):
        self.assert_clean('return fail(kBad, "the mesh has " + text(n, 2) + " centres for " + m + " tiles", where);')
        self.assert_clean('return fail(ErrorCode::kBad, "the mesh has no node, "\n  "so it is \\"empty\\"");')
        self.assert_clean('item["id"].report("must be a list");')
        self.assert_clean('refuse("origin", "must be a list");')
        self.assert_clean('complaint_ = name + " must be a list";')
        self.assert_clean('// fail(kBad, "no sentence");\n/* fail(kBad, "none") */')
        self.assert_clean('return fail(kBad, ": " + read.error().message, place);')
        self.assert_clean('tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string where = {});')
        self.assert_clean("struct Error {\n  ErrorCode code = ErrorCode::kBad;\n  std::string message;\n};")

    def test_unknown_sentences(self):
        self.assert_found('\nreturn fail(kBad, "the mesh has " + n + " edges");', 2, '"the mesh has ... edges"')
        self.assert_found('fail(kBad,\n  "the mesh has no node");', 1, '"the mesh has no node"')
        self.assert_found('fail(kBad, "tiles for " + n + " the mesh has " + m);', 1, "tiles for")
        self.assert_found('fail(kBad, "he said \\"no\\" to, (this");', 1, 'he said "no" to, (this')
        self.assert_found('show({ErrorCode::kBad, "no sentence", path});', 1, "no sentence")
        self.assert_found('error_ = Error{ErrorCode::kBad, "no sentence", path};', 1, "no sentence")
        self.assert_found('warnings.push_back(std::to_string(n) + " of them");', 1, '"... of them"')
        self.assert_found('import.rejected.push_back({line, "no point"});', 1, "no point")
        self.assert_found('throw YamlRefusal{line, "no word"};', 1, "no word")
        self.assert_found('return tl::unexpected(std::string("no number"));', 1, "no number")
        self.assert_found('reader.report("must be a thing");', 1, "must be a thing")
        self.assert_found('constexpr char kNone[] =\n    "nobody there";\nwarnings.emplace_back(kNone);', 3, "nobody there")
        self.assert_found('std::string ahead() {\n  return end ? "the end" : excerpt(text);\n}', 2, "the end")

    def test_each_way_of_a_condition(self):
        self.assert_found('fail(kBad, big ? "the mesh has no node" : small ? "is \'no\'" : name + " must be a list");',
                          1, '"the mesh has no node"', "\"is 'no'\"")
        self.assert_found('fail(kBad, (big ? "big" : name) + " must be a thing");', 1, "big must be", "... must be")
        self.assert_clean('fail(kBad, std::string(big ? "big" : "small") + " must be a list");')

    def test_texts_from_elsewhere(self):
        self.assert_found("return fail(kBad, text, path);", 1, "comes from elsewhere")
        self.assert_found("return fail(kBad, makeText(name), path);", 1, "comes from elsewhere")
        self.assert_clean("return fail(kBad, std::move(message), path);")
        self.assert_clean("return fail(kBad, failure->what());")

    def test_only_what_the_app_uses(self):
        unknown = 'void f() { fail(kBad, "no sentence"); }\n'
        used = {"ui/a.cpp": '#include "cad2slam/io/a.h"\n', "engine/cad2slam/io/a.h": '#include "cad2slam/map/b.h"\n',
                "engine/cad2slam/map/b.h": "#pragma once\n"}
        for name, code, found in (
            ("engine/cad2slam/io/a.cpp", unknown, True),
            ("engine/cad2slam/map/b.cpp", unknown, True),
            ("engine/cad2slam/io/other.cpp", '#include "cad2slam/io/a.h"\n' + unknown, True),
            ("engine/cad2slam/map/other.cpp", '#include "cad2slam/io/a.h"\n' + unknown, False),
            ("engine/cad2slam/exports/c.cpp", '#include "cad2slam/io/a.h"\n' + unknown, False),
        ):
            with self.subTest(name):
                self.assertEqual(len(self.findings(used | {name: code})), found)


if __name__ == "__main__":
    unittest.main()
