"""The campaign's parts with the real program: two ranges add up to what one run of both gives.

usage: parts.test.py PROGRAM
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
CAMPAIGN = pathlib.Path(__file__).resolve().parents[2] / "papers" / "campaign"
sys.path.insert(0, str(CAMPAIGN))
import report  # noqa: E402
import summaries  # noqa: E402

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
CASES = 8
PATIENT = ["--case-seconds", "200"]  # sanitizers are slow, and this is no test of speed


class Parts(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "suture").symlink_to(PROGRAM)
        (self.folder / "settings.json").write_text("{}")
        (self.folder / "program.json").write_text('{"commit": "some", "sha256": "other"}')

    def tearDown(self):
        self.temporary.cleanup()

    def part(self, first, program="./suture", options=()):
        return subprocess.run(
            [CAMPAIGN / "part", program, "random", "filtered", "keep", f"{first:010d}", str(CASES),
             "300s", f"parts/random.filtered.keep/{first:010d}.json", *PATIENT, *options],
            cwd=self.folder, capture_output=True, text=True)

    def test_two_ranges_add_up_to_one_run_of_both(self):
        for first in (1, 1 + CASES):
            self.assertEqual(self.part(first).returncode, 0)
        total = report.report(self.folder)
        both = self.folder / "both.json"
        subprocess.run([PROGRAM, "fuzz", "--cases", str(2 * CASES), "--seed", "1", "--profile",
                        "random", "--arithmetic", "filtered", "--collapse", "keep", "--summary",
                        both, *PATIENT], capture_output=True)
        one = json.loads(both.read_text())
        self.assertEqual(one["cases"], 2 * CASES)
        self.assertGreater(one["surgeries"], 0)
        for name in (*summaries.COUNTS, "digest"):
            self.assertEqual(total[name], one[name], name)
        with open(self.folder / "campaign.csv") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([row["profile"] for row in rows], ["random", "all"])
        self.assertEqual(rows[1]["surgeries"], str(one["surgeries"]))
        page = (self.folder / "campaign.md").read_text()
        self.assertIn(one["digest"], page)
        with open(self.folder / "campaign.log.csv") as log:
            self.assertEqual([row["first_seed"] for row in csv.DictReader(log)], ["1", "9"])

    def test_a_fuzzer_that_cannot_run_leaves_no_summary_and_what_it_said(self):
        ended = self.part(1, options=["--no-such-option"])
        self.assertEqual(ended.returncode, 1)
        self.assertIn("no-such-option", ended.stderr)
        left = [path.name for path in (self.folder / "parts").glob("*/*")]
        self.assertEqual(left, ["0000000001.failed.log"])
        self.assertEqual(self.part(1).returncode, 0)
        left = sorted(path.name for path in (self.folder / "parts").glob("*/*"))
        self.assertEqual(left, ["0000000001.json", "0000000001.ran"])


if __name__ == "__main__":
    unittest.main()
