# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Reads projector files (.c2s) of CAD2SLAM and projects poses between blueprint and SLAM map. Needs only numpy.

    import cad2slam

    projector = cad2slam.load("office.c2s")
    goals = projector.slam_from_blueprint([[12.5, 7.25, 0.0], [3.0, 4.0, 1.57]])
    if goals.ok.all():
        drive(goals.poses)  # x, y [m], heading [rad] in the SLAM map

Poses are metres and radians, counter-clockwise. Any number of them is projected at once; answers are the same as those
of the C++ library to 1e-9. load() takes the C library where it is installed; this file alone is enough without it.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import stat
from contextlib import contextmanager
from enum import IntEnum
from typing import Any, Callable, Iterator, Mapping, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Numbers = NDArray[np.int64]
Flags = NDArray[np.bool_]

_LARGEST_HEADER = 1 << 20
_LARGEST_PREFIX = 8 + _LARGEST_HEADER  # bytes of any file that hold all of its header
_LARGEST_TILE = 1e9
_LARGEST_STRETCH = 5.0
_CHUNK = 1 << 14  # poses; what is computed for them stays in the cache
_TYPE_BYTES = {"BOOL": 1, "U8": 1, "I8": 1, "I16": 2, "U16": 2, "F16": 2, "BF16": 2, "I32": 4, "U32": 4, "F32": 4,
               "I64": 8, "U64": 8, "F64": 8}
_ARRAYS = {"node_blueprint": ("F64", 2), "node_slam": ("F64", 3), "node_stretch": ("F64", 2), "node_tile": ("I32", 2),
           "edges": ("U32", 2), "anchors": ("F64", 4), "check_poses": ("F64", 6)}
_DTYPES = {"F64": "<f8", "I32": "<i4", "U32": "<u4"}


class ProjectorError(ValueError):
    """A file that is no projector, or a damaged one. The text is one sentence that names the file."""


class Status(IntEnum):
    """Says for each answer what it is worth."""

    INSIDE = 0  # the query lies on a tile of the mesh
    EXTRAPOLATED = 1  # beyond the mesh, answered rigidly because the caller asked for it
    OUTSIDE = 2  # beyond the mesh and not answered
    FOLDED = 3  # the mesh folds or overlaps here: there is no unique answer
    INVALID = 4  # the query is not finite


class Projections(NamedTuple):
    """Answers, in the order of the queries. Poses without an answer are NaN."""

    poses: Floats  # [..., 3]: x, y [m], heading [rad] in [-pi, pi)
    status: NDArray[np.uint8]  # [...], of Status

    @property
    def ok(self) -> Flags:
        return self.status <= Status.EXTRAPOLATED


def load(path: str | os.PathLike[str], *, native: bool | None = None) -> Projector:
    """Opens a projector file, checks all of it and raises ProjectorError or OSError.

    native: True demands the C library, False this file's own code; None takes the C library where there is one.
    """
    if native is not False:
        try:
            import cad2slam_native
            return cad2slam_native.NativeProjector(path)
        except ImportError:
            if native:
                raise
    return Projector(*read(path), os.fspath(path))


# --- The file -------------------------------------------------------------------------------------------------------


def read(path: str | os.PathLike[str]) -> tuple[dict[str, str], dict[str, NDArray[Any]]]:
    """Metadata and arrays of a projector file, after all checks that need no projecting."""
    name = os.fspath(path)
    with open(path, "rb", opener=_open_at_once) as file:
        about = os.fstat(file.fileno())
        if not stat.S_ISREG(about.st_mode):
            raise ProjectorError(f"{name}: is no regular file")
        start = file.read(_LARGEST_PREFIX)
        if about.st_size > len(start):  # a large file that is none of ours is refused before it is read
            with _naming(name):
                _header_of(start, about.st_size)
        return parse(start + file.read(), name)


def parse(content: bytes, name: str) -> tuple[dict[str, str], dict[str, NDArray[Any]]]:
    """As read(), for bytes that are in memory."""
    with _naming(name):
        header, begin = _header_of(content, len(content))
        return _metadata_of(header), _arrays_of(header, content[begin:])


