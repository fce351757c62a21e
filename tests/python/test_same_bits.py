# SPDX-License-Identifier: MIT
"""The package and the command line are the same program: same bits, same reports, same files."""

import json
import unittest
from pathlib import Path

import numpy as np

import planish
from command import InFolder

#: mesh, words of the command line, the same for planish.edit()
RECIPES = {
    "raised vault": (
        "sample:vault:16",
        ["--handle", "136+=0,0,0.7"],
        {"handles": {136: (0, 0, 0.7)}},
    ),
    "reach, softness, kept boundary": (
        "sample:freeform:12",
        ["--handle", "78+=0.1,0,0.3", "--reach=4", "--softness=6.5", "--keep-boundary"],
        {"handles": {78: (0.1, 0, 0.3)}, "reach": 4, "softness": 6.5, "keep_boundary": True},
    ),
    "two handles, pins, a length": (
        "sample:hex:8",
        ["--handle", "40+=0,0,0.2", "--handle", "60+=0,0,-0.1", "--pin", "3,5", "--reach", "3.5m"],
        {
            "handles": {40: (0, 0, np.float64(0.2)), np.int64(60): np.array([0, 0, -0.1])},
            "pins": [3, 5],
            "reach": "3.5m",
        },
    ),
    "limits": (
        "sample:vault:16",
        "--handle 136+=0,0,0.7 --bound edge=0.8:1.3 --bound fold=+8 --bound sheet=2x3".split(),
        {
            "handles": {136: (0, 0, 0.7)},
            "bounds": {"edge": (0.8, 1.3), "fold": "+8", "sheet": (2, 3)},
        },
    ),
    "supports": (
        "sample:roof:10",
        "--handle 60+=0,0,0.4 --support outline:boundary --support level=x:61".split(),
        {"handles": {60: (0, 0, 0.4)}, "supports": ["outline:boundary", "level=x:61"]},
    ),
    "cuts": (
        "sample:vault:12",
        "--cut strip=60-61@0.25 --cut corner=70:76 --handle 150+=0,0,0.3 --softness 4".split(),
        {
            "cuts": ["strip=60-61@0.25", "corner=70:76"],
            "handles": {150: (0, 0, 0.3)},
            "softness": 4,
        },
    ),
    "circular panels": (
        "sample:dome:12",
        ["--handle", "78+=0,0,0.2", "--constraint", "circular:1e-8"],
        {"handles": {78: (0, 0, 0.2)}, "constraints": {"circular": 1e-8}},
    ),
    "the paper's engine, its weights": (
        "sample:roof:8",
        "--handle 40+=0,0,0.3 --solver alm --locality 2 --smoothness=0.5 --attraction=500 "
        "--fairness laplacian --bound shape=off".split(),
        {
            "handles": {40: (0, 0, 0.3)},
            "solver": "alm",
            "locality": 2,
            "smoothness": 0.5,
            "attraction": 500,
            "fairness": "laplacian",
            "bounds": {"shape": False},
        },
    ),
}


def without_times(report):
    return {key: value for key, value in report.items() if key != "seconds"}


