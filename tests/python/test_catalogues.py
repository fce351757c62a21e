# SPDX-License-Identifier: MIT
"""The catalogue of a sweep: what is in the folder, and what is not done twice."""

import base64
import json
import os
import re
import subprocess
import sys
import unittest
import zlib
from pathlib import Path

import planish
from command import InFolder

PLAN = {
    "design": {
        "format": "planish-design",
        "version": 1,
        "source": {"sample": "vault", "size": 8},
        "handles": [[36, 4, 4, 3]],
        "options": {"shape": True},
    },
    "values": {"handles[0][0]": [36, 37, 4000]},
}


class Catalogues(InFolder):
    def setUp(self):
        super().setUp()
        self.jobs = list(planish.Plan(PLAN))
        for job in self.jobs:
            job.run("out")

    def table(self):
        text = Path("catalogue/designs.js").read_text(encoding="utf-8")
        return json.loads(text.removeprefix("planishCatalogue = ").removesuffix(";\n"))

    def test_a_row_a_design_with_picture_file_and_a_link_that_holds_it(self):
        planish.catalogue("out", "catalogue", page="../page/", title="Two of three")
        table = self.table()
        self.assertEqual(table["title"], "Two of three")
        self.assertEqual([row["id"] for row in table["designs"]],
                         sorted(job.id for job in self.jobs))
        self.assertEqual(table["columns"][0], {"name": "handles[0][0]", "kind": "value"})
        planish.gather("out", "results.csv")
        self.assertEqual(Path("results.csv").read_bytes(),
                         Path("catalogue/results.csv").read_bytes())
        doors = {row["cells"][0]: row for row in table["designs"]}
        for vertex in (36, 37):
            row = doors[vertex]
            self.assertIn("<polygon", Path("catalogue", row["picture"]).read_text())
            packed = row["link"].removeprefix("../page/#v2=")
            unpacker = zlib.decompressobj(zdict=planish._core.link_dictionary())
            text = unpacker.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4)))
            self.assertEqual(planish.Design(text.decode()),
                             planish.Design.load(Path("catalogue", row["file"])))
        self.assertEqual({doors[4000][key] for key in ("picture", "file", "link")}, {None})

    def test_pictures_that_are_there_are_kept_and_a_stop_leaves_a_catalogue(self):
        told = []

        def stop(done, total):
            told.append((done, total))
            return False

        planish.catalogue("out", "catalogue", progress=stop)
        self.assertEqual(told, [(1, 2)])
        self.assertEqual(len(self.table()["designs"]), 3)
        planish.catalogue("out", "catalogue")
        pictures = list(Path("catalogue/pictures").iterdir())
        self.assertEqual(len(pictures), 2)
        times = [os.stat(path).st_mtime_ns for path in pictures]
        planish.catalogue("out", "catalogue", progress=lambda *_: self.fail("done again"))
        self.assertEqual([os.stat(path).st_mtime_ns for path in pictures], times)
        self.assertIsNone(self.table()["designs"][0]["link"])  # nobody said where the editor is

    def test_panels_are_coloured_by_their_move_on_one_scale(self):
        plan = planish.Plan({**PLAN, "values": {"handles[0].by[2]": [0.1, 0.8]}})
        for job in plan:
            job.run("lifted")
        planish.catalogue("lifted", "catalogue")
        columns = [column["name"] for column in self.table()["columns"]]
        moves = {row["cells"][columns.index("handles[0].by[2]")]:
                 (row["cells"][columns.index("max_displacement")], Path("catalogue", row["picture"]))
                 for row in self.table()["designs"]}
        self.assertEqual(self.table()["largest"], moves[0.8][0])
        colours = {lift: set(re.findall('fill="(#[0-9a-f]{6})"', path.read_text()))
                   for lift, (_, path) in moves.items()}
        self.assertGreater(len(colours[0.8]), 10)
        violet = {c for c in colours[0.8] if int(c[1:3], 16) < int(c[5:7], 16) - 20 and c[3:5] < "40"}
        self.assertTrue(violet)  # the farthest of all
        self.assertFalse(violet & colours[0.1])
        self.assertIn("linearGradient", Path("catalogue/scale.svg").read_text())

    def test_a_design_that_moves_farther_has_all_drawn_on_its_scale(self):
        lifts = [0.1, 0.4, 0.8]
        for lift in lifts[:2]:
            planish.Plan({**PLAN, "values": {"handles[0].by[2]": [lift]}})[0].run("lifted")
        planish.catalogue("lifted", "catalogue")
        before = {path.name: path.read_text() for path in Path("catalogue/pictures").iterdir()}
        planish.Plan({**PLAN, "values": {"handles[0].by[2]": [lifts[2]]}})[0].run("lifted")
        told = []
        planish.catalogue("lifted", "catalogue", progress=lambda *counts: told.append(counts))
        self.assertEqual(told[-1], (3, 3))
        for name, text in before.items():
            self.assertNotEqual(Path("catalogue/pictures", name).read_text(), text)

    def test_a_folder_without_results_is_refused(self):
        words = [sys.executable, "-m", "planish", "catalogue", "none", "-o", "catalogue"]
        run = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stdout), (3, ""))
        self.assertIn("none: cannot be listed", run.stderr)


if __name__ == "__main__":
    unittest.main()
