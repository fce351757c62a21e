#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads drawings of a structure with ezdxf, and holds them against its OBJ file.

Usage: check_drawings.py MESH.obj DRAWINGS.zip   The mesh is in metres, the first section x=V.
Exit 1 names the first fault; 77 without ezdxf.
"""

import json
import re
import sys
import zipfile

from zipped_dxf import read_csv, read_dxf

# What a view shows as its x and y, from the model's.
VIEWS = {
    "plan": lambda x, y, z: (x, y),
    "elevation-front": lambda x, y, z: (x, z),
    "elevation-right": lambda x, y, z: (y, z),
    "elevation-back": lambda x, y, z: (-x, z),
    "elevation-left": lambda x, y, z: (-y, z),
}
IN_MM = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}


def read_obj(path):
    points, faces = [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        if words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, faces


def polylines(archive, name):
    lines = read_dxf(archive, name, {"POLYLINE"}).query("POLYLINE")
    for line in lines:
        assert line.is_closed or line.dxf.layer == "SECTION", f"{name}: an open outline"
    return [[(v.dxf.location.x, v.dxf.location.y) for v in line.vertices] for line in lines]


def extent(lines):
    points = [p for line in lines for p in line]
    return [max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1)]


def check_scale(archive, name, lines, scale, unit):
    """The SVG is the DXF at 1 : scale, in millimetres of paper."""
    svg = archive.read(name + ".svg").decode("utf-8")
    assert re.search(r'width="[\d.]+mm" height="[\d.]+mm"', svg), name
    shapes = re.findall(r' points="([^"]+)"', svg)
    drawn = [[tuple(map(float, p.split(","))) for p in shape.split()] for shape in shapes]
    assert [len(shape) for shape in drawn] == [len(line) for line in lines], name
    for paper, model in zip(extent(drawn), extent(lines)):
        assert abs(paper * scale - model * IN_MM[unit]) <= 2e-5 * scale, f"{name}: not 1 : {scale}"


def check(mesh, path):
    archive = zipfile.ZipFile(path)
    assert archive.testzip() is None, path
    header = json.loads(archive.read("drawings.json"))
    unit, scale = header["unit"], header["scale"]
    points, faces = read_obj(mesh)
    to_unit = 1000.0 / IN_MM[unit]
    for name, seen in VIEWS.items():
        lines = polylines(archive, f"{name}-{unit}.dxf")
        key = lambda line: sorted((round(x, 4), round(y, 4)) for x, y in line)
        expected = [[tuple(to_unit * c for c in seen(*points[v])) for v in face] for face in faces]
        for drawn, wanted in zip(sorted(map(key, lines)), sorted(map(key, expected)), strict=True):
            assert all(abs(a - b) <= 2e-4 for p, q in zip(drawn, wanted, strict=True) for a, b in zip(p, q)), name
        check_scale(archive, name, lines, scale, unit)
    lines = polylines(archive, f"section-1-{unit}.dxf")
    rows = read_csv(archive, f"section-1-{unit}.csv")
    assert len(rows) == sum(map(len, lines)) > 2
    for row, (x, y) in zip(rows, [p for line in lines for p in line], strict=True):
        assert abs(float(row["y"]) - x) <= 1e-6 and abs(float(row["z"]) - y) <= 1e-6
        assert row["x"] == rows[0]["x"] or abs(float(row["x"]) - float(rows[0]["x"])) < 1e-9 * to_unit
    check_scale(archive, "section-1", lines, scale, unit)


try:
    check(*sys.argv[1:])
except AssertionError as fault:
    sys.exit(f"{sys.argv[2]}: {fault}")
