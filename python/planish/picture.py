# SPDX-License-Identifier: MIT
"""A still picture of a mesh as SVG, for notebooks and catalogues."""

from __future__ import annotations

import html as markup
from collections.abc import Collection
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .mesh import Mesh

WIDTH_PX = 480
MOST_PANELS = 4000
PLAIN, MOVED = np.array([203, 213, 225]), np.array([59, 130, 246])
#: Columns: right, up in the picture, towards the eye; from the front, above and a little aside.
VIEW = np.array([[0.83, -0.28, 0.48], [0.56, 0.42, -0.71], [0.0, 0.86, 0.51]])


def svg(mesh: Mesh, moved: Collection[int]) -> str:
    """The picture alone; panels with a moved corner are tinted."""
    return _svg(mesh, _panels(mesh, moved)[0], set(moved))


def html(mesh: Mesh, moved: Collection[int], caption: str) -> str:
    """The picture with its caption; panels with a moved corner are tinted."""
    shown, left_out = _panels(mesh, moved)
    note = f", {left_out} panels not drawn" if left_out else ""
    return (
        f'<figure style="margin:0">{_svg(mesh, shown, set(moved))}'
        f"<figcaption>{markup.escape(caption)}{note}</figcaption></figure>"
    )


def _panels(mesh: Mesh, moved: Collection[int]) -> tuple[list[tuple[int, ...]], int]:
    """Those that are drawn, moved ones first, and how many are left out."""
    faces = mesh.faces
    if len(faces) <= MOST_PANELS:
        return faces, 0
    touched = set(moved)
    faces.sort(key=lambda face: touched.isdisjoint(face))
    return faces[:MOST_PANELS], len(faces) - MOST_PANELS


def _svg(mesh: Mesh, faces: list[tuple[int, ...]], moved: set[int]) -> str:
    seen = mesh.points @ VIEW
    flat = seen[:, :2] * (1, -1)
    low = flat.min(axis=0)
    size = np.maximum(flat.max(axis=0) - low, 1e-300)
    flat = (flat - low) * (WIDTH_PX / size.max())
    width, height = size * (WIDTH_PX / size.max())
    faces = sorted(faces, key=lambda face: seen[list(face), 2].mean())
    panels = "".join(_panel(mesh, face, flat, moved) for face in faces)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2:.0f}" height="{height + 2:.0f}"'
        f' viewBox="-1 -1 {width + 2:.1f} {height + 2:.1f}" stroke="#334155" stroke-width="0.4"'
        f' stroke-linejoin="round">{panels}</svg>'
    )


def _panel(mesh: Mesh, face: tuple[int, ...], flat: np.ndarray, moved: set[int]) -> str:
    corners = mesh.points[list(face)]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    length = np.linalg.norm(normal)
    light = abs(normal @ (0.3, -0.4, 0.87)) / length if length > 0 else 1.0
    colour = (PLAIN if moved.isdisjoint(face) else MOVED) * (0.55 + 0.45 * min(light, 1.0))
    red, green, blue = (int(c) for c in colour)
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in flat[list(face)])
    return f'<polygon points="{points}" fill="#{red:02x}{green:02x}{blue:02x}"/>'
