#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads cutting packages as a workshop would: with ezdxf and shapely, knowing nothing of ours.

Usage: check_package.py PACKAGE.zip...   Exit 1 names the first fault; 77 without ezdxf or shapely.
"""

import csv
import io
import json
import sys
import zipfile

try:
    import ezdxf
    from shapely.geometry import Polygon, box
except ImportError:
    sys.exit(77)


def read_dxf(archive, name):
    document = ezdxf.read(io.StringIO(archive.read(name).decode("ascii")))
    audit = document.audit()
    assert not audit.errors and not audit.fixes, f"{name}: {[e.message for e in audit.errors + audit.fixes]}"
    assert document.dxfversion == "AC1009", name
    space = document.modelspace()
    assert {e.dxftype() for e in space} <= {"POLYLINE", "TEXT"}, name
    assert all(e.is_closed for e in space.query("POLYLINE")), f"{name}: an open polyline"
    return space


def cut_outlines(space):
    return [
        Polygon([(v.dxf.location.x, v.dxf.location.y) for v in line.vertices])
        for line in space.query('POLYLINE[layer=="CUT"]')
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


def rows(archive, name):
    return list(csv.DictReader(io.StringIO(archive.read(name).decode("utf-8"), newline="")))


def check(path):
    archive = zipfile.ZipFile(path)
    assert archive.testzip() is None, path
    package = json.loads(archive.read("package.json"))
    panels = rows(archive, "panels.csv")
    assert len(panels) == package["counts"]["panels"] == len(package["panels"])
    assert len(rows(archive, "edges.csv")) == package["counts"]["edges"]
    assert len(rows(archive, "nodes.csv")) == package["counts"]["nodes"]
    area = {row["panel"]: float(row["area"]) for row in panels}
    on_sheets = 0
    for name in archive.namelist():
        if not name.endswith(".dxf"):
            continue
        outlines = cut_outlines(read_dxf(archive, name))
        assert all(o.is_valid for o in outlines), f"{name}: an outline crosses itself"
        check_no_overlap(name, outlines)
        if name.startswith("panels/"):
            panel = name.split("/")[1].rsplit("-", 1)[0]
            assert len(outlines) == 1, name
            if package["gap"] == 0:
                assert abs(outlines[0].area - area[panel]) <= 1e-6 * area[panel], name
        if name.startswith("sheets/"):
            sheet = box(0, 0, package["sheets"]["width"], package["sheets"]["height"])
            assert all(sheet.contains(o) for o in outlines), f"{name}: beyond the sheet"
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
