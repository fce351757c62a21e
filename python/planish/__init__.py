# SPDX-License-Identifier: MIT
"""Edit meshes whose panels must stay flat: drag a point, a few neighbours follow."""

from ._core import version as __version__
from .catalogues import catalogue
from .design import Design, Replay
from .edits import Edit, Family, Variation, edit
from .errors import Error, MeshError, UsageError
from .mesh import Mesh
from .mobilities import Mobility, mobility
from .operations import Offset, Projection, convert, info, offset, options, project
from .report import Report
from .shape import Shape
from .sweeps import Job, Plan, gather, sweep
from .types import Types, types

__all__ = [
    "Design",
    "Edit",
    "Error",
    "Family",
    "Job",
    "Mesh",
    "MeshError",
    "Mobility",
    "Offset",
    "Plan",
    "Projection",
    "Replay",
    "Report",
    "Shape",
    "Types",
    "UsageError",
    "Variation",
    "__version__",
    "catalogue",
    "convert",
    "edit",
    "gather",
    "info",
    "mobility",
    "offset",
    "options",
    "project",
    "sweep",
    "types",
]
