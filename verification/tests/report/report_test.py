#!/usr/bin/env python3
"""The report of a few cases is whole, and what is wrong with a page is found. Run by ctest; 77 means skipped.

usage: report_test.py page|looks TYPE21 FOLDER"""

import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SKIPPED = 77
# A patch, a law with nodal values, the plateau, a deck that is refused, a departure with both numbers, heat.
CASES = ("flat_press", "friction_laws_pv", "pmax_plateau", "filter2_range", "stmin", "cooling_node")
TYPE21 = FOLDER = None


def report(*words, results="results.json", out="index.html", cases=ROOT / "cases"):
    command = [ROOT / "scripts/report", "--type21", TYPE21, "--results", FOLDER / results, "--runs", FOLDER / "runs",
               "--optimized", FOLDER / "optimized", "--cases", cases, "--out", FOLDER / out, *words]
    return subprocess.run(command, capture_output=True, text=True)


def can_make():
    """False when this system lacks the modules of the report."""
    return "needs Python 3.11 with" not in report("--check", results="none").stderr


class Page(unittest.TestCase):
    def assert_has(self, text, words):
        """assertIn without the whole page in its message."""
        self.assertTrue(words in text, f"the page lacks '{words}'")

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        for who, runs, json_name in (("reference", "runs", "results.json"), ("optimized", "optimized", "optimized.json")):
            subprocess.run([TYPE21, "verify", *CASES, "--cases", ROOT / "cases", "--with", who, "--scratch", FOLDER / runs, "--json",
                            FOLDER / json_name], check=who == "reference", capture_output=True)
        subprocess.run([ROOT / "scripts/traceability", "--out", FOLDER], check=True, capture_output=True)
        cls.first = report()
        cls.text = (FOLDER / "index.html").read_text() if cls.first.returncode == 0 else ""

    def check(self, text):
        """Complaints about a page of this text."""
        (FOLDER / "spoilt.html").write_text(text)
        done = report("--check", out="spoilt.html")
        self.assertEqual(done.returncode, 3 if done.stderr else 0, done.stderr)
        return done.stderr

    def test_is_made_and_in_order(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        self.assertEqual(self.check(self.text), "")
        self.assertIn(f"drawing {len(CASES)} cases", self.first.stdout)

    def test_is_drawn_again_only_where_something_changed(self):
        again = report()
        self.assertIn("report: 0 pictures and answers made", again.stdout)
        self.assertNotIn("drawing", again.stdout)
        self.assertTrue((FOLDER / "index.html").read_text() == self.text, "made again, the page is another")
        run = FOLDER / "runs/stmin/page/interface_1.csv"
        old = run.read_text()
        try:
            run.write_text(old.rsplit("\n", 2)[0] + "\n")
            self.assertIn("drawing 1 case,", report(out="index.html").stdout)
        finally:
            run.write_text(old)
            report()

    def test_front_page_counts_what_the_records_say(self):
        records = json.loads((FOLDER / "results.json").read_text())
        self.assert_has(self.text, f"{len(records)} checks: all hold")
        runs = [json.loads(path.read_text()) for path in (FOLDER / "runs").glob("*/*/run.json")]
        settled = [result["decisions"]["settled"] for run in runs for result in run["results"]]
        decided = sum(sum(stage.values()) for stage in settled)
        self.assertGreater(decided, 0)
        self.assert_has(self.text, f"{decided:,}".replace(",", "\u202f"))

    def test_a_failed_check_stands_at_the_top(self):
        records = json.loads((FOLDER / "results.json").read_text())
        records[3] |= {"verdict": "failed", "detail": "made up for this test"}
        (FOLDER / "failed.json").write_text(json.dumps(records))
        self.assertEqual(report(results="failed.json", out="failed.html").returncode, 0)
        text = (FOLDER / "failed.html").read_text()
        self.assert_has(text, f"1 of {len(records)} checks failed")
        self.assert_has(text, "made up for this test")
        self.assertFalse("all hold<" in text)
        report()

    def test_what_is_wrong_with_a_page_is_found(self):
        for old, new, complaint in (
            ('id="case-stmin"', 'id="case-nobody"', "the case 'stmin' has no sheet"),
            ('href="#departures"', 'href="#nowhere"', "'#nowhere' leads nowhere"),
            ('href="#departures"', 'href="https://example.org"', "leads outside"),
            ('src="data:', 'src="https://example.org/', "from outside"),
            ("<h2>Departures</h2>", "<h2>Departures</h2><p>-nan</p>", "has a nan"),
            ('<section id="accuracy">', "<section>", "the section 'accuracy' is missing"),
            ("</table>", "</tabel>", "closes nothing"),
            ("%23", "<%23", "is no SVG"),
        ):
            with self.subTest(complaint):
                self.assert_has(self.text, old)
                self.assertIn(complaint, self.check(self.text.replace(old, new, 1)))

    def test_mutations_and_costs_are_shown_when_they_are_there(self):
        self.assert_has(self.text, "build/report/mutation.json is not there")
        self.assert_has(self.text, "Not measured")
        mutations = [{"effect": "Pmax", "broken": "infinite", "case": "pmax_plateau", "red": red} for red in (True, False)]
        rows = [{"scene": "bowl", "method": name, "ns": {"p50": time, "p95": 1.1 * time, "max": 2 * time}, "decisions": 1000, "wrong": wrong,
                 "force": {"ulps_max": 3, "ulps_p99": 1}} for name, time, wrong in (("double", 20.0, 7), ("filtered", 31.0, 0))]
        (FOLDER / "mutation.json").write_text(json.dumps({"mutations": mutations}))
        (FOLDER / "bench.json").write_text(json.dumps({"rows": rows, "effects": [{"effect": "friction", "ns_on": 5}]}))
        try:
            done = report(out="more.html")
            self.assertEqual(done.returncode, 0, done.stderr)
            text = (FOLDER / "more.html").read_text()
            self.assert_has(text, "1 of 2 broken effects turned a check red")
            self.assert_has(text, "the fastest method without a wrong decision is filtered with 31 ns; double needs 20 ns and gets 7 of 1000 wrong")
            self.assertEqual(self.check(text), "")
        finally:
            (FOLDER / "mutation.json").unlink()
            (FOLDER / "bench.json").unlink()
            report()

    def test_without_results_it_says_who_makes_them(self):
        done = report(results="none.json", out="none.html")
        self.assertEqual(done.returncode, 1)
        self.assertIn("scripts/verify makes it", done.stderr)
        self.assertFalse((FOLDER / "none.html").exists())


class Looks(unittest.TestCase):
    """At 1366 and 390 pixels nothing sticks out, with sheets closed and open, and every picture shows."""

    def test_fits(self):
        done = report("--screenshots", FOLDER / "screenshots")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("laptop", "phone"):
            self.assertGreater((FOLDER / f"screenshots/{name}.png").stat().st_size, 10000)

    def test_sees_what_sticks_out(self):
        text = (FOLDER / "index.html").read_text()
        (FOLDER / "wide.html").write_text(text.replace("<h2>Departures</h2>", '<h2 style="width:700px">Departures</h2>'))
        done = report("--screenshots", FOLDER / "screenshots_wide", out="wide.html")
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("phone, sheets closed", done.stderr)
        self.assertNotIn("laptop", done.stderr)


if __name__ == "__main__":
    TYPE21, FOLDER = Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
    if not can_make():
        print("skipped: numpy, matplotlib or Jinja2 is not there")
        sys.exit(SKIPPED)
    if sys.argv[1] == "looks" and report("--screenshots", FOLDER / "screenshots", out="none").returncode == SKIPPED:
        print("skipped: Chromium is not there")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], {"page": "Page", "looks": "Looks"}[sys.argv[1]]], verbosity=2)
