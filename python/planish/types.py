# SPDX-License-Identifier: MIT
"""Which panels, nodes and bars are alike."""

from __future__ import annotations

import os
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import wording
from .mesh import Mesh
from .report import Report
from .request import asked, request


class Types:
    """Types of panels, nodes and bars, each with what they keep. Never changes."""

    def __init__(self, core: _core.Types) -> None:
        self._core = core

    @cached_property
    def report(self) -> Report:
        """As `planish types --report`: `types`, `nodes`, `bars`, `templates`, `seams`."""
        return Report.of_text(self._core.report)

    @property
    def messages(self) -> list[str]:
        """What the command line would say, one sentence each; empty if all is well."""
        return [wording(sentence) for sentence in self._core.messages]

    @cached_property
    def of_panel(self) -> npt.NDArray[np.int64]:
        """(f,) the type of each panel, from 0: the one with most panels."""
        return np.array(self._core.of_panel, np.int64)

    def save(self, path: str | os.PathLike[str]) -> None:
        """The table as .csv: which panel is of which type, and how it lies on the template."""
        self._core.save(os.fspath(path))

    def __repr__(self) -> str:
        return f"<planish.Types: {len(self.report.templates)} of {len(self.of_panel)} panels>"


def types(
    mesh: Mesh,
    *,
    joint: tuple[float, float] | None = None,
    within: float | str | None = None,
    mirrored: bool | None = None,
    angle: float | None = None,
    unit: str | None = None,
    model_unit: str | None = None,
    tolerance: float | None = None,
    **more: Any,
) -> Types:
    """What of a mesh is alike: `planish types`. No point moves.

    Args:
        joint: between which widths joints may vary when one template a type is cut.
        within: how far a corner may be from its template's, or a share of the mean edge, "0.5%".
        mirrored: a panel may be its template turned over.
        angle: degrees, of nodes and bars.
        unit: of all lengths here and in the report, "mm" without.
        model_unit: of the coordinates, "m" without.
        tolerance: mm/m, up to which a panel is flat.

    Raises:
        UsageError: what is wrong with an option, naming it.
    """
    options = asked(locals(), "mesh")
    return Types(_core.Types(mesh._core, request(options)))
