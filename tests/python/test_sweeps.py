# SPDX-License-Identifier: MIT
"""A sweep has one table, whoever ran it, in whatever order, and whoever died on the way."""

import csv
import importlib.util
import json
import os
import shutil
import subprocess
import time
import unittest
from pathlib import Path

import planish
from command import COMMAND, ROOT, InFolder

PLAN = {
    "design": {
        "format": "planish-design",
        "version": 1,
        "source": {"sample": "vault", "size": 12},
        "handles": [[78, 6, 6, 4]],
        "options": {"shape": True},
    },
    "values": {
        "handles[0].by[2]": {"from": 0.1, "to": 0.8, "count": 4},
        "options.softness": [2, 5, 8],
    },
}


class InFolderWithPlan(InFolder):
    def setUp(self):
        super().setUp()
        Path("plan.json").write_text(json.dumps(PLAN))
        self.plan = planish.Plan.load("plan.json")

    def table(self, folder):
        planish.gather(folder, folder + ".csv")
        return Path(folder + ".csv").read_bytes()

    def by_command(self):
        """The table of the jobs one after the other."""
        self.command("sweep", "plan.json", "--part=1/1", "-o", "command")
        return self.table("command")


class Sweeps(InFolderWithPlan):
    def engine(self, name, *words, **variables):
        """Runs a file of docs/sweeps with the command on the path."""
        path = f"{COMMAND.parent}:{os.environ['PATH']}"
        run = subprocess.run([ROOT / "docs/sweeps" / name, *words], capture_output=True, text=True,
                             env={**os.environ, "PATH": path, **variables}, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_the_list_has_an_id_and_the_values_of_each_job(self):
        listed = subprocess.run([COMMAND, "sweep", "plan.json", "--list"], capture_output=True,
                                text=True, check=True).stdout.splitlines()
        self.assertEqual(len(listed), 12)
        self.assertEqual([line.split("\t")[0] for line in listed], [job.id for job in self.plan])
        self.assertEqual(listed[0].split("\t")[1:],
                         ["handles[0].by[2]=0.1", "options.softness=2"])
        self.assertEqual(self.plan[0].values, {"handles[0].by[2]": 0.1, "options.softness": 2})

    def test_a_job_leaves_figures_and_a_design_and_is_done_once(self):
        job = self.plan[5]
        figures = job.run("mine")
        self.assertIn(figures["status"], ("converged", "iteration_limit"))
        self.assertNotIn("seconds", figures)
        design = planish.Design.load(f"mine/{job.id}.design.json")
        self.assertTrue(design.replay().verified)
        written = os.stat(f"mine/{job.id}.json").st_mtime_ns
        self.command("sweep", "plan.json", "--job", job.id, "-o", "mine")
        job.run("mine")
        self.assertEqual(os.stat(f"mine/{job.id}.json").st_mtime_ns, written)
        self.command("sweep", "plan.json", "--job", job.id, "-o", "command")
        for ending in (".json", ".design.json"):
            self.assertEqual(Path(f"mine/{job.id}{ending}").read_bytes(),
                             Path(f"command/{job.id}{ending}").read_bytes())

    def test_parts_in_any_order_give_the_same_table(self):
        for part in ("3/5", "1/5", "5/5", "2/5", "4/5"):
            self.command("sweep", "plan.json", "--part", part, "-o", "parts")
        self.assertEqual(self.table("parts"), self.by_command())

    def test_the_table_has_a_row_a_job_sorted_by_id(self):
        rows = list(csv.DictReader(self.by_command().decode().splitlines()))
        self.assertEqual([row["id"] for row in rows], sorted(job.id for job in self.plan))
        self.assertLessEqual({row["status"] for row in rows}, {"converged", "iteration_limit"})
        self.assertTrue(all(float(row["planarity_mm_per_m"]) <= 1e-6 for row in rows))
        values = {(row["handles[0].by[2]"], row["options.softness"]) for row in rows}
        self.assertEqual(len(values), 12)

    def test_types_are_counted_as_the_command_does(self):
        for job in self.plan:
            job.run("mine", count_types="2%", mirrored=True)
        self.command("sweep", "plan.json", "--part=1/1", "--count-types=2%", "--mirrored",
                     "-o", "command")
        self.assertEqual(self.table("mine"), self.table("command"))
        rows = list(csv.DictReader(self.table("mine").decode().splitlines()))
        self.assertTrue(all(int(row["types_after"]) > 0 for row in rows))
        with self.assertRaisesRegex(planish.UsageError, "count_types"):
            self.plan[0].run("other", count_types="few")

    def test_a_design_that_is_none_is_a_result(self):
        plan = planish.Plan({**PLAN, "values": {"handles[0][0]": [78, 4000]}})
        figures = [job.run("mixed") for job in plan]
        self.assertEqual(figures[1]["status"], "refused")
        self.assertIn("4000", figures[1]["message"])
        self.assertIn(b",refused,", self.table("mixed"))

    def test_a_process_that_dies_leaves_whole_jobs(self):
        # Killed as soon as the second job is there: somewhere within the third or a later one.
        run = subprocess.Popen([COMMAND, "sweep", "plan.json", "--part=1/1", "-o", "killed"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        finished = lambda: [job for job in self.plan if job.is_done("killed")]
        while len(finished()) < 2 and run.poll() is None:
            time.sleep(0.001)
        run.kill()
        run.wait()
        self.assertLess(len(finished()), 12)
        for job in finished():
            self.assertEqual(json.loads(Path(f"killed/{job.id}.json").read_text())["id"], job.id)
        self.command("sweep", "plan.json", "--part=1/1", "-o", "killed")
        self.assertEqual(self.table("killed"), self.by_command())

    def test_errors(self):
        self.assertIn("no job", self.command("sweep", "plan.json", "--job=12", "-o", "x", code=2))
        self.assertIn("from 1 to N",
                      self.command("sweep", "plan.json", "--part=3/2", "-o", "x", code=2))
        self.assertIn("-o DIR is missing", self.command("sweep", "plan.json", "--job=1", code=2))
        self.assertIn("one of --list", self.command("sweep", "plan.json", code=2))
        self.assertIn("cannot be listed", self.command("gather", "none", "-o", "x.csv", code=3))
        with self.assertRaisesRegex(planish.UsageError, "design is missing"):
            planish.Plan({"values": {}})

    @unittest.skipUnless(shutil.which("parallel"), "skipped: no GNU parallel")
    def test_gnu_parallel(self):
        self.engine("parallel.sh", "plan.json", "parallel")
        self.assertEqual(Path("parallel/results.csv").read_bytes(), self.by_command())

    def test_a_slurm_array(self):
        for task in ("7", "5", "6"):
            self.engine("slurm.sh", "plan.json", "slurm", SLURM_ARRAY_TASK_ID=task,
                        SLURM_ARRAY_TASK_MIN="5", SLURM_ARRAY_TASK_COUNT="3")
        self.assertEqual(self.table("slurm"), self.by_command())

    @unittest.skipUnless(shutil.which("snakemake"), "skipped: no Snakemake")
    def test_snakemake(self):
        path = f"{COMMAND.parent}:{os.environ['PATH']}"
        subprocess.run(["snakemake", "--cores", "2", "--snakefile", ROOT / "docs/sweeps/Snakefile",
                        "--config", "plan=plan.json", "folder=snakes"],
                       env={**os.environ, "PATH": path}, check=True, capture_output=True)
        self.assertEqual(Path("snakes/results.csv").read_bytes(), self.by_command())


@unittest.skipUnless(importlib.util.find_spec("distributed"), "skipped: no Dask distributed")
class DaskSweeps(InFolderWithPlan):
    def start(self, processes):
        """Workers as threads of this process start and end for certain. Processes that are killed do not
        always let Dask 2022.12 end: only nightly."""
        from distributed import Client, LocalCluster

        cluster = LocalCluster(n_workers=2, threads_per_worker=1, processes=processes,
                               dashboard_address=None, silence_logs=50)
        self.addCleanup(cluster.close)
        client = Client(cluster)
        self.addCleanup(client.close)
        return client

    @unittest.skipUnless(os.environ.get("PLANISH_NIGHTLY"), "skipped: nightly")
    def test_half_of_the_workers_killed_gives_the_same_table(self):
        client = self.start(processes=True)
        workers = list(client.run(os.getpid).values())
        told = []

        def progress(done, total, figures):
            told.append(figures["id"])
            self.assertEqual(total, 12)
            if done == 3:
                os.kill(workers[0], 9)

        planish.sweep(self.plan, client, "dask", progress=progress)
        self.assertEqual(sorted(told), sorted(job.id for job in self.plan))  # nothing twice
        self.assertEqual(self.table("dask"), self.by_command())

    def test_stops_and_goes_on(self):
        client = self.start(processes=False)
        planish.sweep(self.plan, client, "dask", progress=lambda done, *_: done < 4)
        finished = len([job for job in self.plan if job.is_done("dask")])
        self.assertEqual(finished, 4)
        told = []
        planish.sweep(self.plan, client, "dask", progress=lambda done, total, _: told.append(total))
        self.assertEqual(told, [8] * 8)
        self.assertEqual(self.table("dask"), self.by_command())


if __name__ == "__main__":
    unittest.main()
