#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Checks which shared libraries a program needs, itself (--only) or through others as well (--never), and its size.

usage: check_linkage.py --only LIBRARY... [--smaller BYTES] -- PROGRAM
       check_linkage.py --never LIBRARY... -- PROGRAM
"""

import os
import re
import subprocess
import sys


def directly_needed(program: str) -> set[str]:
    listing = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True).stdout
    names = set(re.findall(r"\(NEEDED\).*\[(.+?)\.so", listing))
    return {name for name in names if not name.startswith("ld-")}  # the loader itself


def needed_at_run_time(program: str) -> set[str]:
    listing = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"^\s*(?:\S*/)?([^/\s]+?)\.so", listing, re.MULTILINE))


def main() -> int:
    if len(sys.argv) < 4 or sys.argv[1] not in ("--only", "--never") or "--" not in sys.argv:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    middle = sys.argv.index("--")
    libraries, program = sys.argv[2:middle], sys.argv[middle + 1]
    limit = None
    if "--smaller" in libraries:
        place = libraries.index("--smaller")
        limit = int(libraries[place + 1])
        libraries = libraries[:place]
    if sys.argv[1] == "--only":
        wrong = directly_needed(program) - set(libraries)
    else:
        wrong = needed_at_run_time(program) & set(libraries)
    for library in sorted(wrong):
        print(f"{program}: needs {library}")
    too_large = limit is not None and os.path.getsize(program) >= limit
    if too_large:
        print(f"{program}: has {os.path.getsize(program)} bytes, not less than {limit}")
    return 1 if wrong or too_large else 0


if __name__ == "__main__":
    sys.exit(main())
