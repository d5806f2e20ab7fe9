# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""The projector of cad2slam.py through the C library libcad2slam.so.0, for single queries in microseconds.

Importing fails with ImportError where the library is not installed; cad2slam.load() then does without it. The
environment variable CAD2SLAM_LIBRARY names another library file.
"""

from __future__ import annotations

import ctypes
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import cad2slam

_POLICIES = {None: 0, "error": 1, "rigid": 2}
_NOT_FOUND, _UNREADABLE, _OUT_OF_MEMORY = 1, 2, 5


def _open_library() -> ctypes.CDLL:
    path = os.environ.get("CAD2SLAM_LIBRARY", "libcad2slam.so.0")
    try:
        library = ctypes.CDLL(path)
        handle, doubles, status = ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p
        library.cad2slam_version.restype = ctypes.c_char_p
        library.cad2slam_load.argtypes = [ctypes.c_char_p, ctypes.POINTER(handle), ctypes.c_char_p, ctypes.c_size_t]
        library.cad2slam_free.argtypes = [handle]
        library.cad2slam_free.restype = None
        library.cad2slam_node_count.argtypes = [handle]
        library.cad2slam_node_count.restype = ctypes.c_size_t
        for function in (library.cad2slam_slam_from_blueprint_many, library.cad2slam_blueprint_from_slam_many):
            function.argtypes = [handle, doubles, doubles, status, ctypes.c_size_t, ctypes.c_int]
            function.restype = ctypes.c_size_t
    except (OSError, AttributeError) as error:
        raise ImportError(f"no usable C library of CAD2SLAM: {error}") from None
    return library


_library = _open_library()


def version() -> str:
    """Of the C library."""
    return _library.cad2slam_version().decode()


class NativeProjector:
    """As cad2slam.Projector, whose words hold here as well."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._handle = ctypes.c_void_p()
        message = ctypes.create_string_buffer(1024)
        result = _library.cad2slam_load(os.fsencode(path), ctypes.byref(self._handle), message, len(message))
        if result:
            text = message.value.decode("utf-8", "replace")
            if result == _NOT_FOUND:
                raise FileNotFoundError(text)
            if result == _UNREADABLE:
                raise OSError(text)
            if result == _OUT_OF_MEMORY:
                raise MemoryError(text)
            raise cad2slam.ProjectorError(text)
        self._path = path

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            _library.cad2slam_free(self._handle)
            self._handle = ctypes.c_void_p()

    def __getattr__(self, name: str) -> Any:
        if name not in ("metadata", "arrays"):
            raise AttributeError(name)
        self.metadata, self.arrays = cad2slam.read(self._path)  # only when somebody asks
        return self.__dict__[name]

    @property
    def outside(self) -> str:
        """What the file says of queries beyond the mesh: "error" or "rigid"."""
        return self.metadata["outside"]

    def slam_from_blueprint(self, poses: ArrayLike, outside: str | None = None) -> cad2slam.Projections:
        return self._project(_library.cad2slam_slam_from_blueprint_many, poses, outside)

    def blueprint_from_slam(self, poses: ArrayLike, outside: str | None = None) -> cad2slam.Projections:
        return self._project(_library.cad2slam_blueprint_from_slam_many, poses, outside)

    def _project(self, function: Any, poses: ArrayLike, outside: str | None) -> cad2slam.Projections:
        queries = cad2slam.as_poses(poses)
        if outside not in _POLICIES:
            raise ValueError("outside must be 'error' or 'rigid'")
        answers = np.empty_like(queries)
        status = np.empty(queries.shape[:-1], np.uint8)
        function(self._handle, queries.ctypes.data, answers.ctypes.data, status.ctypes.data, status.size,
                 _POLICIES[outside])
        return cad2slam.Projections(answers, status)