class SameBits(InFolder):
    def check_report(self, name, report):
        recorded = json.loads(Path(name).read_text())
        self.assertEqual(without_times(recorded), without_times(report.json))

    def check_file(self, name, shape):
        shape.save("mine_" + name)
        self.assertEqual(Path(name).read_bytes(), Path("mine_" + name).read_bytes(), name)

    def test_edits(self):
        for title, (mesh, words, options) in RECIPES.items():
            with self.subTest(title):
                files = ["-o", "e.obj", "--report", "e.report", "--design", "e.json"]
                self.command("edit", mesh, *words, *files)
                edit = planish.edit(planish.Mesh.read(mesh), **options)
                self.assertGreater(len(edit.moved), 0)
                self.check_file("e.obj", edit)
                self.check_file("e.json", edit)
                self.check_report("e.report", edit.report)
                command = planish.Mesh.read("e.obj").points
                self.assertEqual(command.tobytes(), edit.positions.tobytes())

    def test_absolute_handles(self):
        mesh = planish.Mesh.read("sample:vault:16")
        target = mesh.points[136] + (0, 0, 0.7)
        edit = planish.edit(mesh, {136: target}, relative=False)
        same = planish.edit(mesh, {136: (0, 0, 0.7)})
        self.assertEqual(edit.positions.tobytes(), same.positions.tobytes())

    def test_arrays_give_what_files_give(self):
        mesh = planish.Mesh.read("sample:trihex:8")
        again = planish.Mesh(mesh.points, mesh.faces)
        handles = {30: (0, 0, 0.2)}
        one, other = planish.edit(mesh, handles), planish.edit(again, handles)
        self.assertEqual(one.positions.tobytes(), other.positions.tobytes())

    def test_exploration(self):
        words = ["sample:vault:16", "--handle", "136+=0,0,0.7", "--dimension", "3"]
        sliders = ["--coefficients", "0.3,-0.1,0"]
        family = planish.edit(planish.Mesh.read("sample:vault:16"), {136: (0, 0, 0.7)}).explore(3)
        shown = family([0.3, -0.1, 0])
        for title, variation, more in (("shown", shown, []), ("exact", shown.exact(), ["--exact"])):
            with self.subTest(title):
                files = ["-o", "v.glb", "--report", "v.report", "--design", "v.json"]
                self.command("explore", *words, *sliders, *more, *files)
                self.check_file("v.glb", variation)
                self.check_file("v.json", variation)
                self.check_report("v.report", variation.report)
        self.assertEqual(family.dimension, 3)
        self.assertRegex(shown.messages[-1], "out of flat, as the sliders show them; exact makes")

    def test_a_mesh_that_is_not_flat_is_planarised_first(self):
        mesh = planish.Mesh.read("sample:vault:12")
        points = mesh.points.copy()
        points[70, 2] += 0.05
        planish.Mesh(points, mesh.faces).write("bumpy.obj")
        said = self.command("edit", "bumpy.obj", "--handle=40+=0,0,0.2", "-o", "e.obj")
        edit = planish.edit(planish.Mesh.read("bumpy.obj"), {40: (0, 0, 0.2)})
        self.check_file("e.obj", edit)
        self.assertIn(edit.messages[0], said)
        self.assertGreater(edit.report.planarised_first["max_move"], 0)

    def test_projections(self):
        mesh = planish.Mesh.read("sample:vault:12")
        points = mesh.points.copy()
        points[70, 2] += 0.05
        bumpy = planish.Mesh(points, (mesh.offsets, mesh.corners))
        bumpy.write("bumpy.obj")
        mesh.write("base.obj")
        cases = [
            ([], {}, 0),
            (["--smooth=0", "--keep-boundary"], {"smooth": 0, "keep_boundary": True}, 0),
            (["--reference", "base.obj", "--pin=0,1"], {"reference": mesh, "pins": [0, 1]}, 0),
            (["--within=0.02"], {"within": 0.02}, 4),
            (["--bound=flat=2", "--bound=shape=off"], {"bounds": {"flat": 2, "shape": False}}, 0),
        ]
        for words, options, code in cases:
            with self.subTest(words):
                files = ["-o", "p.glb", "--report", "p.report"]
                said = self.command("project", "bumpy.obj", *words, *files, code=code)
                projection = planish.project(bumpy, **options)
                messages = [f"planish: {message}\n" for message in projection.messages]
                self.assertEqual("".join(messages), said.replace("--", ""))
                self.check_file("p.glb", projection)
                self.check_report("p.report", projection.report)

    def test_offsets(self):
        mesh = planish.Mesh.read("sample:dome:12")
        for words, options in (([], {}), (["--kind=parallel"], {"kind": "parallel"})):
            self.command("offset", "sample:dome:12", "--distance=-0.25", *words, "-o", "o.obj",
                         "--report", "o.report")
            offset = planish.offset(mesh, -0.25, **options)
            self.check_file("o.obj", offset)
            self.check_report("o.report", offset.report)

    def test_hybrid_projections(self):
        Path("bent.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0.4\nv 0 1 0\nf 1 2 3 4\n")
        self.command("project", "bent.obj", "--pin=0,1,2,3", "--split=1", "-o", "h.obj", "--report",
                     "h.report")
        flat = planish.project(planish.Mesh.read("bent.obj"), pins=[0, 1, 2, 3], split=1)
        self.check_file("h.obj", flat)
        self.check_report("h.report", flat.report)
        self.assertEqual(flat.report.split["panels"], 1)

    def test_fewer_types(self):
        self.command("project", "sample:freeform:8", "--within=1%", "--move=20%", "-o", "t.obj", "--report",
                     "t.report")
        fewer = planish.project(planish.Mesh.read("sample:freeform:8"), within="1%", move="20%")
        self.check_file("t.obj", fewer)
        self.check_report("t.report", fewer.report)
        self.assertLess(fewer.report.types["after"], fewer.report.types["before"])

    def test_few_to_make_again(self):
        self.command("edit", "sample:vault:16", "--handle=136+=0,0,0.3", "--softness=5", "--reach=4",
                     "--bound=fold=+15", "--fewest=panels", "-o", "f.obj", "--report", "f.report")
        edit = planish.edit(planish.Mesh.read("sample:vault:16"), {136: (0, 0, 0.3)}, softness=5,
                            reach=4, bounds={"fold": "+15"}, fewest="panels")
        self.check_file("f.obj", edit)
        self.check_report("f.report", edit.report)
        self.assertTrue(edit.report.fewest["minimal"])

    def test_fair(self):
        self.command("edit", "sample:vault:13", "--handle=84+=0,0,0.7", "--softness=5", "--reach=4",
                     "--keep-boundary", "--fair", "-o", "f.obj", "--report", "f.report")
        edit = planish.edit(planish.Mesh.read("sample:vault:13"), {84: (0, 0, 0.7)}, softness=5, reach=4,
                            keep_boundary=True, fair=True)
        self.check_file("f.obj", edit)
        self.check_report("f.report", edit.report)
        self.assertTrue(edit.report.fair["bounds"])

    def test_split_where_needed(self):
        self.command("edit", "sample:vault:12", "--handle=26+=0,0,0.9", "--softness=3", "--reach=2",
                     "--keep-boundary", "--bound=fold=+12", "--split-where-needed=1", "-o", "s.obj",
                     "--report", "s.report")
        edit = planish.edit(planish.Mesh.read("sample:vault:12"), {26: (0, 0, 0.9)}, softness=3, reach=2,
                            keep_boundary=True, bounds={"fold": "+12"}, split_where_needed=1)
        self.check_file("s.obj", edit)
        self.check_report("s.report", edit.report)
        self.assertEqual([standing["cuts"] for standing in edit.report.splits["curve"]], [0, 1])

    def test_types(self):
        mesh = planish.Mesh.read("sample:vault:12")
        for words, options in (([], {}), (["--joint=4:24"], {"joint": (4, 24)}),
                               (["--within=2%", "--mirrored", "--unit=cm", "--angle=2"],
                                {"within": "2%", "mirrored": True, "unit": "cm", "angle": 2})):
            self.command("types", "sample:vault:12", *words, "-o", "t.csv", "--report", "t.report")
            types = planish.types(mesh, **options)
            types.save("mine.csv")
            self.assertEqual(Path("mine.csv").read_bytes(), Path("t.csv").read_bytes())
            self.check_report("t.report", types.report)
            self.assertEqual(types.messages, [])
            for number, template in enumerate(types.report.templates):
                self.assertEqual((types.of_panel == number).nonzero()[0].tolist(),
                                 template["panels"])

    def test_info(self):
        self.command("info", "sample:hex:8", "--report", "i.report")
        self.check_report("i.report", planish.info(planish.Mesh.read("sample:hex:8")))

    def test_designs(self):
        self.command("edit", "sample:vault:16", "--handle=136+=0,0,0.7", "--design", "d.json")
        design = planish.Design.load("d.json")
        self.assertEqual(design.recipe["handles"][0][0], 136)
        replay = design.replay()
        self.assertIs(replay.verified, True)
        self.assertEqual(replay.deviation, 0)
        self.assertEqual(replay.design, design)
        self.command("replay", "d.json", "-o", "r.glb", "--report", "r.report")
        self.check_file("r.glb", replay)
        self.check_report("r.report", replay.report)
        self.assertEqual(planish.Design.load("r.glb").replay().positions.tobytes(),
                         replay.positions.tobytes())

    def test_a_design_of_arrays_holds_its_base(self):
        mesh = planish.Mesh.read("sample:vault:12")
        edit = planish.edit(planish.Mesh(mesh.points, mesh.faces), {70: (0, 0, 0.4)})
        edit.save("a.json")
        self.command("replay", "a.json", "-o", "a.obj")
        self.check_file("a.obj", edit)

    def test_every_option_of_the_command_is_taken(self):
        for command in ("edit", "explore", "project", "offset", "types"):
            help_text = self.help_of(command)
            for name in planish.options(command):
                self.assertIn("--" + name.replace("_", "-"), help_text)

    def help_of(self, command):
        import subprocess

        from command import COMMAND

        return subprocess.run([COMMAND, command, "--help"], capture_output=True, text=True,
                              check=True).stdout


if __name__ == "__main__":
    unittest.main()
