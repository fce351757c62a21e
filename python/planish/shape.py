# SPDX-License-Identifier: MIT
"""What every operation gives: positions, what moved, a report, and a way to save it."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _core, picture
from .errors import wording
from .mesh import Mesh, Points
from .report import Report

if TYPE_CHECKING:
    from .design import Design

#: (step, objective, residual); False stops the solve with the last valid state.
Progress = Callable[[int, float, float], "bool | None"]


class Shape:
    """Positions over the faces of a base mesh. Never changes."""

    def __init__(self, core: _core.Shape) -> None:
        self._shape = core

    @cached_property
    def positions(self) -> Points:
        """(n, 3), model units."""
        return self._shape.positions

    @cached_property
    def moved(self) -> npt.NDArray[np.int64]:
        """Vertices whose coordinates differ from the base's, ascending."""
        return self._shape.moved

    @cached_property
    def base(self) -> Mesh:
        """What was edited: the mesh as given, or a flat one near it."""
        return Mesh._of(self._shape.base)

    @cached_property
    def mesh(self) -> Mesh:
        """The result as a mesh of its own."""
        return Mesh._of(self._shape.mesh)

    @cached_property
    def report(self) -> Report:
        return Report.of_text(self._shape.report)

    @property
    def messages(self) -> list[str]:
        """What the command line would say about the result, one sentence each; empty if all is well."""
        return [wording(sentence) for sentence in self._shape.messages]

    def save(self, path: str | os.PathLike[str]) -> None:
        """In the format of the extension, ".obj" for example; docs/formats.md has all of them."""
        self._shape.save(os.fspath(path))

    def _repr_html_(self) -> str:
        return picture.html(self.mesh, self.moved.tolist(), repr(self))

    def __repr__(self) -> str:
        name = type(self).__name__
        return f"<planish.{name}: {self.report.status}, {len(self.moved)} points moved>"


class DesignedShape(Shape):
    """A shape whose recipe can be stored and done again."""

    def __init__(self, core: _core.Edit | _core.Variation) -> None:
        super().__init__(core.shape())
        self._core = core

    @property
    def design(self) -> Design:
        """Base, recipe and mark of the result."""
        from .design import Design

        return Design(self._core.design())

    def save(self, path: str | os.PathLike[str]) -> None:
        """In the format of the extension: .glb holds the design too, .json the design alone."""
        self._core.save(os.fspath(path))
