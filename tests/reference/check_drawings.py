#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads drawings of a structure with ezdxf, and holds them against its OBJ file.

Usage: check_drawings.py MESH.obj DRAWINGS.zip   The first section is x=V.
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


STRUCTURE = {"OUTSIDE", "INSIDE", "SECTION"}
NOTES = {"AXIS", "LEVEL", "PLANE", "SIZE"}
DECIMALS = {"mm": 0, "cm": 1, "m": 3, "km": 6, "in": 1, "ft": 2}


def by_layer(archive, name):
    """The polylines on each layer, and the texts."""
    space = read_dxf(archive, name, {"POLYLINE", "TEXT"})
    layers = {}
    for line in space.query("POLYLINE"):
        assert line.is_closed or line.dxf.layer not in {"OUTSIDE", "INSIDE"}, f"{name}: an open outline"
        points = [(v.dxf.location.x, v.dxf.location.y) for v in line.vertices]
        layers.setdefault(line.dxf.layer, []).append(points)
    assert set(layers) <= STRUCTURE | NOTES, f"{name}: {set(layers)}"
    return layers, [decoded(text.dxf.text) for text in space.query("TEXT")]


def decoded(text):
    """What CAD programs show for \\U+XXXX."""
    return re.sub(r"\\U\+([0-9A-F]{4})", lambda code: chr(int(code[1], 16)), text)


def structure(layers):
    return [line for layer in STRUCTURE for line in layers.get(layer, [])]


def coordinate_seen(name, axis):
    """Which coordinate of the drawing that of the model is, and which way it runs; None where it is not seen."""
    unit = [float(axis == word) for word in "xyz"]
    for k, seen in enumerate(VIEWS[name](*unit)):
        if seen:
            return k, seen
    return None


def level_unit(header):
    return "ft" if header["model_unit"] in ("in", "ft") else "m"


def check_notes(name, layers, texts, header):
    """Axes, levels and sizes are where they are said to be, and say what they are."""
    low, high = ([end(p[k] for line in structure(layers) for p in line) for k in (0, 1)] for end in (min, max))
    decimals = DECIMALS[header["unit"]]
    for k in (0, 1):
        if high[k] > low[k]:
            assert f"{high[k] - low[k]:.{decimals}f}" in texts, f"{name}: no size {high[k] - low[k]} in {texts}"
    for axis in header["axes"]:
        seen = coordinate_seen(name, axis["axis"])
        layer = "LEVEL" if axis["axis"] == "z" else "AXIS"
        there = seen is not None and any(
            len(line) == 2 and all(abs(p[seen[0]] - seen[1] * axis["at"]) <= 1e-5 for p in line)
            for line in layers.get(layer, []))
        assert there == (seen is not None), f"{name}: {axis}"
        if seen is None:
            continue
        height = axis["at"] * IN_MM[header["unit"]] / IN_MM[level_unit(header)]
        words = f"{height:+.3f}" if height else "0.000"
        wanted = f"{words} {axis['name']}".strip() if layer == "LEVEL" else axis["name"]
        assert not wanted or wanted in texts, f"{name}: no {wanted} in {texts}"
    title = f"{header['name']}, {name}, 1:{header['scale']:g}, "
    end_of_title = f"levels in {level_unit(header)}, mesh {header['mesh_hash']}"
    assert any(text.startswith(title) and text.endswith(end_of_title) for text in texts), f"{name}: {texts}"


def extent(lines):
    points = [p for line in lines for p in line]
    return [max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1)]


def check_scale(archive, name, layers, scale, unit):
    """The SVG is the DXF at 1 : scale, in millimetres of paper."""
    lines = [line for some in layers.values() for line in some]
    svg = archive.read(name + ".svg").decode("utf-8")
    assert re.search(r'width="[\d.]+mm" height="[\d.]+mm"', svg), name
    shapes = re.findall(r' points="([^"]+)"', svg)
    drawn = [[tuple(map(float, p.split(","))) for p in shape.split()] for shape in shapes]
    assert sorted(map(len, drawn)) == sorted(map(len, lines)), name
    for paper, model in zip(extent(drawn), extent(lines)):
        assert abs(paper * scale - model * IN_MM[unit]) <= 2e-5 * scale, f"{name}: not 1 : {scale}"


def check(mesh, path):
    archive = zipfile.ZipFile(path)
    assert archive.testzip() is None, path
    header = json.loads(archive.read("drawings.json"))
    unit, scale = header["unit"], header["scale"]
    points, faces = read_obj(mesh)
    to_unit = IN_MM[header["model_unit"]] / IN_MM[unit]
    for name, seen in VIEWS.items():
        layers, texts = by_layer(archive, f"{name}-{unit}.dxf")
        lines = structure(layers)
        check_notes(name, layers, texts, header)
        key = lambda line: sorted((round(x, 4), round(y, 4)) for x, y in line)
        expected = [[tuple(to_unit * c for c in seen(*points[v])) for v in face] for face in faces]
        for drawn, wanted in zip(sorted(map(key, lines)), sorted(map(key, expected)), strict=True):
            assert all(abs(a - b) <= 2e-4 for p, q in zip(drawn, wanted, strict=True) for a, b in zip(p, q)), name
        check_scale(archive, name, layers, scale, unit)
    layers, _ = by_layer(archive, f"section-1-{unit}.dxf")
    lines = structure(layers)
    rows = read_csv(archive, f"section-1-{unit}.csv")
    assert len(rows) == sum(map(len, lines)) > 2
    for row, (x, y) in zip(rows, [p for line in lines for p in line], strict=True):
        assert abs(float(row["y"]) - x) <= 1e-6 and abs(float(row["z"]) - y) <= 1e-6
        assert row["x"] == rows[0]["x"] or abs(float(row["x"]) - float(rows[0]["x"])) < 1e-9 * to_unit
    check_scale(archive, "section-1", layers, scale, unit)


try:
    check(*sys.argv[1:])
except AssertionError as fault:
    sys.exit(f"{sys.argv[2]}: {fault}")
