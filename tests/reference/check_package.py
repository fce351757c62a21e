#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads cutting packages as a workshop would: with ezdxf and shapely, knowing nothing of ours.

Usage: check_package.py PACKAGE.zip...   Exit 1 names the first fault; 77 without ezdxf or shapely.
"""

import json
import sys
import zipfile

from zipped_dxf import read_csv, read_dxf

try:
    from shapely.affinity import rotate, translate
    from shapely.geometry import Polygon, box
    from shapely.ops import unary_union
except ImportError:
    sys.exit(77)


def read_drawing(archive, name):
    space = read_dxf(archive, name, {"POLYLINE", "TEXT"})
    assert all(e.is_closed for e in space.query("POLYLINE")), f"{name}: an open polyline"
    return space


def loops_on(space, layer):
    return [
        Polygon([(v.dxf.location.x, v.dxf.location.y) for v in line.vertices])
        for line in space.query(f'POLYLINE[layer=="{layer}"]')
    ]


def check_no_overlap(name, outlines):
    boxes = sorted((o.bounds, k) for k, o in enumerate(outlines))
    for place, ((_, low, right, high), k) in enumerate(boxes):
        for (left, other_low, _, other_high), j in boxes[place + 1 :]:
            if left >= right:
                break
            if other_low < high and low < other_high:
                shared = outlines[k].intersection(outlines[j]).area
                assert shared < 1e-9 * outlines[k].area, f"{name}: two panels overlap"


def check_texts(name, space, outline):
    """Every text within what is cut, clear of the mark and of each other; 0.9 of its height a character."""
    taken = loops_on(space, "MARK")
    for mark in taken:
        assert mark.area > 0 and outline.contains(mark), f"{name}: the mark is not on the panel"
        assert outline.boundary.distance(mark) > 0, f"{name}: the mark is on a cut"
    for text in space.query("TEXT"):
        high, wide = text.dxf.height, 0.9 * text.dxf.height * len(text.dxf.text)
        place = rotate(box(-wide / 2, -high / 2, wide / 2, high / 2), text.dxf.rotation, (0, 0))
        place = translate(place, text.dxf.align_point[0], text.dxf.align_point[1])
        assert outline.contains(place), f"{name}: {text.dxf.text} runs over the edge"
        assert not any(place.intersects(other) for other in taken), f"{name}: {text.dxf.text}"
        taken.append(place)


def check(path):
    archive = zipfile.ZipFile(path)
    assert archive.testzip() is None, path
    package = json.loads(archive.read("package.json"))
    panels = read_csv(archive, "panels.csv")
    assert len(panels) == package["counts"]["panels"] == len(package["panels"])
    assert len(read_csv(archive, "edges.csv")) == package["counts"]["edges"]
    assert len(read_csv(archive, "nodes.csv")) == package["counts"]["nodes"]
    area = {row["panel"]: float(row["area"]) for row in panels}
    pieces = {row["panel"]: row["pieces"] for row in package.get("apart", [])}
    on_sheets = 0
    for name in archive.namelist():
        if not name.endswith(".dxf"):
            continue
        space = read_drawing(archive, name)
        outlines = loops_on(space, "CUT")
        assert all(o.is_valid for o in outlines), f"{name}: an outline crosses itself"
        check_no_overlap(name, outlines)
        if name.startswith("panels/"):
            panel = name.split("/")[1].rsplit("-", 1)[0]
            assert len(outlines) == pieces.get(panel, 1), name
            check_texts(name, space, unary_union(outlines))
            if package["gap"] == 0:
                assert abs(outlines[0].area - area[panel]) <= 1e-6 * area[panel], name
        if name.startswith("sheets/"):
            sheet = box(0, 0, package["sheets"]["width"], package["sheets"]["height"])
            assert all(sheet.contains(o) for o in outlines), f"{name}: beyond the sheet"
            gaps = loops_on(space, "GAP")
            assert all(sheet.covers(o) for o in gaps), f"{name}: a gap outline beyond the sheet"
            on_sheets += sum(o.area for o in outlines)
    if package["sheets"] and package["sheets"]["count"]:
        sheets = package["sheets"]
        used = on_sheets / (sheets["count"] * sheets["width"] * sheets["height"])
        assert abs(used - sheets["used_fraction"]) < 1e-6, f"{path}: used fraction is {used}"


for file in sys.argv[1:]:
    try:
        check(file)
    except AssertionError as fault:
        sys.exit(f"{file}: {fault}")
