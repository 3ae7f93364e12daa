"""The comparison's tables, orders and verdicts, from planted rows whose answers are known."""

import csv
import json
import math
import pathlib
import re
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "papers" / "wojtan2009"))
import plan  # noqa: E402
import plots  # noqa: E402
import tables  # noqa: E402
import verdict  # noqa: E402

CONFIG = {"resolutions": [64, 100], "resolution": 100, "sheet_resolutions": [64], "edges": [0.01],
          "steps": [0.01], "turns": [50], "cell_resolutions": [64], "seeds_100": 2, "seeds_1000": 1,
          "sequence": [0, 3]}
SCENES = pathlib.Path(plan.__file__).parent / "scenes"
MESH = {"outcome": "done", "cell_size": "1", "start_triangles": "25628", "cells_resampled": "0",
        "volume_error": "-6e-4", "volume_drift": "-3e-9", "mean_distance": "0.0016",
        "corner_max": "2e-7", "marker_max": "2.04e-06", "components": "1", "euler": "2"}


def rows_file(path, rows):
    columns = sorted({c for row in rows for c in row})
    with open(path, "w", newline="") as text:
        table = csv.DictWriter(text, columns, restval="")
        table.writeheader()
        table.writerows(rows)


class Comparison(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def verdicts(self, **rows):
        for name in ("zalesak", "enright", "topology", "others"):
            rows_file(self.folder / f"{name}.csv", rows.get(name, [{"run": "none", "time": "1"}]))
        return verdict.Tables(self.folder)

    def test_every_run_of_the_plan_has_a_scene_and_a_table(self):
        runs = plan.plan_of(CONFIG)
        for name, run in runs.items():
            self.assertTrue((SCENES / f"{run['scene']}.toml").exists(), name)
            self.assertIn(run["group"], (*tables.GROUPS, "pictures"))
            self.assertNotIn("/", name)
        for method in (*plan.METHODS, "mesh", "markers"):
            self.assertIn(f"zalesak.{method}.100", runs)
            self.assertIn(f"enright.{method}.100", runs)

    def test_an_order_is_the_slope_of_what_was_planted(self):
        line = [(h, 3 * h ** 2.5) for h in (0.01, 0.02, 0.04, 0.08)]
        self.assertAlmostEqual(plots.order(line), 2.5)
        self.assertTrue(math.isnan(plots.order(line[:2])))

    def test_points_are_those_of_the_panel_and_its_time(self):
        rows = [{"run": f"cell.level_set.{n}", "outcome": "done", "time": t, "cell_size": 1 / n,
                 "mean_distance": e} for n in (32, 64) for t, e in ((1.5, 9), (3, 1 / n))]
        rows.append({**rows[0], "run": "step.mesh.0.1"})
        found = plots.points(rows, plots.PANELS[0])
        self.assertEqual(list(found), ["level_set"])
        self.assertEqual([y for _, y in found["level_set"]], [1 / 64, 1 / 32])

    def test_tables_hold_all_rows_with_all_columns_in_the_plan_s_order(self):
        runs = {"b.mesh": {"group": "zalesak"}, "a.mesh": {"group": "enright"}}
        (self.folder / "runs.json").write_text(json.dumps(runs))
        (self.folder / "parts").mkdir()
        rows_file(self.folder / "parts" / "b.mesh.csv", [{**MESH, "time": "628"}, {"outcome": "stopped"}])
        rows_file(self.folder / "parts" / "a.mesh.csv", [{"outcome": "done", "more": "x"}])
        groups = tables.rows_of(self.folder)
        self.assertEqual(len(groups["zalesak"]), 2)
        text = tables.as_csv(groups["zalesak"] + groups["enright"])
        self.assertEqual(len(text.splitlines()), 4)
        self.assertIn("more", text.splitlines()[0])
        page = tables.page(groups)
        self.assertIn("-0.06 %", page)
        self.assertIn("stopped", page)

    def test_the_mesh_holds_only_if_nothing_was_re_sampled_and_vertices_are_where_markers_are(self):
        for change, holds in (({}, "holds"), ({"cells_resampled": "3"}, "DOES NOT HOLD"),
                              ({"marker_max": "3e-06"}, "DOES NOT HOLD"),
                              ({"volume_drift": "2e-6"}, "DOES NOT HOLD")):
            t = self.verdicts(zalesak=[
                {**MESH, **change, "run": "zalesak.mesh.100", "time": "628"},
                {**MESH, "run": "zalesak.markers.100", "time": "628"}])
            self.assertEqual(next(verdict.zalesak(t, "100"))["verdict"], holds, change)

    def test_corners_are_said_in_cells_whatever_a_cell_is(self):
        rows = [{**MESH, "cell_size": "4", "corner_max": "8", "run": f"zalesak.{m}.24", "time": "628"}
                for m in ("mesh", "markers")]
        found = next(verdict.zalesak(self.verdicts(zalesak=rows), "24"))
        self.assertIn("exact corners 2 cells from the surface", found["ours"])
        self.assertIn("at most 5.1e-07 cells off", found["ours"])

    def test_a_rival_s_corners_are_rounded_only_if_that_could_be_seen(self):
        for corner, distance, holds in (("0.6", "0.1", "holds"), ("1e-5", "0.1", "DOES NOT HOLD"),
                                        ("0.6", "0.3", "DOES NOT HOLD")):
            rows = [{**MESH, "corner_max": "0.7", "mean_distance": "0.2", "time": "628",
                     "run": "zalesak.level_set.100"},
                    {**MESH, "corner_max": corner, "mean_distance": distance, "time": "628",
                     "volume_error": "-5e-4", "run": "zalesak.particle_level_set.100"}]
            found = {v["figure"]: v["verdict"] for v in verdict.zalesak(self.verdicts(zalesak=rows), "100")}
            self.assertEqual(found["Figure 11, Zalesak's sphere, particle_level_set"], holds, corner)
            self.assertEqual(found["Figure 11, Zalesak's sphere, level_set"], "holds")

    def test_particles_keep_more_only_if_both_volume_and_distance_say_so(self):
        for volume, distance, holds in (("-0.016", "0.11", "holds"), ("-0.057", "0.21", "DOES NOT HOLD"),
                                        ("0.057", "0.21", "DOES NOT HOLD"), ("-0.016", "0.27", "DOES NOT HOLD")):
            rows = [{**MESH, "corner_max": "1.6", "volume_error": "-0.046", "mean_distance": "0.265",
                     "time": "628", "run": "zalesak.level_set.100"},
                    {**MESH, "corner_max": "0.7", "volume_error": volume, "mean_distance": distance,
                     "time": "628", "run": "zalesak.particle_level_set.100"}]
            found = {v["figure"]: v for v in verdict.zalesak(self.verdicts(zalesak=rows), "100")}
            judged = found["Figure 11, Zalesak's sphere, particle_level_set"]
            self.assertEqual(judged["verdict"], holds, (volume, distance))
            self.assertIn("the level set: volume -4.6 %", judged["ours"])

    def test_a_run_that_failed_passes_nothing(self):
        crashed = {"outcome": "crashed", "failure": "killed by signal 11", "time": ""}
        shape = {"components": "1", "components_expected": "1", "euler": "2", "euler_expected": "2"}
        for row, holds in (({**shape, "outcome": "done", "closed_manifold": "yes"}, "holds"),
                           ({**shape, "outcome": "refused", "closed_manifold": "yes"}, "DOES NOT HOLD"),
                           ({**shape, "outcome": "done", "closed_manifold": "no"}, "DOES NOT HOLD"),
                           (crashed, "DOES NOT HOLD")):
            t = self.verdicts(topology=[{**row, "run": "two_spheres.mesh"}, {"run": "none", **shape}])
            found = {v["figure"]: v["verdict"] for v in verdict.topology(t)}
            self.assertEqual(found["two spheres"], holds, row)
            self.assertEqual(found["dumbbell"], "no rows")
        t = self.verdicts(zalesak=[{**crashed, "run": "zalesak.mesh.100"},
                                   {**MESH, "run": "zalesak.markers.100", "time": "628"}])
        found = next(verdict.zalesak(t, "100"))
        self.assertEqual(found["verdict"], "DOES NOT HOLD")
        self.assertIn("killed by signal 11", found["ours"])

    def test_pictures_are_made_at_ends_of_steps(self):
        for name in ("config", "quick"):
            text = (SCENES.parent / f"{name}.yaml").read_text()
            step = 0.01  # of enright.toml
            times = re.search(r"^sequence: \[(.*)\]", text, re.MULTILINE).group(1).split(",")
            for time in map(float, times):
                self.assertAlmostEqual(time / step, round(time / step), msg=f"{name}: {time}")

    def test_a_campaign_of_balls_holds_only_if_every_run_does(self):
        row = {"outcome": "done", "closed_manifold": "yes", "components": "1", "seconds": "2",
               "triangles_max": "4"}
        rows = [{**row, "run": f"spheres_100.{i:03d}"} for i in range(100)]
        self.assertEqual(next(verdict.topology(self.verdicts(topology=rows)))["verdict"], "holds")
        rows[7]["components"] = "2"
        found = next(verdict.topology(self.verdicts(topology=rows)))
        self.assertEqual(found["verdict"], "DOES NOT HOLD")
        self.assertIn("99 of 100", found["ours"])
        self.assertEqual(next(verdict.topology(self.verdicts(topology=rows[:9])))["verdict"], "no rows")


if __name__ == "__main__":
    unittest.main()
