#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Checks which shared libraries a program needs, itself (--only) or through others as well (--never).

usage: check_linkage.py --only LIBRARY... -- PROGRAM
       check_linkage.py --never LIBRARY... -- PROGRAM
"""

import re
import subprocess
import sys


def directly_needed(program: str) -> set[str]:
    listing = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"\(NEEDED\).*\[(.+?)\.so", listing))


def needed_at_run_time(program: str) -> set[str]:
    listing = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"^\s*(?:\S*/)?([^/\s]+?)\.so", listing, re.MULTILINE))


def main() -> int:
    if len(sys.argv) < 4 or sys.argv[1] not in ("--only", "--never") or "--" not in sys.argv:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    middle = sys.argv.index("--")
    libraries, program = set(sys.argv[2:middle]), sys.argv[middle + 1]
    if sys.argv[1] == "--only":
        wrong = directly_needed(program) - libraries
    else:
        wrong = needed_at_run_time(program) & libraries
    for library in sorted(wrong):
        print(f"{program}: needs {library}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
