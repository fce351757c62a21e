# SPDX-License-Identifier: MIT
"""Where a mesh can move: how far each vertex gets before a panel stops it."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import UsageError
from .mesh import Mesh
from .request import Bounds, Constraints, asked, request

if TYPE_CHECKING:
    from distributed import Client

_CHUNK = 64


class Mobility:
    """Four rows for each vertex: up, down, and the two best directions of the surface.

    Attributes:
        vertex: (r,) indices
        direction: (r, 3), of length 1
        distance: (r,) model units, the farthest of the tried moves that ends sound
        limit: (r,) what ends the way: "range", "shape", "search" or the name of a bound
        remake: (r,) panels to be made again
        sharpest_fold: (r,) degrees
    """

    def __init__(self, rows: list[_core.MobilityRow], core: _core.Mobility) -> None:
        self._rows, self._core = rows, core
        vertex, direction, distance, limit, remake, fold = (
            zip(*rows) if rows else ((), (), (), (), (), ())
        )
        self.vertex: npt.NDArray[np.int64] = np.array(vertex, np.int64)
        self.direction: npt.NDArray[np.float64] = np.array(direction, float).reshape(-1, 3)
        self.distance: npt.NDArray[np.float64] = np.array(distance, float)
        self.limit: npt.NDArray[np.str_] = np.array(limit, str)
        self.remake: npt.NDArray[np.int64] = np.array(remake, np.int64)
        self.sharpest_fold: npt.NDArray[np.float64] = np.array(fold, float)

    def __len__(self) -> int:
        return len(self.vertex)

    def save(self, path: str | os.PathLike[str]) -> None:
        """As `planish mobility -o`: .json, .csv, or the mesh with colours to .glb."""
        self._core.save(self._rows, os.fspath(path))


def mobility(
    mesh: Mesh,
    *,
    vertices: Iterable[int] | None = None,
    range: float | str | None = None,
    steps: int | None = None,
    bounds: Bounds | None = None,
    constraints: Constraints | None = None,
    locality: float | None = None,
    smoothness: float | None = None,
    softness: float | None = None,
    reach: int | str | None = None,
    keep_boundary: bool | None = None,
    model_unit: str | None = None,
    fairness: str | None = None,
    sparsity: str | None = None,
    tolerance: float | None = None,
    threads: int | None = None,
    client: Client | None = None,
    progress: Callable[[int, int], bool | None] | None = None,
    **more: Any,
) -> Mobility:
    """How far each vertex gets before a panel stops it: `planish mobility`.

    Args:
        vertices: these alone; all without.
        range: model units; moves are tried up to there.
        client: of dask.distributed: its workers measure chunks of vertices, each on one thread; one
            that is lost is measured again by another.
        progress: (vertices done, all), after every chunk; False stops, what is there is returned.

    Raises:
        UsageError: what is wrong with an option, naming it.
    """
    options = asked(locals(), "mesh", "vertices", "threads", "client", "progress")
    core = _core.Mobility(mesh._core, request({**options, "threads": threads}))
    chunks = _chunks(mesh, vertices)
    count = sum(map(len, chunks))
    parts: dict[int, list[_core.MobilityRow]] = {}
    measured = _here(core, chunks) if client is None else _there(client, mesh, options, chunks)
    done = 0
    for k, rows in measured:
        parts[k] = rows
        done += len(chunks[k])
        if progress is not None and progress(done, count) is False:
            break
    measured.close()
    return Mobility([row for k in sorted(parts) for row in parts[k]], core)


def _chunks(mesh: Mesh, vertices: Iterable[int] | None) -> list[list[int]]:
    count = len(mesh.points)
    chosen = list(range(count) if vertices is None else np.unique(list(vertices)).tolist())
    if chosen and not (0 <= chosen[0] and chosen[-1] < count):
        raise UsageError(f"vertices: the mesh has vertices 0 to {count - 1}")
    return [chosen[k : k + _CHUNK] for k in range(0, len(chosen), _CHUNK)]


_Part = tuple[int, "list[_core.MobilityRow]"]


def _here(core: _core.Mobility, chunks: list[list[int]]) -> Generator[_Part, None, None]:
    for k, chunk in enumerate(chunks):
        yield k, core.measure(chunk)


def _there(
    client: Client, mesh: Mesh, options: dict[str, Any], chunks: list[list[int]]
) -> Generator[_Part, None, None]:
    """The parts as they come; what is left is given up if the caller stops."""
    from distributed import as_completed

    sent = client.scatter(mesh, broadcast=True)
    asked = request({**options, "threads": 1})  # a worker's threads share nothing but the mesh
    futures = {
        client.submit(_measure, sent, asked, chunk, pure=False, retries=3): k
        for k, chunk in enumerate(chunks)
    }
    try:
        for future in as_completed(list(futures)):
            yield futures[future], future.result()
    finally:
        client.cancel(list(futures))


def _measure(mesh: Mesh, asked: str, vertices: list[int]) -> list[_core.MobilityRow]:
    """On a worker."""
    return _core.Mobility(mesh._core, asked).measure(vertices)
