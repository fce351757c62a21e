# SPDX-License-Identifier: MIT
"""The installed wheel: what is in it, its documents, a mesh from the shared folder."""

import inspect
import re
import sys
import unittest
from pathlib import Path

import planish
from command import ROOT, SHARED, InFolder


class Package(InFolder):
    def test_it_is_the_wheel_that_is_tested(self):
        folder = Path(planish.__file__).parent
        self.assertTrue(folder.is_relative_to(sys.prefix), folder)
        self.assertTrue((folder / "py.typed").exists())
        self.assertTrue((folder / "_core.pyi").exists())

    def test_the_stub_names_what_the_module_has(self):
        stub = (Path(planish.__file__).parent / "_core.pyi").read_text()
        module = planish._core
        self.assertEqual(set(re.findall(r"^(?:class|def) (\w+)|^(version)", stub, re.M)),
                         {(n, "") if n != "version" else ("", n)
                          for n in vars(module) if not n.startswith("_")})
        for name, cls in inspect.getmembers(module, inspect.isclass):
            body = re.search(rf"^class {name}:\n((?:    .*\n|\n)+)", stub, re.M)[1]
            bound = {n for n in vars(cls) if not n.startswith("_")}
            self.assertEqual(set(re.findall(r"    def ([a-z]\w*)", body)), bound, name)

    def test_the_examples_of_the_readme_run(self):
        text = (ROOT / "python/README.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreater(len(blocks), 4)
        names = {}
        for block in blocks:  # one after the other, as they are read
            exec(compile(block, "python/README.md", "exec"), names)

    @unittest.skipUnless((SHARED / "pq_gitter.obj").exists(), "skipped: no shared meshes")
    def test_a_roof_from_practice_is_edited(self):
        mesh = planish.Mesh.read(SHARED / "pq_gitter.obj")
        vertex = len(mesh) // 2
        edit = planish.edit(mesh, {vertex: (0, 0, 0.3 * mesh.info().mesh["mean_edge"])})
        self.assertIn(edit.report.status, ("converged", "infeasible_handles"))
        self.assertLessEqual(edit.report.planarity_mm_per_m["after_max"], 1e-6)
        words = f"--handle={vertex}+=0,0,{0.3 * mesh.info().mesh['mean_edge']!r}"
        self.command("edit", str(SHARED / "pq_gitter.obj"), words, "-o", "e.obj")
        self.assertEqual(planish.Mesh.read("e.obj").points.tobytes(), edit.positions.tobytes())


if __name__ == "__main__":
    unittest.main()
