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
    """The core's sentence with options as Python writes them: keep_boundary, not --keep-boundary."""
    return _OPTION.sub(lambda match: match[1].replace("-", "_"), sentence)


def of_core(code: int, sentence: str) -> Error:
    """The exception for an exit code of the command."""
    kind = {2: UsageError, 3: MeshError}.get(code, Error)
    return kind(wording(sentence))
