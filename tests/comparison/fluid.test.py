"""The fluid's figures: which seconds are compared, and what papers/fluid/run does with its options."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
FLUID = pathlib.Path(__file__).resolve().parents[2] / "papers" / "fluid"
spec = importlib.util.spec_from_file_location("fluid_verdict", FLUID / "verdict.py")
verdict = importlib.util.module_from_spec(spec)
spec.loader.exec_module(verdict)

ROW = {"run": "figure_1.mesh", "seconds_a_frame": 7.49, "solver_cpu_a_frame": 2.8, "tracker_cpu_a_frame": 2.2,
       "triangles_first": 410700, "triangles_most": 599936, "liquid_cells_most": 14557, "merged": 222, "split": 250,
       "volume_last": 0.005, "volume_worst": -0.078, "untouched_area": 0.69, "refused": 0,
       "closed_manifold": True, "finished": True}


class Verdicts(unittest.TestCase):
    def test_seconds_are_compared_only_where_the_work_is_the_paper_s(self):
        small = verdict.verdict_of(ROW)
        self.assertIn("410,700 triangles at first, the paper's 6,300,000 are 15 times as many", small)
        self.assertNotIn("hold", small.lower())
        whole = {**ROW, "triangles_first": 6400000}
        self.assertIn("seconds hold", verdict.verdict_of(whole))
        self.assertIn("SECONDS DO NOT HOLD", verdict.verdict_of({**whole, "seconds_a_frame": 70}))
        self.assertIn("seconds hold", verdict.verdict_of({**ROW, "run": "figure_10.mesh"}))


class Options(unittest.TestCase):
    """With stand-ins for what would install and run."""

    def run_with(self, *options):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for stand_in, does in (("dpkg-query", "echo installed"), ("snakemake", "echo snakemake \"$@\"")):
                (folder / stand_in).write_text(f"#!/bin/sh\n{does}\n")
                (folder / stand_in).chmod(0o755)
            return subprocess.run(
                [FLUID / "run", *options, "--program", folder / "snakemake", "-o", folder / "out"],
                env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}, capture_output=True, text=True)

    def test_quick_runs_the_quick_scenes(self):
        quick = self.run_with("--quick")
        self.assertEqual(quick.returncode, 0, quick.stderr)
        self.assertIn("quick.yaml", quick.stdout)
        self.assertIn("config.yaml", self.run_with().stdout)

    def test_quick_is_nothing_to_publish(self):
        refused = self.run_with("--quick", "--publish")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("leave --quick out", refused.stderr)
        self.assertEqual(refused.stdout, "")


if __name__ == "__main__":
    unittest.main()
