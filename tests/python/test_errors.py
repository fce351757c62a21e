# SPDX-License-Identifier: MIT
"""Wrong use is an exception with one sentence that names the field, the core's where it has one."""

import unittest

import numpy as np

import planish
from command import InFolder

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]

#: What is wrong with arguments of planish.edit() on sample:vault:8, handle 20, and the sentence.
OPTIONS = [
    ({"softness": 0}, "softness must be from 1 to 10"),
    ({"softness": 11}, "softness must be"),
    ({"softness": 3, "locality": 2}, "softness takes the place of locality and smoothness"),
    ({"locality": -1}, "locality must be"),
    ({"locality": float("nan")}, 'locality: "nan" is not finite'),
    ({"locality": "much"}, 'locality: "much" is not a number'),
    ({"attraction": 0}, "attraction must be"),
    ({"tolerance": 0}, "tolerance must be"),
    ({"reach": 0}, "reach must be at least 1 face ring"),
    ({"reach": 2.5}, 'reach: "2.5" is not a whole number'),
    ({"reach": "2 miles"}, 'reach: "miles" is none of mm, cm, m, km, in, ft'),
    ({"model_unit": "yard"}, 'model_unit: "yard" is none of mm, cm, m, km, in, ft'),
    ({"fairness": "fourth"}, 'fairness: "fourth" is none of laplacian, second, third'),
    ({"sparsity": "l0"}, 'sparsity: "l0" is none of l21, l2, none'),
    ({"solver": "magic"}, 'solver: "magic" is none of newton, alm'),
    ({"bounds": {"weight": 3}}, 'bound: "weight=3" is none of shape=on, shape=off, fold='),
    ({"bounds": {"angle": (90, 60)}}, "angle"),
    ({"constraints": ["square"]}, "constraints: a kind must be one of circular, conical"),
    ({"pins": [64]}, "pin: there is no vertex 64; the mesh has 64 (from 0)"),
    ({"cuts": ["saw=1"]}, '"saw=1" is no cut: there are split=F:A,B, strip=V-W@T'),
    ({"cuts": [3]}, '"3" is no cut: there are split=F:A,B, strip=V-W@T'),
    ({"cuts": "split=0:0,1"}, "split=0:0,1: points 0 and 1 are neighbours"),
    ({"keep_boundary": 1}, "keep_boundary must be True or False"),
    ({"colour": "blue"}, "unknown option colour"),
    ({"handles": {}}, "handle is missing"),
    ({"handles": {64: (0, 0, 1)}}, "handle: there is no vertex 64; the mesh has 64 (from 0)"),
    ({"handles": {-1: (0, 0, 1)}}, "handle: there is no vertex -1"),
    ({"handles": {1.5: (0, 0, 1)}}, 'handle: "1.5" is not a whole number'),
    ({"handles": {20: (0, 1)}}, 'handle: "20+=0,1" needs 3 coordinates'),
    ({"handles": {20: (0, 0, "up")}}, 'handle: "up" is not a number'),
    ({"pins": [20]}, "20"),
]

#: Points, faces, and the sentence.
MESHES = [
    (np.zeros((4, 2)), [(0, 1, 2)], "points must be an array of shape (n, 3)"),
    ("far away", [(0, 1, 2)], "points must be an array of shape (n, 3)"),
    (SQUARE, 7, "faces must be index tuples or (offsets, corners)"),
    (SQUARE, [(0, 1, 2.5)], "faces must be whole numbers"),
    (SQUARE, [(0, 1, -2)], "corners[2] is -2, no index from 0"),
    (SQUARE, [(0, 1, 2**40)], "is 1099511627776, no index from 0"),
    (SQUARE, [(0, 1, 4)], "4"),
    (SQUARE, [(0, 1)], "2"),
    (SQUARE, [], "no faces"),
    (SQUARE, (np.array([1, 4]), np.array([0, 1, 2, 3])), "offsets must begin with 0"),
    (SQUARE, (np.array([0, 3, 2]), np.array([0, 1, 2, 3])), "offsets[2] is less than the one"),
    (SQUARE, (np.array([0, 3]), np.array([0, 1, 2, 3])), "offsets end with 3, but there are 4"),
    ([(0, 0, 0), (1, 0, 0), (np.nan, 1, 0)], [(0, 1, 2)], "finite"),
]


