# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Projector files made in Python, independently of the engine, for tests."""

import hashlib
import json
from typing import Any

import numpy as np

TYPES = {"f": "F64", "i": "I32", "u": "U32"}


def frame_metadata(name: str) -> dict[str, str]:
    return {f"{name}_name": name, f"{name}_resolution_m_per_px": "0.05", f"{name}_width_px": "400",
            f"{name}_height_px": "300", f"{name}_origin_x_m": "0", f"{name}_origin_y_m": "0",
            f"{name}_origin_heading_rad": "0"}


def metadata(**changes: Any) -> dict[str, str]:
    """Of a stretch projector on cells of 0.5 m; keyword arguments replace values, None leaves one out."""
    values = {"format": "cad2slam-projector", "version": "1.0", "model": "stretch", "scale": "1", "weights": "smooth",
              "radius_m": "2", "outside": "error", "cell_size_m": "0.5", "lattice_x_m": "1", "lattice_y_m": "-2",
              "lattice_heading_rad": "0.3", "quality_anchors_used": "0", "quality_folded_tiles": "0",
              **frame_metadata("blueprint"), **frame_metadata("slam"), **changes}
    return {key: str(value) for key, value in values.items() if value is not None}


def seal(header: dict[str, Any], data: bytes) -> dict[str, Any]:
    values = {key: text for key, text in header["__metadata__"].items() if key != "header_sha256"}
    values["data_sha256"] = hashlib.sha256(data).hexdigest()
    header = {**header, "__metadata__": values}
    text = json.dumps(header, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    values["header_sha256"] = hashlib.sha256(text.encode()).hexdigest()
    return header


def file_of(header: dict[str, Any], data: bytes) -> bytes:
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-(8 + len(text)) % 64)
    return len(text).to_bytes(8, "little") + text + data


def content_of(arrays: dict[str, np.ndarray], values: dict[str, str]) -> tuple[dict[str, Any], bytes]:
    """Sealed header and data section."""
    header: dict[str, Any] = {"__metadata__": values}
    data = b""
    for name, array in arrays.items():
        part = np.ascontiguousarray(array)
        header[name] = {"dtype": TYPES[part.dtype.kind], "shape": list(part.shape),
                        "data_offsets": [len(data), len(data) + part.nbytes]}
        data += part.tobytes()
    return seal(header, data), data


def lattice_places(values: dict[str, str], cells: np.ndarray) -> np.ndarray:
    cell, heading = float(values["cell_size_m"]), float(values["lattice_heading_rad"])
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    return cells * cell @ turn.T + [float(values["lattice_x_m"]), float(values["lattice_y_m"])]


def bend(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A smooth bend of the plane and how it turns."""
    x, y = points.T
    turn = 2.9 + 0.02 * x
    place = np.column_stack([-0.97 * x - 0.24 * y + 0.3 * np.sin(0.2 * y), 0.24 * x - 0.97 * y + 0.4 * np.cos(0.15 * x)])
    return place, turn


def corridor(length: int = 24, **changes: Any) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """A U-shaped corridor, three tiles wide, under bend(); arrays and metadata."""
    values = metadata(**changes)
    tiles = [(c, r) for c in range(length) for r in range(length)
             if r < 3 or c < 3 or c >= length - 3]
    tile = np.array(tiles, np.int32)
    center = lattice_places(values, tile + 0.5)
    place, turn = bend(center)
    number = {place_: k for k, place_ in enumerate(tiles)}
    edges = [(k, number[n]) for (c, r), k in number.items() for n in ((c + 1, r), (c, r + 1)) if n in number]
    stretch = np.column_stack([0.05 * np.sin(center[:, 0]), 0.05 * np.cos(center[:, 1])])
    if values["model"] == "rigid":
        stretch *= 0.0
    arrays = {"node_blueprint": center, "node_slam": np.column_stack([place, turn]), "node_stretch": stretch,
              "node_tile": tile, "edges": np.array(edges, np.uint32).reshape(-1, 2),
              "anchors": np.array([[1.0, 2.0, 3.0, 4.0]]), "check_poses": np.zeros((0, 6))}
    return arrays, values


def block(columns: int, rows: int, **changes: Any) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """A full rectangle of tiles under bend(), fast to make for any size."""
    values = metadata(**changes)
    tile = np.stack(np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij"), axis=-1).reshape(-1, 2)
    center = lattice_places(values, tile + 0.5)
    place, turn = bend(center * min(1.0, 40.0 / max(columns, rows)))
    place *= max(1.0, max(columns, rows) / 40.0)
    arrays = {"node_blueprint": center, "node_slam": np.column_stack([place, turn]),
              "node_stretch": np.zeros_like(center), "node_tile": tile.astype(np.int32),
              "edges": np.zeros((0, 2), np.uint32), "anchors": np.zeros((0, 4)), "check_poses": np.zeros((0, 6))}
    return arrays, values


def random_poses(arrays: dict[str, np.ndarray], values: dict[str, str], count: int, seed: int = 1) -> np.ndarray:
    """Poses on the tiles."""
    random = np.random.default_rng(seed)
    node = random.integers(len(arrays["node_tile"]), size=count)
    place = lattice_places(values, arrays["node_tile"][node] + random.random((count, 2)))
    return np.column_stack([place, random.uniform(-np.pi, np.pi, count)])
