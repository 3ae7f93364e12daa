"""The campaign's tables, from planted summaries: sums, failures, refusals of what is none."""

import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "papers" / "campaign"))
import progress  # noqa: E402
import report  # noqa: E402
import summaries  # noqa: E402


def summary(**changes):
    return {"version": "9.9.9", "cases": 10, "remodels": 30, "surgeries": 20, "crashes": 0,
            "hangs": 0, "refused": {"audit": 1}, "failures": [], "cpu_seconds": 4.0,
            "digest": "00000000000000ff", "ended_early": {"vertex # would move": 2},
            "generators": {"roll": {"cases": 10, "remodels": 30, "surgeries": 20}},
            "oracles": {"audit": {"checks": 40, "failures": 0}}, **changes}


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.parts = pathlib.Path(self.folder.name) / "parts"

    def tearDown(self):
        self.folder.cleanup()

    def plant(self, combination, first, text):
        path = self.parts / combination / f"{first:010d}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text if isinstance(text, str) else json.dumps(text))
        return path

    def read(self):
        return [summaries.read(path) for path in summaries.paths(self.parts)]

    def test_a_row_is_the_sum_of_its_ranges_and_the_last_row_of_all(self):
        self.plant("hostile.filtered.keep", 11, summary(surgeries=5, hangs=1, refused={}))
        self.plant("hostile.filtered.keep", 1, summary())
        self.plant("random.filtered.paper", 1, summary(refused={"audit": 2, "budget": 3}))
        keep, paper, everything = summaries.table(self.read())
        self.assertEqual([keep[n] for n in ("profile", "arithmetic", "collapse")],
                         ["hostile", "filtered", "keep"])
        self.assertEqual([keep[n] for n in ("first_seed", "last_seed", "ranges", "cases")],
                         [1, 20, 2, 20])
        self.assertEqual([keep[n] for n in ("surgeries", "refused", "hangs", "cpu_seconds")],
                         [25, 1, 1, 8.0])
        self.assertEqual(keep["surgeries_per_cpu_second"], 3.12)
        self.assertEqual([paper["refused"], everything["refused"]], [5, 6])
        self.assertEqual([everything[n] for n in ("surgeries", "cases", "remodels", "ranges")],
                         [45, 30, 90, 3])

    def test_ranges_are_in_the_order_of_their_seeds(self):
        for first in (2001, 1, 101):
            self.plant("random.filtered.keep", first, summary())
        self.assertEqual([p["first_seed"] for p in self.read()], [1, 101, 2001])

    def test_a_failure_keeps_its_seed_cause_and_combination(self):
        found = {"seed": 7, "oracle": "audit", "cause": "an edge of three", "file": "c/7.toml"}
        self.plant("random.rounded.keep", 1, summary(failures=[found]))
        self.assertEqual(summaries.failures(self.read()),
                         [{"profile": "random", "arithmetic": "rounded", "collapse": "keep",
                           **found}])

    def test_what_is_no_summary_is_named(self):
        for text in ("", "[]", "{}", json.dumps(summary(cases="many")),
                     json.dumps(summary(refused=7)), json.dumps(summary(failures=["x"]))):
            path = self.plant("random.filtered.keep", 1, text)
            with self.assertRaisesRegex(summaries.BadSummary, path.name):
                summaries.read(path)

    def test_a_file_in_the_wrong_place_is_named(self):
        path = self.plant("keep", 1, summary())
        with self.assertRaisesRegex(summaries.BadSummary, "PROFILE.ARITHMETIC.COLLAPSE"):
            summaries.read(path)

    def test_digests_add_up_whatever_the_order_and_wrap_round(self):
        self.plant("random.filtered.keep", 1, summary(digest="ffffffffffffffff"))
        self.plant("random.filtered.keep", 11, summary(digest="0000000000000003"))
        self.assertEqual(summaries.table(self.read())[-1]["digest"], "0000000000000002")

    def test_half_written_ranges_do_not_count(self):
        self.plant("random.filtered.keep", 1, summary())
        (self.parts / "random.filtered.keep" / "0000000011.host.77").write_text("{")
        self.assertEqual(len(self.read()), 1)

    def test_a_merged_summary_that_is_not_the_sum_is_noticed(self):
        self.plant("random.filtered.keep", 1, summary())
        self.plant("random.filtered.keep", 11, summary())
        sum_of_both = {**summary(), "cases": 20, "remodels": 60, "surgeries": 40,
                       "digest": "00000000000001fe"}
        self.assertEqual(summaries.disagreements(self.read(), sum_of_both), [])
        for name in ("cases", "surgeries", "crashes", "digest"):
            wrong = summaries.disagreements(self.read(), {**sum_of_both, name: 7})
            self.assertEqual(len(wrong), 1)
            self.assertIn(name, wrong[0])
        self.assertTrue(summaries.disagreements(self.read(), {**sum_of_both, "failures": [{}]}))

    def test_the_conclusion_claims_nothing_where_something_was_found(self):
        clean = {"surgeries": 1000, "failures": 0, "crashes": 0, "hangs": 0}
        self.assertIn("3.0e-03", report.conclusion(clean))
        said = report.conclusion({**clean, "failures": 2, "hangs": 1})
        self.assertIn("2 failures, of which 0 crashes and 1 hangs", said)
        self.assertNotIn("without", said)
        self.assertNotIn("without", report.conclusion({**clean, "surgeries": 0}))

    def test_progress_counts_new_ranges_once(self):
        self.plant("random.filtered.keep", 1, summary())
        watched = progress.Progress(self.folder.name, 200, "surgeries")
        self.assertTrue(watched.line().startswith("20 of 200 surgeries (10.0 %)"))
        self.plant("random.filtered.keep", 11, summary(crashes=1))
        self.assertIn("(crashes 1, hangs 0)", watched.line())
        self.assertTrue(watched.line().startswith("40 of 200 surgeries (20.0 %)"))


if __name__ == "__main__":
    unittest.main()
