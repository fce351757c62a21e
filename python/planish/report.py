# SPDX-License-Identifier: MIT
"""The report of an operation: what the command writes with --report."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from typing import Any


@dataclass(frozen=True)
class Report:
    """Figures by the names of the JSON report; None where an operation has no such figure.

    Lengths are in model units, flatness in mm per m. `json` is the whole report; figures that only
    some operations have (`subspace`, `exact`, `rms_move`, ...) are attributes too.
    """

    status: str  #: "converged", "infeasible_handles", "cancelled", ...
    mesh: dict[str, Any]
    planarity_mm_per_m: dict[str, float]
    solver: str | None = None
    objective: dict[str, float] | None = None
    moved_vertices: int | None = None
    max_displacement: float | None = None
    handle_error: float | None = None
    iterations: int | None = None
    factorizations: int | None = None
    optimality: dict[str, Any] | None = None
    violations: list[dict[str, Any]] = field(default_factory=list)
    bounds: list[dict[str, Any]] = field(default_factory=list)
    supports: list[dict[str, Any]] = field(default_factory=list)
    symmetry: dict[str, Any] | None = None
    planarised_first: dict[str, float] | None = None
    spoilt_faces: dict[str, list[int]] = field(default_factory=dict)
    #: "shape_max": largest distance from the surface that was edited; "slide_max": way along it,
    #: across its mean normal at the old point
    motion: dict[str, float] | None = None
    sharpest_fold: dict[str, float] | None = None
    remake: dict[str, int] | None = None
    seconds: dict[str, float] | None = None
    json: dict[str, Any] = field(default_factory=dict, repr=False)

    @classmethod
    def of_text(cls, text: str) -> Report:
        """From JSON."""
        values = json.loads(text)
        known = {f.name for f in fields(cls)} - {"json"}
        return cls(**{name: values[name] for name in known & values.keys()}, json=values)

    def __getattr__(self, name: str) -> Any:
        # Only called for what is no field; copying asks before __init__.
        values = self.__dict__.get("json", {})
        if name in values:
            return values[name]
        raise AttributeError(f"this report has no {name!r}")
