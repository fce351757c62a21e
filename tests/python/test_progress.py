# SPDX-License-Identifier: MIT
"""Long solves: watched, stopped, interrupted, and never in the way of other threads."""

import threading
import unittest

import numpy as np

import planish
from command import InFolder


class Progress(InFolder):
    def setUp(self):
        super().setUp()
        self.mesh = planish.Mesh.read("sample:vault:16")
        self.handles = {136: (0, 0, 0.7)}

    def test_every_step_is_told_and_changes_nothing(self):
        steps = []
        edit = planish.edit(self.mesh, self.handles, progress=lambda *step: steps.append(step))
        self.assertEqual([step[0] for step in steps], list(range(1, len(steps) + 1)))
        self.assertGreater(len(steps), 1)
        quiet = planish.edit(self.mesh, self.handles)
        self.assertEqual(edit.positions.tobytes(), quiet.positions.tobytes())

    def test_false_stops_with_a_valid_design(self):
        told = []

        def stop(step, objective, residual):
            told.append(step)
            return False

        edit = planish.edit(self.mesh, self.handles, progress=stop)
        self.assertEqual(edit.report.status, "cancelled")
        self.assertEqual(told, [1])
        self.assertLessEqual(edit.mesh.info().planarity_mm_per_m["max"], 1e-6)

    def test_a_stop_while_the_base_becomes_flat_leaves_the_mesh_as_given(self):
        points = self.mesh.points.copy()
        points[100, 2] += 0.05
        bumpy = planish.Mesh(points, self.mesh.faces)
        edit = planish.edit(bumpy, self.handles, progress=lambda *step: False)
        self.assertEqual(edit.report.status, "cancelled")
        self.assertEqual(edit.positions.tobytes(), points.tobytes())
        self.assertEqual(len(edit.moved), 0)

    def test_what_the_callback_raises_comes_through(self):
        class Impatience(Exception):
            pass

        def complain(step, objective, residual):
            raise Impatience(step)

        for call in (
            lambda: planish.edit(self.mesh, self.handles, progress=complain),
            lambda: planish.edit(self.mesh, self.handles).explore(2, progress=complain),
            lambda: planish.edit(self.mesh, self.handles).design.replay(progress=complain),
        ):
            with self.assertRaises(Impatience):
                call()

    def test_families_and_projections_can_be_stopped(self):
        edit = planish.edit(self.mesh, self.handles)
        edit.explore(4, progress=lambda *step: False)
        points = self.mesh.points + np.random.default_rng(1).normal(0, 0.01, (256, 3))
        bumpy = planish.Mesh(points, self.mesh.faces)
        projection = planish.project(bumpy, progress=lambda *step: False)
        self.assertEqual(projection.report.status, "cancelled")

    def test_other_threads_run_during_a_solve(self):
        # The callback holds the solve until another thread has run: with the interpreter's lock
        # kept by the solver, that thread could never answer.
        asked, answered = threading.Event(), threading.Event()
        thread = threading.Thread(target=lambda: asked.wait(60) and answered.set())
        thread.start()

        def ask(step, objective, residual):
            asked.set()
            return answered.wait(60)

        edit = planish.edit(self.mesh, self.handles, progress=ask)
        thread.join()
        self.assertEqual(edit.report.status, "converged")

    def test_edits_in_two_threads_are_those_of_one(self):
        results = {}

        def work(vertex):
            edit = planish.edit(self.mesh, {vertex: (0, 0, 0.5)})
            results[vertex] = edit.positions.tobytes()

        threads = [threading.Thread(target=work, args=(v,)) for v in (100, 136, 152)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for vertex in (100, 136, 152):
            alone = planish.edit(self.mesh, {vertex: (0, 0, 0.5)})
            self.assertEqual(results[vertex], alone.positions.tobytes())


if __name__ == "__main__":
    unittest.main()
