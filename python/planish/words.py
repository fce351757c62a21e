# SPDX-License-Identifier: MIT
"""Options of Python as the words of the command line, which the core reads.

Every option is known to the core alone, with its default, its range and its errors: an option that
is None is not said. Floats are written with the digits that give the same bits again.
"""

from __future__ import annotations

import numbers
from collections.abc import Iterable, Mapping
from typing import Any

from . import _core
from .errors import UsageError


def number_text(value: Any) -> str:
    """A number with all its bits; what is no number as it is, for the core to refuse."""
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    return str(value)


def list_text(values: Iterable[Any], separator: str = ",") -> str:
    return separator.join(number_text(value) for value in values)


def handle_words(handles: Mapping[int, Iterable[float]], relative: bool) -> list[str]:
    """--handle for each; {vertex: (x, y, z)}."""
    sign = "+=" if relative else "="
    return [f"--handle={number_text(v)}{sign}{list_text(xyz)}" for v, xyz in handles.items()]


def bound_texts(bounds: Mapping[str, Any] | Iterable[str]) -> list[str]:
    """{"fold": 25, "angle": (60, 120), "sheet": (2, 3), "shape": False} or ["fold=+5"]."""
    if not isinstance(bounds, Mapping):
        return list(bounds)
    return [f"{name}={_bound_value(name, value)}" for name, value in bounds.items()]


def _bound_value(name: str, value: Any) -> str:
    if _is_switch(value):
        return "on" if value else "off"
    if isinstance(value, (tuple, list)):
        return list_text(value, "x" if name == "sheet" else ":")
    return number_text(value)


def constraint_texts(constraints: Mapping[str, float | None] | Iterable[str]) -> list[str]:
    """["circular"] or {"circular": 1e-9, "conical": None}."""
    if not isinstance(constraints, Mapping):
        return list(constraints)
    return [k if tol is None else f"{k}:{number_text(tol)}" for k, tol in constraints.items()]


_SPELLED = {"bounds": bound_texts, "constraints": constraint_texts}


def option_words(command: str, options: Mapping[str, Any]) -> list[str]:
    """The words for `options`, by the names of Python; plurals take several values."""
    rows = {name: value for name, value, _ in _core.options(command)}
    words: list[str] = []
    for name, value in options.items():
        if value is None:
            continue
        flag = "--" + name.replace("_", "-")
        if flag not in rows and flag.endswith("s") and flag[:-1] in rows:
            texts = [value] if isinstance(value, str) else value
            words += [f"{flag[:-1]}={text}" for text in _SPELLED.get(name, _plain_texts)(texts)]
        elif flag in rows and (not rows[flag] or _may_be_switch(rows[flag], value)):
            words += _switch(name, flag, value)
        else:
            # Unknown names too: the core says so.
            words.append(f"{flag}={number_text(value)}")
    return words


def _plain_texts(values: Iterable[Any]) -> list[str]:
    """Texts one by one; numbers, such as pins, in one list."""
    values = list(values)
    if any(isinstance(value, str) for value in values):
        return [number_text(value) for value in values]
    return [list_text(values)] if values else []


def _is_switch(value: Any) -> bool:
    return isinstance(value, bool) or type(value).__name__ == "bool_"


def _may_be_switch(row: str, value: Any) -> bool:
    """What takes a value only perhaps, such as join_points, is also on or off."""
    return row.startswith("[") and _is_switch(value)


def _switch(name: str, flag: str, value: Any) -> list[str]:
    if not _is_switch(value):
        raise UsageError(f"{name} must be True or False")
    return [flag] if value else []
