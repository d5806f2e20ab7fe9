#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/evaluation.md from runs of `cad2slam-cli evaluate`.

usage: make_evaluation.py CLI [--paper-data FOLDER] [--random-sites N] [-o FILE]

CLI is the built cad2slam-cli. The maps of the paper's authors are used where FOLDER holds them; they are not part of
this repository. Takes some minutes; nothing else should run meanwhile, as it also measures speed.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

METHODS = [
    ("similarity", "similarity"),
    ("affine", "affine"),
    ("thin_plate_spline", "thin-plate spline"),
    ("rigid", "rigid, scale 1 (paper)"),
    ("rigid_scaled", "rigid, scale auto"),
    ("stretch", "**stretch (ours)**"),
]
PAPER_SITES = [("demo", "DEMO"), ("diag", "DIAG"), ("eiii-0", "EIII-0")]
# The paper's table III at a threshold of 0.1 m: mean distance [m], outliers.
PAPER_SCANS = {"demo": (0.0638, 245), "diag": (0.0595, 278), "eiii-0": (0.0634, 278)}
# The paper's table IV: variables, construction [ms], optimisation [ms], projection [us] (i7-9700).
PAPER_SPEED = {
    "demo": (1442, 13.975, 86.960, 42.9),
    "diag": (2534, 72.910, 155.14, 64.7),
    "eiii-0": (715, 29.557, 29.338, 18.9),
}
SAMPLE_SITES = [("office", "1"), ("office", "2"), ("corridor", "1"), ("corridor", "2"), ("warehouse", "1"), ("warehouse", "2")]
UNKNOWN_SCALE = {"warehouse"}


class Runner:
    def __init__(self, cli: str) -> None:
        self.cli = cli

    def __call__(self, part: str, *options: str) -> dict:
        command = [self.cli, "evaluate", part, *options, "--json"]
        print(" ".join(command), file=sys.stderr)
        done = subprocess.run(command, check=False, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr.strip())
        return json.loads(done.stdout)


def paper_site(folder: Path, site: str) -> list[str]:
    base = folder / site
    return ["--blueprint", f"{base}/blueprint.yaml", "--slam", f"{base}/slam.yaml", "--anchors", f"{base}/anchors.csv"]


def sample_site(site: str, number: str) -> list[str]:
    base = ROOT / "sample_maps" / site
    options = ["--blueprint", f"{base}/blueprint.yaml", "--slam", f"{base}/slam_{number}.yaml"]
    options += ["--anchors", f"{base}/anchors_{number}.csv"]
    return options + (["--scale", "unknown"] if site in UNKNOWN_SCALE else [])


def number(value, digits: int = 3) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def table(header: list[str], rows: list[list[str]]) -> str:
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def best_marked(columns: list[list]) -> list[list[str]]:
    """Cells of a table by column, the least number of each column set in bold."""
    marked = []
    for column in columns:
        known = [value for value in column if value is not None]
        best = min(known) if known else None
        marked.append([f"**{number(value)}**" if value == best else number(value) for value in column])
    return marked


def method_table(columns: dict[str, dict]) -> str:
    """One row for each method, one column for each `methods` object."""
    cells = best_marked([[methods.get(key, {}).get("mean") for key, _ in METHODS] for methods in columns.values()])
    rows = [[label, *[column[i] for column in cells]] for i, (_, label) in enumerate(METHODS)]
    return table(["mean error, m", *columns], rows)


def real_buildings(run: Runner, folder: Path) -> str:
    columns = {}
    for site, name in PAPER_SITES:
        options = paper_site(folder, site)
        columns[f"{name} loo"] = run("loo", *options)["methods"]
        for size, result in run("curve", *options, "--draws", "20")["sizes"].items():
            columns[f"{name} {size}"] = result["methods"]
    text = "## Real buildings: error at anchors that were not used\n\n"
    text += "`loo` leaves one anchor out at a time; the numbers are anchors used, 20 random draws each (`--seed 1`).\n"
    text += "DEMO is the paper's synthetic map.\n\n"
    for site, name in PAPER_SITES:
        part = {key: value for key, value in columns.items() if key.startswith(name + " ")}
        text += method_table(part) + "\n"
    return text


