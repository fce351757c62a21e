# SPDX-License-Identifier: MIT
"""Where a mesh can move, by the command, in Python and on a cluster: the same bytes."""

import importlib.util
import json
import unittest
from pathlib import Path

import numpy as np

import planish
from command import InFolder

SAMPLE = "sample:vault:10"
WORDS = ["--vertices", "33,44,12", "--range=0.5", "--steps=4", "--bound=fold=+8"]
OPTIONS = {"vertices": [12, 44, 33], "range": 0.5, "steps": 4, "bounds": {"fold": "+8"}}


class MobilityTests(InFolder):
    def check_file(self, name, mobility):
        mobility.save("mine_" + name)
        self.assertEqual(Path(name).read_bytes(), Path("mine_" + name).read_bytes(), name)

    def test_the_best_places_are_rows_of_all(self):
        self.command("mobility", SAMPLE, "-o", "all.json")
        self.command("mobility", SAMPLE, "--best", "3", "-o", "best.json")
        rows = json.loads(Path("all.json").read_text())["rows"]
        best = json.loads(Path("best.json").read_text())["rows"]
        self.assertEqual(len(best), 3)
        self.assertTrue(all(row in rows for row in best))
        self.assertTrue(all(abs(row["direction"][2]) == 1 for row in best))
        farthest = max(row["distance"] for row in rows if abs(row["direction"][2]) == 1)
        self.assertEqual(best[0]["distance"], farthest)

    def test_every_format_has_the_bytes_of_the_command(self):
        mobility = planish.mobility(planish.Mesh.read(SAMPLE), **OPTIONS)
        for name in ("m.json", "m.csv", "m.glb"):
            self.command("mobility", SAMPLE, *WORDS, "-o", name)
            self.check_file(name, mobility)
        rows = json.loads(Path("m.json").read_text())["rows"]
        self.assertEqual([row["vertex"] for row in rows], [12] * 4 + [33] * 4 + [44] * 4)
        self.assertEqual([row["distance"] for row in rows], mobility.distance.tolist())
        self.assertEqual([row["limit"] for row in rows], mobility.limit.tolist())
        self.assertEqual(np.array([row["direction"] for row in rows]).tolist(),
                         mobility.direction.tolist())
        lines = Path("m.csv").read_text().splitlines()
        self.assertEqual(lines[0], "vertex,dx,dy,dz,distance,limit,remake,sharpest_fold")
        self.assertEqual(len(lines), 13)
        again = planish.Mesh.read("m.glb")
        self.assertEqual(again.points.tobytes(), planish.Mesh.read(SAMPLE).points.tobytes())

    def test_a_glb_is_coloured_where_it_was_measured(self):
        self.command("mobility", SAMPLE, *WORDS, "-o", "m.glb")
        data = Path("m.glb").read_bytes()
        size = int.from_bytes(data[12:16], "little")
        scene, buffer = json.loads(data[20 : 20 + size]), data[28 + size :]
        accessor = scene["accessors"][scene["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]]
        begin = scene["bufferViews"][accessor["bufferView"]].get("byteOffset", 0)
        colours = np.frombuffer(buffer, np.uint8, 4 * accessor["count"], begin).reshape(-1, 4)
        still = (colours == colours[0]).all(axis=1)
        self.assertEqual(np.flatnonzero(~still).tolist(), [12, 33, 44])

    def test_parts_and_threads_give_the_same_rows(self):
        self.command("mobility", SAMPLE, *WORDS, "--threads=1", "-o", "one.csv")
        self.command("mobility", SAMPLE, *WORDS, "--threads=3", "-o", "three.csv")
        self.assertEqual(Path("one.csv").read_bytes(), Path("three.csv").read_bytes())
        joined = Path("one.csv").read_text().splitlines(True)[:1]
        for k in (1, 2):
            self.command("mobility", SAMPLE, *WORDS, f"--part={k}/2", "-o", f"{k}.csv")
            joined += Path(f"{k}.csv").read_text().splitlines(True)[1:]
        self.assertEqual("".join(joined), Path("one.csv").read_text())

    def test_an_estimate_says_what_all_vertices_would_take(self):
        self.command("mobility", SAMPLE, *WORDS, "--estimate", "-o", "e.json")
        said = json.loads(Path("e.json").read_text())
        self.assertEqual((said["vertices"], said["sampled"]), (3, 3))
        self.assertAlmostEqual(said["seconds"], 3 * said["seconds_per_vertex"])

    def test_it_can_be_stopped_and_says_how_far_it_is(self):
        seen = []
        mesh = planish.Mesh.read(SAMPLE)
        options = {"range": 0.05, "steps": 1}
        mobility = planish.mobility(
            mesh, **options, progress=lambda done, total: seen.append((done, total)) or False)
        self.assertEqual(seen, [(64, 100)])
        self.assertEqual(len(mobility), 4 * 64)
        self.assertEqual(len(planish.mobility(mesh, **options)), 4 * 100)

    def test_errors_name_the_field(self):
        mesh = planish.Mesh.read(SAMPLE)
        for options, said in [({"vertices": [100]}, "vertices: the mesh has vertices 0 to 99"),
                              ({"range": -1}, "range must be greater than 0"),
                              ({"threads": 0}, "threads must be from 1 to 256"),
                              ({"hard": True}, "unknown option hard")]:
            with self.subTest(said), self.assertRaisesRegex(planish.UsageError, said):
                planish.mobility(mesh, **options)
        self.command("mobility", SAMPLE, "-o", "m.obj", code=2)

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "no dask.distributed")
    def test_a_cluster_measures_the_same(self):
        from distributed import Client, LocalCluster

        mesh = planish.Mesh.read(SAMPLE)
        options = {"range": 0.05, "steps": 1}
        with LocalCluster(n_workers=2, processes=False, dashboard_address=None) as cluster:
            with Client(cluster) as client:
                there = planish.mobility(mesh, **options, client=client)
        here = planish.mobility(mesh, **options)
        there.save("there.json")
        here.save("here.json")
        self.assertEqual(Path("there.json").read_bytes(), Path("here.json").read_bytes())


if __name__ == "__main__":
    unittest.main()
