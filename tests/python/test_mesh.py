# SPDX-License-Identifier: MIT
"""Meshes in and out: arrays, files, other libraries' meshes, pictures."""

import copy
import pickle
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

import planish
from command import InFolder

POINTS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 1), (2, 1, 1.0)])
FACES = [(0, 1, 2, 3), (1, 4, 5, 2)]


class Meshes(InFolder):
    def assert_same(self, one, other):
        self.assertEqual(one.points.tobytes(), other.points.tobytes())
        self.assertEqual(one.faces, other.faces)

    def test_faces_come_as_tuples_as_an_array_or_as_offsets_and_corners(self):
        mesh = planish.Mesh(POINTS, FACES)
        self.assertEqual(mesh.faces, FACES)
        self.assert_same(mesh, planish.Mesh(POINTS.tolist(), np.array(FACES)))
        self.assert_same(mesh, planish.Mesh(POINTS, (mesh.offsets, mesh.corners)))
        self.assert_same(mesh, planish.Mesh(np.asfortranarray(POINTS), tuple(FACES)))

    def test_arrays_are_windows_that_nobody_writes_and_that_outlive_the_mesh(self):
        mesh = planish.Mesh(POINTS, FACES)
        points = mesh.points
        for array in (points, mesh.offsets, mesh.corners):
            with self.assertRaises(ValueError):
                array[0] = 1
        del mesh
        self.assertTrue(np.array_equal(points, POINTS))

    def test_the_given_array_may_change_afterwards(self):
        points = POINTS.copy()
        mesh = planish.Mesh(points, FACES)
        points[:] = 7
        self.assertTrue(np.array_equal(mesh.points, POINTS))

    def test_every_format_holds_every_bit(self):
        mesh = planish.Mesh.read("sample:trihex:6")
        for extension in ("obj", "off", "ply", "glb"):
            mesh.write(f"m.{extension}")
            self.assert_same(planish.Mesh.read(f"m.{extension}"), mesh)

    def test_compas_meshes_go_in_and_out(self):
        class CompasMesh:
            """The part of compas.datastructures.Mesh that is used."""

            def to_vertices_and_faces(self):
                return POINTS.tolist(), [list(face) for face in FACES]

        mesh = planish.Mesh.of(CompasMesh())
        self.assertEqual(mesh.faces, FACES)
        self.assert_same(planish.Mesh.of(mesh), mesh)
        self.assert_same(planish.Mesh.of(mesh.to_vertices_and_faces()), mesh)

    def test_meshes_travel_between_processes(self):
        mesh = planish.Mesh(POINTS, FACES)
        self.assert_same(pickle.loads(pickle.dumps(mesh)), mesh)
        report = mesh.info()
        self.assertEqual(pickle.loads(pickle.dumps(report)), report)
        self.assertEqual(copy.deepcopy(report), report)

    def test_own_points_are_joined_and_panels_turned_as_the_command_does_it(self):
        apart = [*POINTS[:4], *POINTS[[1, 2, 4]], (2, 1, 1.001)]
        mesh = planish.Mesh(apart, [(0, 1, 2, 3), (4, 5, 7, 6)])
        mesh.write("apart.obj")
        whole = planish.convert(mesh, join_points=True, orient=True)
        self.assertEqual(len(whole), 6)
        self.assertEqual(whole.faces, [(0, 1, 2, 3), (1, 4, 5, 2)])
        self.assertRegex(whole.warnings[0], "^2 vertices were joined")
        self.assertEqual(whole.warnings[1], "1 panel was turned over")
        self.command("convert", "apart.obj", "-o", "whole.obj", "--join-points", "--orient")
        self.assert_same(planish.Mesh.read("whole.obj"), whole)
        self.assertEqual(len(planish.convert(mesh, join_points=0.01)), 6)
        self.assertEqual(len(planish.convert(mesh, join_points=False)), 8)
        triangles = planish.Mesh(POINTS[:4], [(0, 1, 2), (0, 2, 3)])
        self.assertEqual(planish.convert(triangles, join_triangles=True).faces, [(0, 1, 2, 3)])
        with self.assertRaisesRegex(planish.MeshError, "half the shortest side"):
            planish.convert(mesh, join_points=0.9)
        with self.assertRaisesRegex(planish.UsageError, "glue"):
            planish.convert(mesh, glue=1)
        self.assertEqual(
            set(planish.options("convert")), {"join_points", "orient", "join_triangles"}
        )

    def test_odd_meshes_are_taken_with_a_warning(self):
        mesh = planish.Mesh([*POINTS, (9, 9, 9)], FACES)
        self.assertEqual(len(mesh.warnings), 1)
        self.assertEqual(planish.Mesh(POINTS, FACES).warnings, [])

    def test_results_show_themselves_in_notebooks(self):
        mesh = planish.Mesh.read("sample:vault:12")
        edit = planish.edit(mesh, {70: (0, 0, 0.4)}, reach=2)
        touched = sum(not set(edit.moved).isdisjoint(face) for face in mesh.faces)
        plain, tinted = self.colours(mesh), self.colours(edit)
        self.assertEqual(len(plain), len(mesh.faces))
        self.assertEqual(sum(is_blue(colour) for colour in plain), 0)
        self.assertEqual(sum(is_blue(colour) for colour in tinted), touched)

    def colours(self, shown):
        figure = ElementTree.fromstring(shown._repr_html_())
        return [p.get("fill") for p in figure.iter("{http://www.w3.org/2000/svg}polygon")]

    def test_large_meshes_show_the_panels_about_the_edit_and_say_so(self):
        mesh = planish.Mesh.read("sample:vault:70")
        self.assertEqual(len(self.colours(mesh)), 4000)
        self.assertIn(f"{len(mesh.faces) - 4000} panels not drawn", mesh._repr_html_())


def is_blue(colour):
    red, _, blue = bytes.fromhex(colour[1:])
    return blue > 2 * red


if __name__ == "__main__":
    unittest.main()
