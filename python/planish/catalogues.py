# SPDX-License-Identifier: MIT
"""The designs of a sweep as a folder to look through: pictures, figures, axes to brush."""

from __future__ import annotations

import csv
import json
import os
import shutil
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any

import numpy as np

from . import _core, picture
from .design import Design
from .errors import UsageError

#: The page, as `bash .tools/start/build.sh catalogue` makes it; part of the wheel.
PAGE = Path(__file__).with_name("catalogue_page")
#: Characters. A design with a large mesh makes a link that browsers and people choke on.
LONGEST_LINK = 32_000


def catalogue(
    folder: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    page: str | None = None,
    title: str = "Designs",
    progress: Callable[[int, int], bool | None] | None = None,
) -> None:
    """A static folder that shows what a sweep left in `folder`; open its index.html.

    Every design is made again for its picture, over all cores. Panels are coloured by how far they move, on
    one scale up to the largest move of all designs; pictures that `out` has on this scale are kept.

    Args:
        folder: as `planish sweep -o` fills it.
        out: made if it is not there.
        page: address of the editor, absolute or as seen from `out`; each design then has a link that
            opens and verifies it there, unless its mesh is too large for a link.
        progress: (pictures done, all); False stops, and what is there is shown.

    Raises:
        MeshError: `folder` holds no results.
        UsageError: this package was built without the page.
    """
    if not (PAGE / "index.html").exists():
        raise UsageError(
            "this package was built without the catalogue's page: run bash .tools/start/build.sh catalogue, "
            "then build the wheel again"
        )
    folder, out = Path(folder), Path(out)
    for part in ("designs", "pictures"):
        (out / part).mkdir(parents=True, exist_ok=True)
    for name in PAGE.iterdir():
        shutil.copy(name, out)
    _core.gather(os.fspath(folder), os.fspath(out / "results.csv"))
    table = _table(out / "results.csv")
    files = {row["id"]: folder / f"{row['id']}.design.json" for row in table["designs"]}
    files = {name: path for name, path in files.items() if path.exists()}
    largest = _largest_move(table)
    (out / "scale.svg").write_text(picture.scale(), encoding="utf-8")
    _draw(files, out / "pictures", largest, progress)
    for row in table["designs"]:
        if row["id"] in files:
            row |= _doors(row["id"], files[row["id"]], out, page, largest)
    text = json.dumps({"title": title, "largest": largest, **table}, separators=(",", ":"))
    (out / "designs.js").write_text(f"planishCatalogue = {text};\n", encoding="utf-8")


def _table(path: Path) -> dict[str, Any]:
    """Columns and designs as web/src/catalogue/table.ts says; no pictures and links yet."""
    with path.open(encoding="utf-8", newline="") as file:
        names, *rows = csv.reader(file)
    first_figure = names.index("status")
    columns = [
        {"name": name, "kind": "value" if k < first_figure else "figure"}
        for k, name in enumerate(names)
    ]
    designs = [
        {"id": row[0], "cells": [_cell(text) for text in row[1:]]}
        | {"picture": None, "file": None, "link": None}
        for row in rows
    ]
    return {"columns": columns[1:], "designs": designs}


def _cell(text: str) -> float | str | None:
    try:
        return float(text) if text else None
    except ValueError:
        return text


def _largest_move(table: dict[str, Any]) -> float:
    """Of all designs; 0 where nothing moves."""
    names = [column["name"] for column in table["columns"]]
    moves = [row["cells"][names.index("max_displacement")] for row in table["designs"]]
    return max((move for move in moves if isinstance(move, float)), default=0.0)


def _draw(
    files: dict[str, Path],
    pictures: Path,
    largest: float,
    progress: Callable[[int, int], bool | None] | None,
) -> None:
    missing = {
        name: path for name, path in files.items()
        if not _is_drawn(_picture(pictures, name), largest)
    }
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        drawn = [pool.submit(_draw_one, path, _picture(pictures, name), largest)
                 for name, path in missing.items()]
        for done, future in enumerate(as_completed(drawn), 1):
            future.result()
            if progress is not None and progress(done, len(drawn)) is False:
                pool.shutdown(cancel_futures=True)
                return


def _scale_mark(largest: float) -> str:
    """The last line of a picture: the scale that it was drawn on."""
    return f"<!-- scale {largest!r} -->\n"


def _is_drawn(path: Path, largest: float) -> bool:
    return path.exists() and path.read_text(encoding="utf-8").endswith(_scale_mark(largest))


def _draw_one(design: Path, path: Path, largest: float) -> None:
    """By rename, so that a picture is whole or missing."""
    shape = Design.load(design).replay()
    moves = np.linalg.norm(shape.positions - shape.base.points, axis=1)
    drawn = picture.svg(shape.mesh, moves, largest)
    part = path.with_suffix(".part")
    part.write_text(f"{drawn}\n{_scale_mark(largest)}", encoding="utf-8")
    part.replace(path)


def _picture(pictures: Path, name: str) -> Path:
    return pictures / f"{name}.svg"


def _doors(name: str, design: Path, out: Path, page: str | None,
           largest: float) -> dict[str, str | None]:
    shutil.copy(design, out / "designs")
    link = None if page is None else Design.load(design).link(page)
    return {
        "picture": f"pictures/{name}.svg" if _is_drawn(_picture(out / "pictures", name), largest) else None,
        "file": f"designs/{design.name}",
        "link": link if link is not None and len(link) <= LONGEST_LINK else None,
    }
