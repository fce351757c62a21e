# SPDX-License-Identifier: MIT
"""Designs: a base mesh, what was done to it, and the mark of what came out."""

from __future__ import annotations

import base64
import json
import os
import zlib
from typing import Any

from . import _core
from .mesh import Mesh
from .shape import Progress, Shape


class Replay(Shape):
    """A design done again."""

    def __init__(self, core: _core.Replay) -> None:
        super().__init__(core.shape)
        self._core = core

    @property
    def verified(self) -> bool | None:
        """Whether every bit is the recorded one; None where nothing was recorded."""
        return self.report.verified

    @property
    def deviation(self) -> float | None:
        """Largest distance from the recorded result, model units."""
        return self.report.deviation

    @property
    def design(self) -> Design:
        """With the mark of this result."""
        return Design(self._core.design)

    def save(self, path: str | os.PathLike[str]) -> None:
        """In the format of the extension: .glb holds the design too, .json the design alone."""
        self._core.save(os.fspath(path))


class Design:
    """A recipe as data.

    Args:
        recipe: its JSON, or the same as a dict; docs/formats.md has every field.

    Raises:
        MeshError: what no design can be made of, naming the field.
    """

    def __init__(self, recipe: str | dict[str, Any]) -> None:
        text = recipe if isinstance(recipe, str) else json.dumps(recipe)
        self._core = _core.Design(text)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Design:
        """From .json, or from a .glb that holds one."""
        design = cls.__new__(cls)
        design._core = _core.Design.load(os.fspath(path))
        return design

    @property
    def text(self) -> str:
        """One line of JSON with every option spelled out."""
        return self._core.text

    @property
    def recipe(self) -> dict[str, Any]:
        """The same as a dict; a copy."""
        return json.loads(self.text)

    def save(self, path: str | os.PathLike[str]) -> None:
        """To .json."""
        self._core.save(os.fspath(path))

    def link(self, page: str) -> str:
        """The address that opens the design in the editor at `page`, which verifies its result."""
        packer = zlib.compressobj(9, zdict=_core.link_dictionary())
        packed = packer.compress(self._core.link_text.encode()) + packer.flush()
        return page + "#v2=" + base64.urlsafe_b64encode(packed).decode().rstrip("=")

    def replay(self, base: Mesh | None = None, *, progress: Progress | None = None) -> Replay:
        """Does it again.

        Args:
            base: the mesh, where the design does not hold it.
        """
        return Replay(self._core.replay(None if base is None else base._core, progress))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Design) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)
