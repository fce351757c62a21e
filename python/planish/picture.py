# SPDX-License-Identifier: MIT
"""A still picture of a mesh as SVG, for notebooks and catalogues."""

from __future__ import annotations

import html as markup
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .mesh import Mesh

WIDTH_PX = 480
MOST_PANELS = 4000
PLAIN, MOVED = np.array([203, 213, 225]), np.array([59, 130, 246])
#: Colours of panels that move, from hardly to the farthest.
RAMP = np.array([(254, 240, 138), (249, 115, 22), (190, 18, 60), (88, 28, 135)])
SCALE_PX = (160, 12)
#: Columns: right, up in the picture, towards the eye; from the front, above and a little aside.
VIEW = np.array([[0.83, -0.28, 0.48], [0.56, 0.42, -0.71], [0.0, 0.86, 0.51]])


def svg(mesh: Mesh, moves: np.ndarray, largest: float) -> str:
    """The picture alone.

    Args:
        moves: how far each vertex is from where it was; a panel has the colour of its farthest corner.
        largest: what has the last colour of the ramp; the pictures of a sweep have it in common.
    """
    shares = np.minimum(moves / largest, 1.0) if largest > 0 else np.zeros(len(moves))

    def colour(face: tuple[int, ...]) -> np.ndarray:
        share = shares[list(face)].max()
        return PLAIN if share == 0 else _on_ramp(share)

    return _svg(mesh, _panels(mesh, np.flatnonzero(moves).tolist())[0], colour)


def scale() -> str:
    """The ramp of svg() from left to right, for a legend."""
    width, height = SCALE_PX
    stops = "".join(
        f'<stop offset="{k / (len(RAMP) - 1):.4f}" stop-color="{_hex(stop)}"/>'
        for k, stop in enumerate(RAMP)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">'
        f'<linearGradient id="ramp">{stops}</linearGradient>'
        f'<rect width="{width}" height="{height}" fill="url(#ramp)"/></svg>'
    )


def _on_ramp(share: float) -> np.ndarray:
    places = np.linspace(0.0, 1.0, len(RAMP))
    return np.array([np.interp(share, places, channel) for channel in RAMP.T])


def _hex(colour: np.ndarray) -> str:
    red, green, blue = (int(c) for c in colour)
    return f"#{red:02x}{green:02x}{blue:02x}"


def html(mesh: Mesh, moved: Collection[int], caption: str) -> str:
    """The picture with its caption; panels with a moved corner are tinted."""
    shown, left_out = _panels(mesh, moved)
    touched = set(moved)
    drawn = _svg(mesh, shown, lambda face: PLAIN if touched.isdisjoint(face) else MOVED)
    note = f", {left_out} panels not drawn" if left_out else ""
    return (
        f'<figure style="margin:0">{drawn}'
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


#: The colour of a panel in full light, from its corners.
Colour = Callable[[tuple[int, ...]], np.ndarray]


def _svg(mesh: Mesh, faces: list[tuple[int, ...]], colour: Colour) -> str:
    seen = mesh.points @ VIEW
    flat = seen[:, :2] * (1, -1)
    low = flat.min(axis=0)
    size = np.maximum(flat.max(axis=0) - low, 1e-300)
    flat = (flat - low) * (WIDTH_PX / size.max())
    width, height = size * (WIDTH_PX / size.max())
    faces = sorted(faces, key=lambda face: seen[list(face), 2].mean())
    panels = "".join(_panel(mesh, face, flat, colour(face)) for face in faces)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2:.0f}" height="{height + 2:.0f}"'
        f' viewBox="-1 -1 {width + 2:.1f} {height + 2:.1f}" stroke="#334155" stroke-width="0.4"'
        f' stroke-linejoin="round">{panels}</svg>'
    )


def _panel(mesh: Mesh, face: tuple[int, ...], flat: np.ndarray, colour: np.ndarray) -> str:
    corners = mesh.points[list(face)]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    length = np.linalg.norm(normal)
    light = abs(normal @ (0.3, -0.4, 0.87)) / length if length > 0 else 1.0
    shaded = colour * (0.55 + 0.45 * min(light, 1.0))
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in flat[list(face)])
    return f'<polygon points="{points}" fill="{_hex(shaded)}"/>'
