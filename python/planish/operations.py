# SPDX-License-Identifier: MIT
"""What is done to a whole mesh, and what is asked about it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from . import _core
from .mesh import Mesh
from .report import Report
from .request import Bounds, Constraints, asked, request
from .shape import Progress, Shape


class Projection(Shape):
    """A mesh whose panels were made flat."""


class Offset(Shape):
    """A second layer, every edge parallel to the mesh's own."""


def project(
    mesh: Mesh,
    *,
    reference: Mesh | None = None,
    smooth: float | None = None,
    within: float | str | None = None,
    pins: Iterable[int] | None = None,
    keep_boundary: bool | None = None,
    bounds: Bounds | None = None,
    constraints: Constraints | None = None,
    supports: Iterable[str] | None = None,
    split: int | str | None = None,
    move: float | str | None = None,
    types: int | None = None,
    mirrored: bool | None = None,
    fairness: str | None = None,
    model_unit: str | None = None,
    solver: str | None = None,
    threads: int | None = None,
    tolerance: float | None = None,
    progress: Progress | None = None,
    **more: Any,
) -> Projection:
    """Makes every panel flat, close by and fair: `planish project`.

    Args:
        within: model units, > 0; no vertex moves farther, and the result is as flat as that allows.
            With move how far a corner may be from its template's, also "0.5%" of the mean edge.
        bounds: shape, a bool; flat, mm/m > 0: as far as panels may stay out of flat.
        split: at most so many panels, or "10%" of them, are split: the fewest that make it flat.
        move: of a flat mesh, more panels become alike, and no point moves farther; model units, or
            "20%" of the mean edge.
        types: with move, the closest fit found with so many types.
        mirrored: with move, a panel may be its template turned over.
    """
    options = asked(locals(), "mesh", "progress")
    options["reference"] = None if reference is None else "reference"
    other = None if reference is None else reference._core
    return Projection(_core.project(mesh._core, request(options), other, progress))


def offset(
    mesh: Mesh,
    distance: float | str,
    *,
    model_unit: str | None = None,
    kind: str | None = None,
    **more: Any,
) -> Offset:
    """The mesh at a distance: `planish offset`. Positive is outside; model units, or "25mm"."""
    options = asked(locals(), "mesh")
    return Offset(_core.offset(mesh._core, request(options)))


def convert(
    mesh: Mesh,
    *,
    join_points: bool | float | None = None,
    orient: bool | None = None,
    join_triangles: bool | None = None,
    **more: Any,
) -> Mesh:
    """A mesh mended as `planish convert` does it; `warnings` of it say how much was.

    Args:
        join_points: True, or model units > 0: panels that have points of their own share them.
        orient: neighbours agree, the outside out or up.
        join_triangles: two by two, into the quads that a program split.
    """
    options = asked(locals(), "mesh")
    return Mesh._of(_core.convert(mesh._core, request(options)))


def info(mesh: Mesh) -> Report:
    """Figures of a mesh: `planish info`."""
    return mesh.info()


def options(command: str) -> dict[str, str]:
    """What "edit", "explore", "project", "offset", "mobility", "convert" or "types" takes, and what that does."""
    return {
        name.lstrip("-").replace("-", "_"): " ".join(help_text.split())
        for name, _, help_text in _core.options(command)
    }
