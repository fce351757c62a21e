# SPDX-License-Identifier: MIT
"""What can go wrong, each with one sentence that names the field."""

import re


class Error(Exception):
    """Base of all errors of this package."""


class UsageError(Error, ValueError):
    """An option, a handle or a name that is wrong, whatever the mesh is."""


class MeshError(Error, ValueError):
    """A mesh, a design or a file that cannot be used."""


_OPTION = re.compile(r"--([a-z][a-z-]*)")


def wording(sentence: str) -> str:
    """The core's sentence as Python writes it: keep_boundary, not --keep-boundary."""
    named = _OPTION.sub(lambda match: match[1].replace("-", "_"), sentence)
    return named.replace("must be true or false", "must be True or False")
