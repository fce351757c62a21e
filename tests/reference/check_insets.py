#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds insets to shapely, which knows nothing of ours: a polygon less a strip along each side, mitred at
reflex corners.

Usage: check_insets.py INSETS   Each line: distance, corners, their coordinates, pieces, and of each the same
again. Prints how many were compared; exit 1 names the first fault; 77 without shapely.
"""

import math
import sys

try:
    from shapely.geometry import Polygon
    from shapely.ops import unary_union
except ImportError:
    sys.exit(77)


def read_polygon(words):
    count = int(next(words))
    return [(float(next(words)), float(next(words))) for _ in range(count)]


def strips_of(corners, distance):
    count = len(corners)
    along = []
    for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
        length = math.hypot(u - x, v - y)
        along.append(((u - x) / length, (v - y) / length))
    strips = []
    for k, (x, y) in enumerate(corners):
        (u, v), (end_x, end_y), (before_u, before_v) = along[k], corners[(k + 1) % count], along[k - 1]
        inwards = (-v * distance, u * distance)
        strips.append(
            [(x, y), (end_x, end_y), (end_x + inwards[0], end_y + inwards[1]), (x + inwards[0], y + inwards[1])]
        )
        if before_u * v - before_v * u < 0:
            reach = distance / (1 + before_u * u + before_v * v)
            tip = (x - reach * (before_v + v), y + reach * (before_u + u))
            before = (x - before_v * distance, y + before_u * distance)
            strips.append([(x, y), before, tip, (x + inwards[0], y + inwards[1])])
    return [Polygon(strip).buffer(0) for strip in strips]


def areas_left(corners, distance):
    """What is left, by its definition, in two ways: where strips meet exactly, GEOS at times loses one."""
    whole, strips = Polygon(corners), strips_of(corners, distance)
    yield whole.difference(unary_union(strips)).area
    for strip in strips:
        whole = whole.difference(strip)
    yield whole.area


compared = 0
for number, line in enumerate(open(sys.argv[1]), 1):
    words = iter(line.split())
    distance = float(next(words))
    corners = read_polygon(words)
    pieces = [Polygon(read_polygon(words)) for _ in range(int(next(words)))]
    where = f"line {number}, distance {distance}, {corners}"
    if not all(piece.is_valid for piece in pieces):
        sys.exit(f"a piece crosses itself: {where}")
    whole = Polygon(corners)
    if not whole.is_valid:
        continue
    small = 1e-6 * whole.area
    together = unary_union(pieces).area if pieces else 0.0
    area = sum(piece.area for piece in pieces)
    if abs(area - together) > small:
        sys.exit(f"pieces overlap: {where}")
    if all(abs(area - expected) > small for expected in areas_left(corners, distance)):
        sys.exit(f"area {area}, not {list(areas_left(corners, distance))}: {where}")
    compared += 1
print(compared)
