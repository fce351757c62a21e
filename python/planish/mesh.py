# SPDX-License-Identifier: MIT
"""Meshes: checked once when they are made, never changed afterwards."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, picture
from .errors import MeshError, wording
from .report import Report

Points = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]


class Mesh:
    """Points and polygons. Vertex and face order never change.

    Args:
        points: (n, 3), model units.
        faces: index tuples from 0, an array (f, k) of faces of one size, or a tuple of two arrays
            (offsets, corners): face i has the corners corners[offsets[i]:offsets[i + 1]].

    Raises:
        MeshError: what no mesh can be made of, naming the vertex or the face.
    """

    __slots__ = ("_core",)

    def __init__(self, points: npt.ArrayLike, faces: Any) -> None:
        self._core = _core.Mesh(_numbers(points), *_offsets_and_corners(faces))

    @classmethod
    def _of(cls, core: _core.Mesh) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._core = core
        return mesh

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Mesh:
        """In the format of the extension, see docs/formats.md; "sample:vault:32" is a sample."""
        return cls._of(_core.Mesh.read(os.fspath(path)))

    @classmethod
    def of(cls, other: Any) -> Mesh:
        """From a COMPAS mesh or whatever else has to_vertices_and_faces(), or from such a pair."""
        pair = other.to_vertices_and_faces() if hasattr(other, "to_vertices_and_faces") else other
        points, faces = pair
        return cls(points, faces)

    def write(self, path: str | os.PathLike[str]) -> None:
        """In the format of the extension, every coordinate with all its bits."""
        self._core.write(os.fspath(path))

    def to_vertices_and_faces(self) -> tuple[list[list[float]], list[list[int]]]:
        """For COMPAS: Mesh.from_vertices_and_faces(*mesh.to_vertices_and_faces())."""
        return self.points.tolist(), [list(face) for face in self.faces]

    @property
    def points(self) -> Points:
        """(n, 3), read only, no copy."""
        return self._core.points

    @property
    def offsets(self) -> Indices:
        """f + 1 places in `corners`, read only."""
        return self._core.offsets

    @property
    def corners(self) -> Indices:
        """The vertices of all faces one after the other, read only."""
        return self._core.corners

    @property
    def faces(self) -> list[tuple[int, ...]]:
        """Index tuples; a copy."""
        corners = self.corners.tolist()
        ends = self.offsets.tolist()
        return [tuple(corners[a:b]) for a, b in zip(ends, ends[1:])]

    @property
    def warnings(self) -> list[str]:
        """What is odd about the mesh and what is done about it, one sentence each."""
        return [wording(warning) for warning in self._core.warnings]

    def info(self) -> Report:
        """Counts, edge length, degrees of freedom and flatness."""
        return Report.of_text(self._core.info())

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<planish.Mesh: {len(self.points)} points, {len(self.offsets) - 1} panels>"

    def _repr_html_(self) -> str:
        return picture.html(self, (), repr(self))

    def __reduce__(self) -> tuple[Any, ...]:
        return (Mesh, (np.array(self.points), (np.array(self.offsets), np.array(self.corners))))


def _numbers(points: npt.ArrayLike) -> Points:
    try:
        return np.ascontiguousarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise MeshError("points must be an array of shape (n, 3)") from None


def _offsets_and_corners(faces: Any) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    if isinstance(faces, tuple) and len(faces) == 2 and all(
        isinstance(part, np.ndarray) and part.ndim == 1 for part in faces
    ):
        return _whole(faces[0], "offsets"), _whole(faces[1], "corners")
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        count, size = faces.shape
        return np.arange(count + 1, dtype=np.int64) * size, _whole(faces.ravel(), "faces")
    return _flattened(faces)


def _flattened(
    faces: Iterable[Sequence[int]],
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    try:
        rows = [list(face) for face in faces]
    except TypeError:
        raise MeshError("faces must be index tuples or (offsets, corners)") from None
    offsets = np.zeros(len(rows) + 1, dtype=np.int64)
    np.cumsum([len(row) for row in rows], out=offsets[1:])
    return offsets, _whole(np.array([v for row in rows for v in row]), "faces")


def _whole(values: npt.NDArray[Any], what: str) -> npt.NDArray[np.int64]:
    if values.size and not np.issubdtype(values.dtype, np.integer):
        raise MeshError(f"{what} must be whole numbers")
    return values.astype(np.int64)