class Errors(InFolder):
    def assert_says(self, kind, sentence, call, /, *arguments, **options):
        with self.assertRaises(kind) as caught:
            call(*arguments, **options)
        said = str(caught.exception)
        self.assertIn(sentence, said)
        self.assertNotIn("--", said)
        self.assertNotIn("\n", said)

    def test_options(self):
        mesh = planish.Mesh.read("sample:vault:8")
        for options, sentence in OPTIONS:
            with self.subTest(options):
                options = {"handles": {20: (0, 0, 0.1)}, **options}
                self.assert_says(planish.UsageError, sentence, planish.edit, mesh, **options)

    def test_meshes(self):
        for points, faces, sentence in MESHES:
            with self.subTest(sentence):
                self.assert_says(planish.MeshError, sentence, planish.Mesh, points, faces)

    def test_files(self):
        read, mesh = planish.Mesh.read, planish.Mesh.read("sample:vault:8")
        self.assert_says(planish.MeshError, "none.obj: cannot be opened", read, "none.obj")
        self.assert_says(planish.UsageError, "the extension must be .obj", read, "mesh.stl")
        self.assert_says(planish.UsageError, "the extension must be .obj", mesh.write, "mesh.stl")
        self.assert_says(planish.MeshError, "no/a.obj: cannot be written", mesh.write, "no/a.obj")
        self.assert_says(planish.UsageError, 'no sample "tent"', read, "sample:tent:8")
        with open("bad.obj", "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 1 zero 0\n")
        self.assert_says(planish.MeshError, "bad.obj: line 2", read, "bad.obj")

    def test_families(self):
        mesh = planish.Mesh.read("sample:vault:8")
        edit = planish.edit(mesh, {20: (0, 0, 0.1)})
        self.assert_says(planish.UsageError, "dimension", edit.explore, 0)
        self.assert_says(planish.UsageError, "dimension", edit.explore, 25)
        self.assert_says(planish.UsageError, "coefficients needs 2 values, here are 3",
                         edit.explore(2), [1, 2, 3])
        dome = planish.Mesh.read("sample:dome:12")
        circular = planish.edit(dome, {66: (0, 0, 0.3)}, constraints=["circular"])
        self.assertEqual(circular.explore(2).dimension, 2)
        bounded = planish.edit(mesh, {20: (0, 0, 0.1)}, bounds={"fold": 60})
        self.assertEqual(bounded.explore(2).dimension, 2)

    def test_projections_and_offsets(self):
        mesh = planish.Mesh.read("sample:vault:8")
        other = planish.Mesh.read("sample:vault:9")
        self.assert_says(planish.MeshError, "the reference must have the faces",
                         planish.project, mesh, reference=other)
        self.assert_says(planish.UsageError, "limits are for edit",
                         planish.project, mesh, bounds={"fold": 20})
        self.assert_says(planish.UsageError, "kind must be face, vertex or parallel",
                         planish.offset, mesh, 1, kind="inside")
        self.assert_says(planish.MeshError, "flat", planish.offset, bumpy(), 1)

    def test_designs(self):
        self.assert_says(planish.MeshError, "", planish.Design, "{")
        recipe = planish.edit(planish.Mesh.read("sample:vault:8"), {20: (0, 0, 0.1)}).design.recipe
        self.assert_says(planish.MeshError, "colour", planish.Design, {**recipe, "colour": 1})
        design = planish.Design({**recipe, "source": {"file": "roof.obj"}})
        self.assert_says(planish.MeshError, "roof.obj", design.replay)
        self.assert_says(planish.UsageError, "must be .json", design.save, "design.txt")

    def test_all_are_errors_of_the_package_and_value_errors(self):
        for kind in (planish.UsageError, planish.MeshError):
            self.assertTrue(issubclass(kind, planish.Error))
            self.assertTrue(issubclass(kind, ValueError))


def bumpy():
    mesh = planish.Mesh.read("sample:vault:8")
    points = mesh.points.copy()
    points[20, 2] += 0.1
    return planish.Mesh(points, mesh.faces)


if __name__ == "__main__":
    unittest.main()
