# SPDX-License-Identifier: MIT
"""Options of Python as the core reads them: a JSON object, by the core's names.

Every option is known to the core alone, with its default, its range and its errors: an option that
is None is not asked for.
"""

from __future__ import annotations

import json
import math
import numbers
from collections.abc import Iterable, Mapping
from typing import Any

Bounds = Mapping[str, Any] | Iterable[str]  # {"fold": "+5"}, or ["fold=+5"]
Constraints = Mapping[str, float | None] | Iterable[str]  # {"circular": 1e-9}, or ["circular"]


def asked(arguments: Mapping[str, Any], *others: str) -> dict[str, Any]:
    """The options among the arguments of a function, its locals() at its start, by their names.

    Args:
        others: arguments that are no options; what `more` holds are.
    """
    named = {name: value for name, value in arguments.items() if name not in (*others, "more")}
    return {**named, **arguments["more"]}


def request(options: Mapping[str, Any]) -> str:
    """All bits of a number go along."""
    return json.dumps({name.replace("_", "-"): _plain(value) for name, value in options.items()})


def _plain(value: Any) -> Any:
    """As JSON has it; what it has not, such as infinity, as a text, for the core to refuse."""
    if hasattr(value, "tolist"):  # whatever numpy has
        value = value.tolist()
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        return float(value) if math.isfinite(value) else repr(float(value))
    if isinstance(value, Mapping):
        return {str(name): _plain(part) for name, part in value.items()}
    return [_plain(part) for part in value] if isinstance(value, Iterable) else str(value)