def scans(run: Runner, folder: Path) -> str:
    rows = []
    for site, name in PAPER_SITES:
        result = run("scans", *paper_site(folder, site), "--paths", f"{folder}/{site}/paths.csv")
        for entry in result["thresholds"]:
            is_compared = abs(entry["threshold_m"] - 0.1) < 1e-9
            paper_mean, paper_outliers = PAPER_SCANS[site] if is_compared else (None, None)
            rows.append(
                [
                    name,
                    f"{entry['threshold_m']:g}",
                    number(entry["mean_m"], 4),
                    number(entry["deviation_m"], 4),
                    number(entry["outliers"], 0),
                    number(result["beams_without_hit"], 0),
                    number(paper_mean, 4),
                    number(paper_outliers, 0),
                ]
            )
    text = "## Scans along the authors' paths (the paper's table III)\n\n"
    text += (
        "360 beams, range 20 m. Each hit of the scan that is simulated in the blueprint is projected and compared with the\n"
        "nearest hit of the scan that is simulated in the SLAM map. A hit without a counterpart within the threshold is an\n"
        "outlier; beams that meet nothing in the blueprint make no hit and are counted on their own. The mean is that of the\n"
        "scans' means over their inliers, as is the deviation. The paper does not say how it treats beams without a hit.\n\n"
    )
    header = ["site", "threshold m", "mean m", "deviation m", "outliers", "no hit", "paper: mean m", "paper: outliers"]
    return text + table(header, rows) + "\n"


def speed(run: Runner, folder: Path) -> str:
    rows = []
    for site, name in PAPER_SITES:
        result = run("speed", *paper_site(folder, site))
        variables, construction, optimisation, projection = PAPER_SPEED[site]
        rows.append(
            [
                name,
                f"{result['nodes']} ({variables})",
                f"{number(result['construction_ms']['mean'], 1)} ({construction:.1f})",
                f"{number(result['optimisation_ms']['median'], 0)} ({optimisation:.0f})",
                number(result["after_an_edit_ms"]["median"], 0),
                f"{number(result['projection_us']['median'])} ({projection:.1f})",
                number(result["inverse_us"]["median"]),
                number(result["batch_projections_per_s"] / 1e6, 1),
            ]
        )
    text = "## Speed (the paper's table IV)\n\n"
    text += f"On {os.cpu_count()} cores of a {platform.machine()} server; in brackets the paper's figures (i7-9700, rigid model).\n\n"
    header = ["site", "nodes", "construction ms", "optimisation ms", "after an edit ms", "projection us", "inverse us", "batch M/s"]
    return text + table(header, rows) + "\n"


def known_truth(run: Runner) -> str:
    columns = {}
    for site, index in SAMPLE_SITES:
        options = sample_site(site, index)
        truth = ROOT / "sample_maps" / site / f"truth_{index}.yaml"
        columns[f"{site} {index}"] = run("truth", *options, "--truth", str(truth))["methods"]
    text = "## Sample sites: true error\n\n"
    text += "Over the whole free space, with 30 clicked anchors. See `sample_maps/README.md` for what these sites are.\n\n"
    return text + method_table(columns) + "\n"


def random_sites(run: Runner, count: int) -> str:
    text = f"## {count} random sites: true error\n\n"
    text += (
        "Flats, offices, corridors and halls of 8 to 120 m with 4 to 60 anchors in all layouts (seeds from 1). The ratio\n"
        "compares with the best of all methods but ours, chosen afresh for each site by its truth, which no user can do.\n\n"
    )
    result = run("sites", "--count", str(count))["methods"]
    rows = [
        [
            label,
            number(result[key]["geometric_mean_m"], 4),
            number(result[key]["ratio_to_best"]),
            f"{100 * result[key]['share_within_5_percent']:.0f} %",
        ]
        for key, label in METHODS
    ]
    return text + table(["method", "geometric mean, m", "ratio to the best of the others", "within 5 % of it"], rows) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("--paper-data", type=Path, default=ROOT.parent / "shared" / "data" / "cad2slam")
    parser.add_argument("--random-sites", type=int, default=200)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "evaluation.md")
    options = parser.parse_args()
    run = Runner(options.cli)
    text = "# Evaluation\n\nWritten by `docs/make_evaluation.py`; run it again rather than edit this page. Bold is best.\n\n"
    text += known_truth(run) + random_sites(run, options.random_sites)
    if options.paper_data.is_dir():
        text += real_buildings(run, options.paper_data) + scans(run, options.paper_data) + speed(run, options.paper_data)
    else:
        print(f"{options.paper_data} is absent: the tables of the real buildings are left out", file=sys.stderr)
    options.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