def _open_at_once(path: str, flags: int) -> int:
    """Without waiting for somebody to write, as opening a pipe would."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


@contextmanager
def _naming(file: str) -> Iterator[None]:
    try:
        yield
    except ProjectorError as error:
        raise ProjectorError(f"{file}: {error}") from None


def _require(holds: Any, complaint: str) -> None:
    if not holds:
        raise ProjectorError(complaint)


def _distinct(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    _require(len(dict(pairs)) == len(pairs), "has a name twice in its header")
    return dict(pairs)


def _header_of(start: bytes, size: int) -> tuple[dict[str, Any], int]:
    """Header of any safetensors file of `size` bytes, and where its data section begins."""
    _require(len(start) >= 8, f"is no projector file: it has only {len(start)} bytes")
    length = int.from_bytes(start[:8], "little")
    _require(length <= _LARGEST_HEADER, "is no projector file: its header would be too long")
    _require(length <= len(start) - 8, "is cut off inside its header")
    try:
        header = json.loads(start[8:8 + length].decode("utf-8"), object_pairs_hook=_distinct, parse_float=_no_number,
                            parse_constant=_no_number)
    except ProjectorError:
        raise
    except (ValueError, RecursionError):
        raise ProjectorError("has a header that is not valid JSON") from None
    _require(isinstance(header, dict), "has a header that is no JSON object")
    data_bytes = size - 8 - length
    ranges = []
    for name, entry in header.items():
        if name != "__metadata__":
            ranges.append(_range_of(name, entry))
    covered = 0
    for begin, end in sorted(ranges):
        _require(begin == covered, f"has arrays that overlap or leave a gap at byte {covered}")
        covered = end
    _require(covered <= data_bytes, f"is cut off: {covered - data_bytes} bytes are missing")
    _require(covered == data_bytes, f"has {data_bytes - covered} bytes too many")
    return header, 8 + length


def _no_number(text: str) -> Any:
    raise ProjectorError(f"has a number {text[:40]} in its header that is not whole")


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 1 << 64


def _range_of(name: str, entry: Any) -> tuple[int, int]:
    fits = (isinstance(entry, dict) and set(entry) == {"dtype", "shape", "data_offsets"}
            and all(isinstance(entry[key], list) and all(map(_is_count, entry[key])) for key in ("shape", "data_offsets"))
            and len(entry["data_offsets"]) == 2)
    _require(fits, f"does not say dtype, shape and data_offsets of {name[:40]!r}")
    _require(isinstance(entry["dtype"], str) and entry["dtype"] in _TYPE_BYTES,
             f"has an array of unknown type: {name[:40]!r}")
    begin, end = entry["data_offsets"]
    _require(end - begin == math.prod(entry["shape"]) * _TYPE_BYTES[entry["dtype"]],
             f"has an array whose range does not fit its shape: {name[:40]!r}")
    return begin, end


def _metadata_of(header: dict[str, Any]) -> dict[str, str]:
    metadata = header.get("__metadata__")
    _require(isinstance(metadata, dict) and all(isinstance(value, str) for value in metadata.values()),
             "has no metadata that are all texts")
    _require(metadata.get("format") == "cad2slam-projector", "is not a projector file of CAD2SLAM")
    version = metadata.get("version", "")
    _require(version.split(".")[0] == "1", f"has format version {version[:40]!r}; this program reads 1.x")
    unsealed = {**header, "__metadata__": {key: text for key, text in metadata.items() if key != "header_sha256"}}
    try:
        canonical = json.dumps(unsealed, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode("utf-8")
    except UnicodeEncodeError:
        raise ProjectorError("has a header that is not valid JSON") from None
    _require(metadata.get("header_sha256") == hashlib.sha256(canonical).hexdigest(),
             "is damaged: its header was changed")
    return metadata


def _arrays_of(header: dict[str, Any], data: bytes) -> dict[str, NDArray[Any]]:
    _require(header["__metadata__"].get("data_sha256") == hashlib.sha256(data).hexdigest(),
             "is damaged: its data do not have the SHA-256 they should")
    arrays: dict[str, NDArray[Any]] = {}
    for name, (dtype, columns) in _ARRAYS.items():
        entry = header.get(name)
        _require(entry is not None, f"has no array {name}")
        _require(entry["dtype"] == dtype and len(entry["shape"]) == 2 and entry["shape"][1] == columns,
                 f"has an array {name} that is not {dtype} in {columns} columns")
        begin, end = entry["data_offsets"]
        arrays[name] = np.frombuffer(data[begin:end], _DTYPES[dtype]).reshape(entry["shape"])
        _require(dtype != "F64" or np.isfinite(arrays[name]).all(), f"has an array {name} that is not finite")
    nodes = len(arrays["node_blueprint"])
    _require(nodes > 0, "has no node")
    _require(all(len(arrays[name]) == nodes for name in ("node_slam", "node_stretch", "node_tile")),
             "has node arrays of different lengths")
    _require((arrays["edges"] < nodes).all(), "has an edge to a node that does not exist")
    return arrays


# --- Finding nodes --------------------------------------------------------------------------------------------------


def _keys_of(places: Floats) -> Numbers:
    """One number for each (column, row); what lies outside any building is where no tile can be."""
    limit = _LARGEST_TILE + 1.0
    column, row = (np.clip(places, -limit, limit) + limit).astype(np.int64)
    return (column << 32) | row


class _TileTable:
    """Finds the node of a tile: in a table of the whole lattice, or by sorting where tiles lie far apart."""

    def __init__(self, tiles: Floats) -> None:
        self.count = tiles.shape[1]
        keys = _keys_of(tiles)
        self._order = np.append(np.argsort(keys), self.count)
        self._keys = keys[self._order[:-1]]
        self.has_twice = bool((self._keys[1:] == self._keys[:-1]).any())
        self._first = tiles.min(axis=1) - 1.0  # with an empty tile all around
        self._last = tiles.max(axis=1) + 1.0 - self._first
        self._table: NDArray[np.int32] | None = None
        if (self._last + 1.0).prod() <= 32 * self.count + 65536:
            table = np.full((self._last + 1.0).astype(np.int64), self.count, np.int32)
            table[tuple((tiles - self._first[:, None]).astype(np.int64))] = np.arange(self.count)
            self._table = table.ravel()

    def find(self, column: NDArray[Any], row: NDArray[Any]) -> NDArray[Any]:
        """Nodes, or `count` where there is none. Takes whole numbers of any size in floats."""
        if self._table is not None:
            x = np.clip(column - self._first[0], 0.0, self._last[0])
            y = np.clip(row - self._first[1], 0.0, self._last[1])
            return self._table.take((x * (self._last[1] + 1.0) + y).astype(np.int64), mode="clip")
        keys = _keys_of(np.stack([column, row]))
        place = np.searchsorted(self._keys, keys)
        place[self._keys.take(place, mode="clip") != keys] = self.count
        return self._order[place]


class _Seeds:
    """Nodes near a place of the SLAM frame, sorted into square buckets."""

    def __init__(self, positions: Floats, bucket: float) -> None:
        self._bucket = bucket
        keys = _keys_of(np.floor(positions / bucket))
        self._nodes = np.argsort(keys, kind="stable")
        self._keys = keys[self._nodes]
        self._places = positions[:, self._nodes].astype(np.float32).astype(np.float64)

    def nearest(self, target: Floats) -> Numbers:
        """[m, 8]: of the four buckets whose common corner is nearest to each target, at most 8 nodes, nearest first;
        -1 where there are fewer."""
        corner = np.floor(target / self._bucket - 0.5)
        keys = np.stack([_keys_of(corner + [[dx], [dy]]) for dy in (0, 1) for dx in (0, 1)], axis=1).ravel()
        begin = np.searchsorted(self._keys, keys)
        counts = np.searchsorted(self._keys, keys, side="right") - begin
        query = np.repeat(np.arange(len(keys)) // 4, counts)
        entry = np.arange(len(query)) - np.repeat(np.cumsum(counts) - counts - begin, counts)
        squared = ((self._places[:, entry] - target[:, query])**2).sum(axis=0)
        close = np.flatnonzero(squared <= 2.25 * self._bucket**2)
        close = close[np.lexsort((squared[close], query[close]))]
        query = query[close]
        rank = np.arange(len(query)) - np.searchsorted(query, query)
        found = np.full((target.shape[1], 8), -1, np.int64)
        found[query[rank < 8], rank[rank < 8]] = self._nodes[entry[close[rank < 8]]]
        return found

    def nearest_of_all(self, target: Floats) -> Numbers:
        """Linear in the number of nodes."""
        squared = (((self._places - place[:, None])**2).sum(axis=0) for place in target.T)
        return self._nodes[np.array([np.argmin(row) for row in squared], np.int64)]


# --- The function ---------------------------------------------------------------------------------------------------


class _Blend(NamedTuple):
    """The forward function at m places."""

    position: Floats  # [2, m]
    linear: Floats  # [4, m], row by row: turns headings
    jacobian: Floats  # [4, m]: derivative of the position


def _determinant(matrix: Floats) -> Floats:
    return matrix[0] * matrix[3] - matrix[1] * matrix[2]


def _solve(matrix: Floats, vector: Floats) -> Floats:
    scale = 1.0 / _determinant(matrix)
    return np.stack([(matrix[3] * vector[0] - matrix[1] * vector[1]) * scale,
                     (matrix[0] * vector[1] - matrix[2] * vector[0]) * scale])


def _times(matrix: Floats, vector: Floats) -> Floats:
    return np.stack([matrix[0] * vector[0] + matrix[1] * vector[1], matrix[2] * vector[0] + matrix[3] * vector[1]])


def _heading_of(direction: Floats) -> Floats:
    heading = np.arctan2(direction[1], direction[0])
    return np.where(heading >= np.pi, -np.pi, heading)


def _direction_of(heading: Floats) -> Floats:
    return np.stack([np.cos(heading), np.sin(heading)])


def _number(metadata: Mapping[str, str], key: str) -> float:
    text = metadata.get(key, "")
    try:
        value = float(text) if text.strip("+-.0123456789eE") == "" else math.nan
    except ValueError:
        value = math.nan
    _require(math.isfinite(value), f"has metadata {key} that are no finite number: {text[:40]!r}")
    return value


class Projector:
    """Takes poses from the blueprint frame to the SLAM frame and back. Never changes: share it between threads.

    Both directions take an array of poses [..., 3] (x, y, heading) or places [..., 2] (heading 0).
    outside: "error" or "rigid" says what queries beyond the mesh become; None takes what the file says.
    """

    def __init__(self, metadata: Mapping[str, str], arrays: Mapping[str, NDArray[Any]], name: str = "projector") -> None:
        self.metadata = dict(metadata)
        self.arrays = dict(arrays)
        try:
            with np.errstate(all="ignore"):
                self._build()
                self._prove_itself()
        except ProjectorError as error:
            raise ProjectorError(f"{name}: {error}") from None

    @property
    def outside(self) -> str:
        """What the file says of queries beyond the mesh: "error" or "rigid"."""
        return self.metadata["outside"]

    def slam_from_blueprint(self, poses: ArrayLike, outside: str | None = None) -> Projections:
        return self._project(self._forward, poses, outside)

    def blueprint_from_slam(self, poses: ArrayLike, outside: str | None = None) -> Projections:
        return self._project(self._backward, poses, outside)

    def jacobian(self, points: ArrayLike) -> Floats:
        """d place_in_slam / d place_in_blueprint [..., 2, 2], continued where the mesh ends."""
        points = np.asarray(points, np.float64)
        blend, inside = self._extended(points.reshape(-1, 2).T)
        return np.where(inside, blend.jacobian, blend.linear).T.reshape(points.shape[:-1] + (2, 2))

    def _build(self) -> None:
        metadata, arrays = self.metadata, self.arrays
        _require(metadata.get("model") in ("stretch", "rigid"), "has an unknown model")
        _require(metadata.get("weights") in ("smooth", "paper"), "has unknown weights")
        _require(metadata.get("outside") in ("error", "rigid"), "has an unknown outside policy")
        self._smooth = metadata["weights"] == "smooth"
        self._scale = _number(metadata, "scale")
        self._cell = _number(metadata, "cell_size_m")
        self._radius = _number(metadata, "radius_m")
        turn = _number(metadata, "lattice_heading_rad")
        self._corner = np.array([[_number(metadata, "lattice_x_m")], [_number(metadata, "lattice_y_m")]])
        _require(self._cell > 0.0, "has no positive cell size")
        _require(self._scale > 0.0, "has no positive scale")
        _require(0.0 < self._radius <= 1000.0 * self._cell, "has a radius that is not between 0 and 1000 cells")
        self._turn = np.array([math.cos(turn), -math.sin(turn), math.sin(turn), math.cos(turn)])
        self._to_cells = self._turn[[0, 2, 1, 3]] / self._cell
        self._cells_offset = -_times(self._to_cells, self._corner)

        self._tiles = arrays["node_tile"].T.astype(np.float64)
        _require((np.abs(self._tiles) <= _LARGEST_TILE).all(), "has a tile outside any building")
        self._table = _TileTable(self._tiles)
        _require(not self._table.has_twice, "has two nodes on one tile")
        _require((np.abs(arrays["node_stretch"]) <= _LARGEST_STRETCH).all(), "has a node stretched beyond reason")
        center = arrays["node_blueprint"].T.astype(np.float64)
        off_middle = np.abs(self._cells_of(center) - (self._tiles + 0.5))
        _require((off_middle <= 1.0).all(), "has a node that does not lie on its tile")
        slam = arrays["node_slam"].T
        along, across = self._scale * np.exp(arrays["node_stretch"].T)
        cos, sin = np.cos(slam[2]), np.sin(slam[2])
        linear = np.stack([cos * along, -sin * across, sin * along, cos * across])
        # One column a node: weight, offset, linear part. The column behind the last node stands for "none".
        self._nodes = np.zeros((7, len(cos) + 1))
        self._nodes[0, :-1] = 1.0
        self._nodes[1:3, :-1] = slam[:2] - _times(linear, center)
        self._nodes[3:, :-1] = linear
        self._center = center
        column, row = self._tiles
        self._around = np.full((9, len(cos) + 1), len(cos), np.int32)
        for k in range(9):
            self._around[k, :-1] = self._table.find(column + (k % 3 - 1), row + (k // 3 - 1))
        self._seeds = _Seeds(slam[:2], 2.0 * self._scale * self._cell)
        self._near_fold = self._near(self._folded_tiles())

    def _prove_itself(self) -> None:
        checks = self.arrays["check_poses"]
        found = self.slam_from_blueprint(checks[:, :3], "rigid")
        off = np.hypot(*(found.poses[:, :2] - checks[:, 3:5]).T)
        turned = np.abs(np.remainder(found.poses[:, 2] - checks[:, 5] + np.pi, 2.0 * np.pi) - np.pi)
        holds = found.ok & (off <= 1e-6 + 1e-12 * np.hypot(*checks[:, 3:5].T)) & (turned <= 1e-6)
        _require(holds.all(), "does not reproduce its own check poses")

    def _project(self, direction: Callable[[Floats, bool], tuple[Floats, NDArray[np.uint8]]], poses: ArrayLike,
                 outside: str | None) -> Projections:
        queries = as_poses(poses)
        policy = self.outside if outside is None else outside
        if policy not in ("error", "rigid"):
            raise ValueError("outside must be 'error' or 'rigid'")
        flat = queries.reshape(-1, 3)
        answers = np.empty_like(flat)
        status = np.empty(len(flat), np.uint8)
        with np.errstate(all="ignore"):
            for chunk in _chunks(len(flat), _CHUNK):
                columns = np.ascontiguousarray(flat[chunk].T)
                finite = np.isfinite(columns).all(axis=0)
                if finite.all():
                    part, status[chunk] = direction(columns, policy == "rigid")
                    answers[chunk] = part.T
                else:
                    answers[chunk], status[chunk] = np.nan, Status.INVALID
                    part, code = direction(columns[:, finite], policy == "rigid")
                    answers[chunk][finite], status[chunk][finite] = part.T, code
        return Projections(answers.reshape(queries.shape), status.reshape(queries.shape[:-1]))

    def _forward(self, poses: Floats, rigid: bool) -> tuple[Floats, NDArray[np.uint8]]:
        blend, inside = self._extended(poses[:2], answer_outside=rigid)
        heading = _heading_of(_times(blend.linear, _direction_of(poses[2])))
        status = np.where(inside, Status.INSIDE, Status.EXTRAPOLATED if rigid else Status.OUTSIDE).astype(np.uint8)
        status[(inside | rigid) & ~(_determinant(blend.jacobian) > 0.0)] = Status.FOLDED
        answers = np.stack([*blend.position, heading])
        answers[:, status > Status.EXTRAPOLATED] = np.nan
        return answers, status

    def _cells_of(self, points: Floats) -> Floats:
        return _times(self._to_cells, points) + self._cells_offset

    def _point_of(self, cells: Floats) -> Floats:
        return _times(self._turn, cells * self._cell) + self._corner

    def _extended(self, points: Floats, answer_outside: bool = True) -> tuple[_Blend, Flags]:
        """The forward function, continued beyond the mesh: its nearest place carries the query along rigidly."""
        cells = self._cells_of(points)
        tile = np.floor(cells)
        node = self._table.find(*tile)
        inside = node < self._table.count
        if inside.all():
            return self._blend(points, cells - tile, node), inside
        parts = _Blend(*(np.full((rows, points.shape[1]), np.nan) for rows in (2, 4, 4)))
        within = self._blend(points[:, inside], (cells - tile)[:, inside], node[inside])
        for part, values in zip(parts, within):
            part[:, inside] = values
        if answer_outside:
            beyond = ~inside
            near_cells, near_node = self._nearest_place(cells[:, beyond])
            near_point = self._point_of(near_cells)
            near = self._blend(near_point, near_cells - self._tiles[:, near_node], near_node)
            carried = near.position + _times(near.linear, points[:, beyond] - near_point)
            for part, values in zip(parts, near._replace(position=carried)):
                part[:, beyond] = values
        return parts, inside

    def _blend(self, points: Floats, fraction: Floats, node: Numbers) -> _Blend:
        """At places on the tiles of the given nodes; `fraction` is where on the tile."""
        if self._smooth:
            sums, slope_x, slope_y = self._smooth_sums(fraction, node)
            to_weights = self._to_cells
        else:
            sums, slope_x, slope_y = self._paper_sums(points, node)
            to_weights = np.array([1.0, 0.0, 0.0, 1.0])
        inverse = 1.0 / sums[0]
        linear = sums[3:] * inverse
        position = (sums[1:3] + _times(sums[3:], points)) * inverse
        across = (slope_x[1:3] + _times(slope_x[3:], points) - position * slope_x[0]) * inverse
        up = (slope_y[1:3] + _times(slope_y[3:], points) - position * slope_y[0]) * inverse
        jacobian = np.stack([linear[0] + across[0] * to_weights[0] + up[0] * to_weights[2],
                             linear[1] + across[0] * to_weights[1] + up[0] * to_weights[3],
                             linear[2] + across[1] * to_weights[0] + up[1] * to_weights[2],
                             linear[3] + across[1] * to_weights[1] + up[1] * to_weights[3]])
        return _Blend(position, linear, jacobian)

    def _smooth_sums(self, fraction: Floats, node: Numbers) -> tuple[Floats, Floats, Floats]:
        """Quadratic B-splines of the nine tiles around: sums over the nodes and their slopes along both axes."""
        x, y = fraction
        across, across_slope = (0.5 * (1.0 - x)**2, 0.75 - (x - 0.5)**2, 0.5 * x**2), (x - 1.0, 1.0 - 2.0 * x, x)
        up, up_slope = (0.5 * (1.0 - y)**2, 0.75 - (y - 0.5)**2, 0.5 * y**2), (y - 1.0, 1.0 - 2.0 * y, y)
        sums, slope_x, slope_y, term = (np.zeros((7, len(node))) for _ in range(4))
        for row in range(3):
            line, line_slope = np.zeros_like(sums), np.zeros_like(sums)
            for column in range(3):
                values = self._nodes.take(self._around[3 * row + column].take(node), axis=1)
                line += np.multiply(values, across[column], out=term)
                line_slope += np.multiply(values, across_slope[column], out=term)
            sums += np.multiply(line, up[row], out=term)
            slope_x += np.multiply(line_slope, up[row], out=term)
            slope_y += np.multiply(line, up_slope[row], out=term)
        return sums, slope_x, slope_y

    def _paper_sums(self, points: Floats, own: Numbers) -> tuple[Floats, Floats, Floats]:
        """1 / (distance + 1e-3) over the nodes within the radius; the node of the query's own tile always counts."""
        reach = math.ceil(self._radius / self._cell) + 1
        sums, slope_x, slope_y = (np.zeros((7, points.shape[1])) for _ in range(3))
        if (2 * reach + 1)**2 < self._table.count:
            column, row = self._tiles[:, own]
            offsets = [(dx, dy) for dy in range(-reach, reach + 1) for dx in range(-reach, reach + 1)]
            nodes: Iterator[NDArray[Any]] = (self._table.find(column + dx, row + dy) for dx, dy in offsets)
        else:
            nodes = (np.full(len(own), node) for node in range(self._table.count))
        for node in nodes:
            query = np.flatnonzero(node < self._table.count)
            away = points[:, query] - self._center[:, node[query]]
            distance = np.hypot(*away)
            close = (distance < self._radius) | (node[query] == own[query])
            query, away, distance = query[close], away[:, close], distance[close]
            weight = 1.0 / (distance + 1e-3)
            slope = np.where(distance > 0.0, -weight**2 / np.where(distance > 0.0, distance, 1.0), 0.0)
            values = self._nodes[:, node[query]]
            sums[:, query] += weight * values
            slope_x[:, query] += slope * away[0] * values
            slope_y[:, query] += slope * away[1] * values
        return sums, slope_x, slope_y

    def _nearest_place(self, cells: Floats) -> tuple[Floats, Numbers]:
        """The place of the mesh nearest to each query, just inside its tile, and the node of that tile."""
        squared = np.full(cells.shape[1], np.inf)
        best = np.zeros(cells.shape[1], np.int64)
        open_queries = np.flatnonzero((np.abs(cells) < _LARGEST_TILE).all(axis=0))
        far = np.ones(cells.shape[1], bool)
        for ring in range(9):
            done = (ring - 1.0) * abs(ring - 1.0) >= squared[open_queries]
            far[open_queries[done]] = False
            open_queries = open_queries[~done]
            if not len(open_queries):
                break
            column, row = np.floor(cells[:, open_queries])
            for dy in range(-ring, ring + 1):
                for dx in range(-ring, ring + 1, 1 if abs(dy) == ring else max(1, 2 * ring)):
                    node = self._table.find(column + dx, row + dy)
                    there = np.flatnonzero(node < self._table.count)
                    query = open_queries[there]
                    away = self._away_from_tile(cells[:, query], node[there])
                    better = away < squared[query]
                    squared[query[better]], best[query[better]] = away[better], node[there][better]
        for query in np.flatnonzero(far):
            best[query] = np.argmin(self._away_from_tile(cells[:, [query]], slice(None)))
        low = self._tiles[:, best]
        return np.minimum(np.maximum(cells, low), low + (1.0 - 1e-10)), best

    def _away_from_tile(self, cells: Floats, node: Any) -> Floats:
        away = np.abs(cells - (self._tiles[:, node] + 0.5)) - 0.5
        return (np.maximum(away, 0.0)**2).sum(axis=0)

    def _center_of(self, node: Numbers) -> Floats:
        return self._point_of(self._tiles[:, node] + 0.5)

    # --- The way back -----------------------------------------------------------------------------------------------

    def _preimage(self, start: Floats, target: Floats) -> tuple[Floats, Flags, Flags, _Blend]:
        """Newton's method on the continued forward function: places, converged, inside, the function there."""
        count = start.shape[1]
        point = start.copy()
        converged, inside = np.zeros(count, bool), np.zeros(count, bool)
        blend = _Blend(*(np.full((rows, count), np.nan) for rows in (2, 4, 4)))
        active = np.arange(count)
        for _ in range(40):
            here, within = self._extended(point[:, active])
            for part, values in zip(blend, here):
                part[:, active] = values
            inside[active] = within
            missing = target[:, active] - here.position
            hit = (missing**2).sum(axis=0) < 1e-20
            converged[active[hit]] = True
            slope = np.where(within, here.jacobian, here.linear)
            go_on = ~hit & (_determinant(slope) > 1e-6 * self._scale**2)
            step = _solve(slope[:, go_on], missing[:, go_on])
            length = np.hypot(*step)
            largest = 1.5 * self._cell  # so that the iteration stays on the sheet of the mesh it started on
            step *= np.where(within[go_on] & (length > largest), largest / length, 1.0)
            active = active[go_on]
            point[:, active] += step
            active = active[np.isfinite(point[:, active]).all(axis=0)]
            if not len(active):
                break
        return point, converged, inside, blend

    def _backward(self, poses: Floats, rigid: bool) -> tuple[Floats, NDArray[np.uint8]]:
        target = poses[:2]
        count = target.shape[1]
        seeds = self._seeds.nearest(target)
        point, blend = np.zeros((2, count)), _Blend(*(np.full((rows, count), np.nan) for rows in (2, 4, 4)))
        converged, inside = np.zeros(count, bool), np.zeros(count, bool)

        def try_from(query: Numbers, node: Numbers) -> None:
            found, hit, within, there = self._preimage(self._center_of(node), target[:, query])
            better = hit & (~converged[query] | (within & ~inside[query]))
            query = query[better]
            point[:, query], converged[query], inside[query] = found[:, better], True, within[better]
            for part, values in zip(blend, there):
                part[:, query] = values[:, better]

        for rank in range(seeds.shape[1]):
            query = np.flatnonzero((seeds[:, rank] >= 0) & ~(converged & inside))
            if len(query):
                try_from(query, seeds[query, rank])
        lost = np.flatnonzero(seeds[:, 0] < 0)
        if rigid and len(lost):
            try_from(lost, self._seeds.nearest_of_all(target[:, lost]))

        # Rounding may put the preimage of a border place a hair outside: that is still the border.
        beyond = np.flatnonzero(converged & ~inside)
        cells = self._cells_of(point[:, beyond])
        border, _ = self._nearest_place(cells)
        on_border = np.hypot(*(border - cells)) < 1e-8
        point[:, beyond[on_border]] = self._point_of(border[:, on_border])
        inside[beyond[on_border]] = True

        status = np.where(inside, Status.INSIDE, Status.EXTRAPOLATED if rigid else Status.OUTSIDE).astype(np.uint8)
        status[~converged] = Status.OUTSIDE
        status[(status <= Status.EXTRAPOLATED) & ~(_determinant(blend.jacobian) > 0.0)] = Status.FOLDED
        status[self._has_other_preimage(point, target, seeds, status == Status.INSIDE)] = Status.FOLDED
        answers = np.stack([*point, _heading_of(_solve(blend.linear, _direction_of(poses[2])))])
        answers[:, status > Status.EXTRAPOLATED] = np.nan
        return answers, status

    def _has_other_preimage(self, point: Floats, target: Floats, seeds: Numbers, asked: Flags) -> Flags:
        """Whether another place of the mesh lands on the same target: a fold, or distant parts that overlap."""
        other = np.zeros(len(asked), bool)
        tile = np.floor(self._cells_of(point))
        folds = self._near_fold[self._table.find(*tile)]
        for rank in range(seeds.shape[1]):
            node = seeds[:, rank]
            far = (np.abs(self._tiles[:, node] - tile) > 3.0).any(axis=0)
            query = np.flatnonzero(asked & ~other & (node >= 0) & (far | folds))
            if len(query):
                found, hit, within, _ = self._preimage(self._center_of(node[query]), target[:, query])
                apart = np.hypot(*(found - point[:, query])) > 1e-6 * self._cell
                other[query[hit & within & apart]] = True
        return other

    def _folded_tiles(self) -> Flags:
        """[n]: the forward function turns over at the centre or a corner of the tile."""
        folded = np.zeros(self._table.count, bool)
        low, high = 1e-9, 1.0 - 1e-9
        for fraction in ((0.5, 0.5), (low, low), (high, low), (low, high), (high, high)):
            for chunk in _chunks(self._table.count, _CHUNK):
                node = np.arange(self._table.count)[chunk]
                cells = self._tiles[:, chunk] + np.array(fraction)[:, None]
                blend = self._blend(self._point_of(cells), cells - self._tiles[:, chunk], node)
                folded[chunk] |= ~(_determinant(blend.jacobian) > 0.0)
        return folded

    def _near(self, tiles: Flags) -> Flags:
        """[n + 1]: within two tiles of one of the given ones; False behind the last."""
        near = np.zeros(self._table.count + 1, bool)
        column, row = self._tiles[:, tiles]
        for dy in range(-2, 3):
            for dx in range(-2, 3):
                near[self._table.find(column + dx, row + dy)] = True
        near[-1] = False
        return near


def as_poses(poses: ArrayLike) -> Floats:
    """Contiguous x, y, heading [..., 3] of poses or places."""
    given = np.ascontiguousarray(poses, np.float64)
    if np.ndim(poses) == 0 or given.shape[-1] not in (2, 3):
        raise ValueError("poses must be an array of x, y or of x, y, heading")
    return given if given.shape[-1] == 3 else np.concatenate([given, np.zeros_like(given[..., :1])], axis=-1)


def _chunks(count: int, size: int) -> Iterator[slice]:
    return (slice(begin, begin + size) for begin in range(0, count, size))
