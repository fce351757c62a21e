# SPDX-License-Identifier: MIT
"""Edits of the product with one kind of limit or support each, drawn, and what they ask in rows of rows.py."""

import json
import shlex

import numpy as np
import rows
from mesh_lines import MeshLines
from optimality import survey

SETTINGS = ["", "--reach 3 --softness 5 --keep-boundary", "--reach 4"]
PULLS = (0.5, 1, 2, 4)  # mean edges


class Edit:
    """One of the product's, and what it may move."""

    def __init__(self, name, path, random):
        self.name, self.path = name, path
        self.base, self.faces = survey.read_obj(path)
        self.edge = survey.mean_edge(self.base, self.faces)
        self.topology = survey.Topology(self.faces)
        self.used = sorted({v for face in self.faces for v in face})
        self.settings = SETTINGS[random.integers(len(SETTINGS))]
        self.hard = False
        self.handle = int(random.choice(self.used))
        move = random.normal(size=3)
        self.move = move * random.choice(PULLS) / np.linalg.norm(move)
        self.asked, self.limits, self.supports, self.lines, self.surface, self.sheet = [], [], {}, None, None, None

    def words(self):
        move = ",".join(repr(float(x * self.edge)) for x in self.move)
        return ["edit", str(self.path), "--handle", f"{self.handle}+={move}", *self.settings.split(),
                *(["--hard"] if self.hard else []), *self.asked]

    def run(self, planish, scratch):
        out, report = scratch / "out.obj", scratch / "report.json"
        survey.run(planish, [*self.words(), "-o", out, "--report", report])
        self.after, _ = survey.read_obj(out)
        if self.sheet:
            self.limits = rows.sheet(in_edges(self), self.faces, *self.sheet, self.after / self.edge)
        return json.loads(report.read_text())["status"]

    def command(self, planish):
        return shlex.join([str(planish), *self.words()])

    def moving(self):
        """The points that are neither out of reach nor on a boundary that is kept."""
        words = self.settings.split()
        free = {self.handle}
        if "--reach" not in words:
            free = set(self.used)
        for _ in range(int(words[words.index("--reach") + 1]) if "--reach" in words else 0):
            free |= {v for face in self.faces if free.intersection(face) for v in face}
        if "--keep-boundary" in words:
            free -= set(self.topology.boundary) - {self.handle}
        return sorted(free)


def in_edges(edit):
    return edit.base / edit.edge


def bound(edit, name, value):
    edit.asked += ["--bound", f"{name}={value}"]


def state_fold(edit, random):
    most, relative = round(random.uniform(3, 15), 1), bool(random.integers(2))
    bound(edit, "fold", f"+{most}" if relative else most)
    edit.limits = [rows.fold(in_edges(edit), edit.faces, most, relative)]


def state_angle(edit, random):
    least, most = round(random.uniform(45, 75)), round(random.uniform(105, 135))
    bound(edit, "angle", f"{least}:{most}")
    edit.limits = rows.angle(in_edges(edit), edit.faces, least, most)


def lengths(edit):
    return [np.linalg.norm(edit.base[f[k]] - edit.base[f[k - 1]]) for f in edit.faces for k in range(len(f))]


def state_edge(edit, random):
    least, most = random.uniform(0.8, 0.98) * min(lengths(edit)), random.uniform(1.02, 1.2) * max(lengths(edit))
    bound(edit, "edge", f"{least!r}:{most!r}")
    edit.limits = rows.edge(in_edges(edit), edit.faces, least / edit.edge, most / edit.edge)


def state_area(edit, random):
    most = random.uniform(1, 1.2) * max(0.5 * np.linalg.norm(survey.area_vector(edit.base[f])) for f in edit.faces)
    bound(edit, "area", repr(float(most)))
    edit.limits = rows.area(in_edges(edit), edit.faces, most / edit.edge**2)


def state_sheet(edit, random):
    sides = sorted(random.uniform(1, 1.3, size=2) * max(lengths(edit)))
    bound(edit, "sheet", f"{float(sides[0])!r}x{float(sides[1])!r}")
    edit.sheet = (sides[0] / edit.edge, sides[1] / edit.edge)


def state_slide(edit, random):
    most = random.uniform(0.02, 0.4) * edit.edge
    bound(edit, "slide", repr(float(most)))
    edit.limits = [rows.slide(in_edges(edit), edit.faces, most / edit.edge)]


def state_keep_out(edit, random):
    normal = edit.move / np.linalg.norm(edit.move)
    most = normal @ edit.base[edit.handle] + random.uniform(0.05, 0.6) * np.linalg.norm(edit.move) * edit.edge
    edit.asked += ["--keep-out", "plane=" + ",".join(repr(float(x)) for x in [*normal, most])]
    edit.limits = [rows.beyond(in_edges(edit), edit.used, normal, most / edit.edge)]


def hold(edit, text, points, forbidden):
    """The points move across no row of `forbidden`."""
    edit.asked += ["--support", text]
    edit.supports = {v: np.linalg.svd(forbidden)[2][len(forbidden):].T for v in points}


def on_boundary(edit, random):
    """What is about the boundary keeps it nowhere; half of the handles are on it."""
    edit.settings = edit.settings.replace(" --keep-boundary", "")
    if edit.topology.boundary and random.integers(2):
        edit.handle = int(random.choice(edit.topology.boundary))


def state_level(edit, random):
    on_boundary(edit, random)
    axis = int(random.integers(3))
    hold(edit, f"level={'xyz'[axis]}:boundary", edit.topology.boundary, np.eye(3)[axis:axis + 1])


def numbers(values):
    return ",".join(repr(float(x)) for x in values)


def state_plane(edit, random):
    normal = random.normal(size=3)
    text = f"plane={numbers([*normal, normal @ edit.base[edit.handle]])}:{edit.handle}"
    hold(edit, text, [edit.handle], normal[None])


def state_line(edit, random):
    way = random.normal(size=3)
    text = f"line={numbers([*edit.base[edit.handle], *way])}:{edit.handle}"
    hold(edit, text, [edit.handle], np.linalg.svd(way[None])[2][1:])


def state_outline(edit, random):
    on_boundary(edit, random)
    edit.asked += ["--support", "outline:boundary"]
    edit.lines = MeshLines.of_boundary(in_edges(edit), edit.faces)


def state_polyline(edit, random):
    line = MeshLines.straight_on(in_edges(edit), edit.faces, edit.handle, random)
    edit.asked += ["--support", "polyline:" + ",".join(map(str, line))]
    edit.lines = MeshLines(in_edges(edit), [line])


def state_surface(edit, random):
    on_boundary(edit, random)
    edit.asked += ["--support", "surface:boundary"]
    edit.surface = rows.Surface(in_edges(edit), edit.faces).rows(edit.topology.boundary)


def state_all_on_surface(edit, random):
    edit.settings = edit.settings.replace(" --keep-boundary", "")
    edit.asked += ["--support", "surface:all"]
    edit.surface = rows.Surface(in_edges(edit), edit.faces).rows(edit.used)


STATED = {
    "shape": lambda edit, random: None, "fold": state_fold, "angle": state_angle, "edge": state_edge, "area": state_area,
    "sheet": state_sheet, "slide": state_slide, "keep-out": state_keep_out, "level": state_level, "plane": state_plane,
    "line": state_line, "outline": state_outline, "polyline": state_polyline,
    "surface": state_surface, "all on surface": state_all_on_surface}
NEEDS_BOUNDARY = ("level", "outline", "surface")
NEEDS_SMOOTH = ("surface", "all on surface")  # one side [SUP-4], and flat neighbours enough
