# SPDX-License-Identifier: MIT
"""Edits and the variations around them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from . import _core
from .mesh import Mesh
from .request import Bounds, Constraints, asked, request
from .shape import DesignedShape, Progress


class Variation(DesignedShape):
    """One member of a family, as the sliders show it or made exact."""

    _core: _core.Variation

    def exact(self, *, progress: Progress | None = None) -> Variation:
        """The nearest mesh whose panels are all flat."""
        return Variation(self._core.exact(progress))


class Family:
    """The variations of an edit: call it with one number a slider."""

    def __init__(self, core: _core.Family) -> None:
        self._core = core

    @property
    def dimension(self) -> int:
        """How many independent variations were found: at most what was asked for."""
        return self._core.dimension

    def __call__(self, coefficients: Iterable[float]) -> Variation:
        """As many numbers as were asked for; 1 moves some point by the edit's own largest move."""
        return Variation(self._core.at(request({"coefficients": coefficients})))

    def __repr__(self) -> str:
        return f"<planish.Family of {self.dimension}>"


class Edit(DesignedShape):
    """A finished edit."""

    _core: _core.Edit

    def explore(
        self,
        dimension: int,
        *,
        eigen: bool | None = None,
        family: int | None = None,
        fair_weight: float | None = None,
        sparse_weight: float | None = None,
        close_weight: float | None = None,
        close: Iterable[int] | None = None,
        correlation: float | None = None,
        spread: int | None = None,
        smooth: float | None = None,
        progress: Progress | None = None,
        **more: Any,
    ) -> Family:
        """A family of local variations around this edit: `planish explore`.

        Args:
            eigen: from smooth to stiff; with `family` the smoothest of so many.
            close: vertices that `close_weight` keeps still; the handles without.
            spread: face rings around the edit that variations may move.
            smooth: of `exact()`: higher is fairer and moves more.
        """
        options = asked(locals(), "self", "progress")
        return Family(self._core.explore(request(options), progress))


def edit(
    mesh: Mesh,
    handles: Mapping[int, Iterable[float]],
    *,
    relative: bool = True,
    cuts: Iterable[str] | None = None,
    fewest: str | int | None = None,
    split_where_needed: int | None = None,
    within_handle: str | None = None,
    fair: bool | None = None,
    count_types: float | str | None = None,
    mirrored: bool | None = None,
    pins: Iterable[int] | None = None,
    supports: Iterable[str] | None = None,
    continuation: int | None = None,
    symmetry: str | None = None,
    hard: bool | None = None,
    bounds: Bounds | None = None,
    keep_outs: Iterable[str] | None = None,
    clearance: float | str | None = None,
    constraints: Constraints | None = None,
    locality: float | None = None,
    smoothness: float | None = None,
    softness: float | None = None,
    reach: int | str | None = None,
    keep_boundary: bool | None = None,
    model_unit: str | None = None,
    attraction: float | None = None,
    fairness: str | None = None,
    sparsity: str | None = None,
    solver: str | None = None,
    tolerance: float | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    **more: Any,
) -> Edit:
    """Moves a few vertices; panels stay flat, the rest stays put.

    Options are those of `planish edit`, by the same names with underscores; None leaves the core's
    default, and planish.options("edit") tells all of them. The interpreter's lock is free during
    the solve.

    Args:
        handles: {vertex: (dx, dy, dz)}, or positions with relative=False; model units.
        cuts: made before the edit, in this order, ["strip=12-13@0.4", "corner=40:57"]; handles may
            name the points that they add.
        pins: vertices that stay.
        fewest: "panels" or "points": few to make again, as long as the handles arrive; a number: at most so
            many panels.
        split_where_needed: at most so many panels are parted where the handles stop short.
        within_handle: of the longest way of a handle, within which handles have arrived for these two, "5%".
        fair: limits how much folds sharpen and the corners of slivers, where that costs the handles nothing
            and `bounds` has no such limit.
        count_types: how many types of panels there are before and after, in the report: alike within a
            length in units of the mesh or a share of the mean edge, "0.5%".
        mirrored: for count_types: a panel may be its template turned over.
        supports: what points slide on, ["level=z:boundary", "outline:boundary"].
        continuation: steps in which the handles go to their targets, each solved from the last.
        symmetry: an edit of one point edits its images, "x", "axis:4", "x,y" or "auto".
        bounds: {"angle": (25, 160), "fold": "+5", "sheet": (2, 3), "slide": 0.05, "shape": False} or
            the texts of the command line, ["fold=+5"]; {"flat": 60}: panels bent by up to 60 mm/m stay as
            bent as they are.
        keep_outs: where nothing may go, ["below=0", "plane=0,0,1,4", "box=0,0,2,1,1,3",
            "mesh=core.obj"].
        clearance: kept from every one of them; model units, or a length with its unit such as "50mm", as
            all lengths here may be.
        constraints: ["circular"] or {"circular": 1e-9}.
        reach: face rings, or a length with its unit such as "1.5m".
        threads: of the solver "alm"; the result is the same.
        progress: called after every step; False stops with the last valid state and the status
            "cancelled".

    Raises:
        UsageError: a handle or an option that is wrong, in the core's sentence.
        MeshError: a mesh that breaks a constraint itself.
    """
    options = asked(locals(), "mesh", "handles", "relative", "progress")
    way = "by" if relative else "to"
    options["handles"] = [{"vertex": vertex, way: point} for vertex, point in handles.items()]
    return Edit(_core.edit(mesh._core, request(options), progress))
