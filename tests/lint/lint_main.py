# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""What the checks of this folder do when they are called by hand, by .ci/check or by ctest."""

import sys
from pathlib import Path
from typing import Callable


def run(findings: Callable[[Path], list[str]], all_well: str,
        warnings: Callable[[Path], list[str]] = lambda root: []) -> int:
    """Prints one line per warning and finding of the tree that is named, or of this one; exit code 1 if any finding."""
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    found = findings(root)
    print("\n".join([f"warning: {line}" for line in warnings(root)] + found) or all_well)
    return 1 if found else 0
