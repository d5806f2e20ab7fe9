# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Puts projectors between a fleet adapter of Open-RMF and the API of its robots.

RMF thinks in the blueprint, each robot in its own bent map, and one similarity per level (`reference_coordinates`) is
all that an adapter can put between them. ProjectedRobotAPI wraps the RobotAPI of an adapter instead:

    api = c2s_rmf.ProjectedRobotAPI(RobotAPI(config), {"L1": "office.c2s"})

and RMF gets no transformation at all: an adapter without `reference_coordinates` passes poses on as they are.
Commands beyond the mesh are refused and poses from there are not reported, also where the file would go on rigidly: a
robot never drives to a guessed place.
"""

from __future__ import annotations

import copy
import logging
import os
from typing import Any, Callable, Mapping, Sequence

import cad2slam

_log = logging.getLogger(__name__)

Pose = Sequence[float]  # x, y [m], heading [rad]


class Levels:
    """The projectors of one robot, by the name RMF has for a level."""

    def __init__(self, projectors: Mapping[str, str | os.PathLike[str] | cad2slam.Projector],
                 robot_maps: Mapping[str, str] | None = None) -> None:
        """robot_maps: how the robot calls the map of a level, where it uses another name than RMF."""
        self._projectors = {level: item if hasattr(item, "slam_from_blueprint") else cad2slam.load(item)
                            for level, item in projectors.items()}
        names = dict(robot_maps or {})
        self._map_of = {level: names.get(level, level) for level in self._projectors}
        self._level_of = {name: level for level, name in self._map_of.items()}
        if len(self._level_of) != len(self._map_of):
            raise ValueError("two levels have the same map of the robot")

    def to_robot(self, level: str, pose: Pose) -> tuple[str, list[float]] | None:
        """Map of the robot and the pose there; None beyond the mesh or for a level without projector."""
        return self._convert(level, pose, self._map_of.get(level), level, "slam_from_blueprint")

    def to_rmf(self, robot_map: str, pose: Pose) -> tuple[str, list[float]] | None:
        """Level and pose in RMF's coordinates; None beyond the mesh or for a map without projector."""
        level = self._level_of.get(robot_map)
        return self._convert(robot_map, pose, level, level, "blueprint_from_slam")

    def level_of(self, robot_map: str | None) -> str | None:
        """RMF's name for a map of the robot; None for one without projector."""
        return self._level_of.get(robot_map)

    def only_map(self) -> str | None:
        """The map of the robot where there is but one."""
        return next(iter(self._level_of)) if len(self._level_of) == 1 else None

    def _convert(self, source: str, pose: Pose, target: str | None, level: str | None, direction: str) -> Any:
        if target is None or level is None:
            _log.error("no projector for map %s", source)
            return None
        found = getattr(self._projectors[level], direction)([float(value) for value in pose[:3]], "error")
        if not found.ok:
            _log.error("pose %s on map %s: %s", list(pose), source, cad2slam.Status(int(found.status)).name.lower())
            return None
        return target, found.poses.tolist()


class ProjectedRobotAPI:
    """A RobotAPI whose poses are RMF's. Everything that holds no pose goes straight to the API it wraps."""

    def __init__(self, api: Any, projectors: Mapping[str, Any], robot_maps: Mapping[str, str] | None = None) -> None:
        self._api = api
        self._levels = Levels(projectors, robot_maps)
        self._map_names: dict[str, str] = {}

    def __getattr__(self, name: str) -> Any:
        if name == "_api":  # not there yet while unpickling
            raise AttributeError(name)
        return getattr(self._api, name)

    def navigate(self, robot_name: str, pose: Pose, map_name: str, *more: Any, **options: Any) -> Any:
        return self._command(self._api.navigate, robot_name, pose, map_name, *more, **options)

    def localise(self, robot_name: str, pose: Pose, map_name: str, *more: Any, **options: Any) -> Any:
        return self._command(self._api.localise, robot_name, pose, map_name, *more, **options)

    def localize(self, robot_name: str, pose: Pose, map_name: str, *more: Any, **options: Any) -> Any:
        return self._command(self._api.localize, robot_name, pose, map_name, *more, **options)

    def map(self, robot_name: str, *more: Any) -> str | None:
        """The level on which the robot is, by RMF's name."""
        return self._levels.level_of(self._api.map(robot_name, *more))

    def position(self, robot_name: str, *more: Any) -> list[float] | None:
        """As the template's: x, y, heading without a map, so it asks for that, or takes where the robot was last seen."""
        pose = self._api.position(robot_name, *more)
        robot_map = self._map_of_robot(robot_name)
        if pose is None or robot_map is None:
            return None
        converted = self._levels.to_rmf(robot_map, pose)
        return None if converted is None else converted[1]

    def get_data(self, robot_name: str | None = None, *more: Any) -> Any:
        """As the template's: an object with `map` and `position`, which are replaced in a copy, or a list of such."""
        data = self._api.get_data(robot_name, *more)
        if isinstance(data, (list, tuple)):
            return [found for found in (self._in_rmf(item, getattr(item, "robot_name", None)) for item in data)
                    if found is not None]
        return None if data is None else self._in_rmf(data, robot_name)

    def _command(self, command: Callable[..., Any], robot_name: str, pose: Pose, map_name: str, *more: Any,
                 **options: Any) -> Any:
        converted = self._levels.to_robot(map_name, pose)
        if converted is None:
            return False
        robot_map, goal = converted
        return command(robot_name, goal, robot_map, *more, **options)

    def _map_of_robot(self, robot_name: str) -> str | None:
        if hasattr(self._api, "map"):
            return self._api.map(robot_name)
        known = self._map_names.get(robot_name) or self._levels.only_map()
        if known is None:
            _log.error("the map of %s is not known yet", robot_name)
        return known

    def _in_rmf(self, data: Any, robot_name: str | None) -> Any:
        if robot_name is not None:
            self._map_names[robot_name] = data.map
        converted = self._levels.to_rmf(data.map, data.position)
        if converted is None:
            return None
        data = copy.copy(data)
        data.map, data.position = converted
        return data
