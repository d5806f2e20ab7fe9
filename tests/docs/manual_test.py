#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Every command and every option that the program knows stands in its manual page, and none that it does not know.

usage: manual_test.py MANUAL PROGRAM
"""

import re
import subprocess
import sys
from pathlib import Path


def help_of(program: str, words: list[str]) -> str:
    return subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout


def walk(program: str, words: list[str], commands: set[str], options: set[str]) -> None:
    """Collects the command of `words` and all below it."""
    text = help_of(program, words)
    options.update(re.findall(r"^\s+(?:-\w,)?(--[a-z][a-z-]*)", text, re.MULTILINE))
    _, _, below = text.partition("Subcommands:\n")
    for name in re.findall(r"^  ([a-z][a-z0-9-]*)", below, re.MULTILINE):
        commands.add(name)
        walk(program, [*words, name], commands, options)


def main() -> int:
    manual = Path(sys.argv[1]).read_text(encoding="utf-8").replace("\\-", "-")
    commands: set[str] = set()
    options: set[str] = set()
    walk(sys.argv[2], [], commands, options)
    known = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", manual))
    described = set(re.findall(r"^\.BR? (.*)$", manual, re.MULTILINE))
    words = {word for line in described for word in re.findall(r"[a-z][a-z0-9-]*", line)}
    problems = [f"{name}: this command has no place in the manual" for name in sorted(commands - words)]
    problems += [f"{name}: this option has no place in the manual" for name in sorted(options - known - {"--output"})]
    problems += [f"{name}: the manual names an option that there is not" for name in sorted(known - options)]
    print("\n".join(problems) or f"{len(commands)} commands and {len(options)} options stand in the manual")
    return 1 if problems or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
