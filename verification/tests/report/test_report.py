#!/usr/bin/env python3
"""The report of a few cases is complete, and faults of a report are found. Run by ctest; 77 means skipped.

usage: test_report.py content|looks TYPE21 FOLDER"""

import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parents[3]
SKIPPED = 77
# A patch, a law with nodal values, two plateaus, a deck that is refused, departures with both numbers, heat, a convex tool.
CASES = ("flat_press", "friction_laws_pv", "pmax_plateau", "igap2_pmax_thin_thick", "filter2_range", "stmin", "sens_time", "cooling_node", "edge_convex")
TYPE21 = FOLDER = None


def report(*words, results="results.json", out="index.html", cases=ROOT / "cases"):
    command = [ROOT / "scripts/report", "--type21", TYPE21, "--results", FOLDER / results, "--runs", FOLDER / "runs",
               "--optimized", FOLDER / "optimized", "--cases", cases, "--out", FOLDER / out, *words]
    return subprocess.run(command, capture_output=True, text=True)


def can_make():
    """False when this system lacks the modules of the report."""
    return "needs Python 3.11 with" not in report("--check", results="none").stderr


class Content(unittest.TestCase):
    def assert_has(self, text, words):
        """assertIn without the whole report in its message."""
        self.assertTrue(words in text, f"the report lacks '{words}'")

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        for who, runs, json_name in (("reference", "runs", "results.json"), ("optimized", "optimized", "optimized.json")):
            subprocess.run([TYPE21, "verify", *CASES, "--cases", ROOT / "cases", "--with", who, "--scratch", FOLDER / runs, "--json",
                            FOLDER / json_name], check=who == "reference", capture_output=True)
        # A test of its own says whether the table is right.
        subprocess.run([ROOT / "scripts/traceability", "--out", FOLDER], check=False, capture_output=True)
        cls.first = report()
        cls.text = (FOLDER / "index.html").read_text() if cls.first.returncode == 0 else ""

    def check(self, text):
        """Complaints about a report of this text."""
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
        self.assertTrue((FOLDER / "index.html").read_text() == self.text, "made again, the report is another")
        run = FOLDER / "runs/stmin/documented/interface_1.csv"
        old = run.read_text()
        try:
            run.write_text(old.rsplit("\n", 2)[0] + "\n")
            self.assertIn("drawing 1 case,", report(out="index.html").stdout)
        finally:
            run.write_text(old)
            report()

    def test_verdict_counts_what_the_records_say(self):
        records = json.loads((FOLDER / "results.json").read_text())
        self.assert_has(self.text, f"{len(records)} criteria: all hold")
        runs = [json.loads(path.read_text()) for path in (FOLDER / "runs").glob("*/*/run.json")]
        settled = [result["decisions"]["settled"] for run in runs for result in run["results"]]
        decided = sum(sum(stage.values()) for stage in settled)
        self.assertGreater(decided, 0)
        self.assert_has(self.text, f"{decided:,}".replace(",", "\u202f"))

    def test_a_failed_criterion_is_at_the_top(self):
        records = json.loads((FOLDER / "results.json").read_text())
        records[3] |= {"verdict": "failed", "detail": "made up for this test"}
        (FOLDER / "failed.json").write_text(json.dumps(records))
        self.assertEqual(report(results="failed.json", out="failed.html").returncode, 0)
        text = (FOLDER / "failed.html").read_text()
        self.assert_has(text, f"1 of {len(records)} criteria failed")
        self.assert_has(text, "made up for this test")
        self.assertFalse("all hold<" in text)
        report()

    def test_faults_of_a_report_are_found(self):
        for old, new, complaint in (
            ('id="case-stmin"', 'id="case-nobody"', "the case 'stmin' has no sheet"),
            ('href="#departures"', 'href="#nowhere"', "'#nowhere' leads nowhere"),
            ('href="#departures"', 'href="https://example.org"', "leads outside"),
            ('src="data:', 'src="https://example.org/', "from outside"),
            ("<h2>Departures</h2>", "<h2>Departures</h2><p>-nan</p>", "has a nan"),
            ('<section id="accuracy">', "<section>", "the section 'accuracy' is missing"),
            ("</table>", "</tabel>", "closes nothing"),
            ("%23", "<%23", "is no SVG"),
            ('data-of="', 'data-of="0', "were drawn from other files"),
            ("criteria: all hold", "criteria hold", "the headline is not"),
        ):
            with self.subTest(complaint):
                self.assert_has(self.text, old)
                self.assertIn(complaint, self.check(self.text.replace(old, new, 1)))

    def test_a_number_that_its_record_does_not_say_is_found(self):
        records = json.loads((FOLDER / "results.json").read_text())
        record = next(r for r in records if r["case"] == "cooling_node" and isinstance(r["got"], float) and r["got"] > 100 and r["got"] % 1 > 0.01)
        number = f"{record['got']:.10g}"
        self.assert_has(self.text, f'<td class="n">{number}</td>')
        sheet = self.text.index('id="case-cooling_node"')
        spoilt = self.text[:sheet] + self.text[sheet:].replace(f'<td class="n">{number}</td>', f'<td class="n">{number[:-1]}{(int(number[-1]) + 1) % 10}</td>', 1)
        self.assertIn(f"the criterion '{record['id']}' of cooling_node shows", self.check(spoilt))

    def test_pmax_acts_where_it_lowers_a_force(self):
        for case, words in (("pmax_plateau", "on the plateau F / A is Pmax"), ("igap2_pmax_thin_thick", "lowers the force in")):
            sheet = self.text.split(f'id="case-{case}"')[1].split("</details>")[0]
            self.assert_has(sheet, words)
            self.assertFalse("does not act" in sheet, case)
        self.assertFalse("on the plateau" in self.text.split('id="case-igap2_pmax_thin_thick"')[1].split("</details>")[0])

    def test_what_was_not_measured_is_not_shown_as_measured(self):
        # The measured history of sens_time has every fourth cycle; 0.000179 s is between two.
        row = self.text.split('<section id="departures">')[1].split("sens_time</a>")[1].split("</tr>")[0]
        self.assert_has(row, "at 0.000179")
        self.assertEqual(row.split("<td")[-1].split(">")[1].split("<")[0], "–")

    def test_balances_are_no_values_of_formulas(self):
        records = json.loads((FOLDER / "results.json").read_text())
        balances = sum("balance" in r["id"] for r in records)
        self.assertGreater(balances, 10)
        row = self.text.split('<td class="kind">balance</td>')[1].split("</tr>")[0]
        self.assert_has(row, f'<td class="n">{balances}</td>')
        analytic = sum(r["kind"] == "ANALYTIC" for r in records) - balances
        self.assert_has(self.text.split('<td class="kind">ANALYTIC</td>')[1].split("</tr>")[0], f'<td class="n">{analytic}</td>')

    def test_a_convex_tool_is_seen_from_its_contact_side(self):
        self.assert_has(self.text.split('id="case-edge_convex"')[1], "seen from below with z downward")
        self.assertFalse("seen from below" in self.text.split('id="case-flat_press"')[1].split("</details>")[0])

    def test_each_node_of_a_drawing_has_a_mark_of_its_answer(self):
        truth = json.loads((ROOT / "cases/atlas/distance_met.json").read_text())
        picture = unquote(self.text.split('id="atlas-distance_met"')[1].split('src="data:image/svg+xml,')[1].split('"')[0])
        marks = re.findall(r"<circle class='(\w+)' cx='([\d.]+)' cy='([\d.]+)'", picture)
        kinds = [answer["kind"] for block in truth["blocks"] for answer in block["answers"]]
        self.assertEqual(sorted(kind for kind, *_ in marks), sorted(kinds))
        self.assertEqual(len({place[1:] for place in marks}), len(kinds), "two marks on one place hide each other")

    def test_shortfalls_are_on_the_front_page(self):
        front = self.text.split('<section id="verdict">')[1].split("</section>")[0]
        for words in ("Shortfalls", "The speed was not measured", "Departures that cannot be switched on", "Not there: "):
            self.assert_has(front, words)
        missed = {"target": "time of a step", "scene": "pan", "measured": 90.0, "at_least": 50.0, "aim": 40.0, "unit": "ns", "better": "lower", "reached": "no"}
        text = self.with_files({"bench.json": {"rows": [{"scene": "pan", "implementation": "optimized", "method": "m", "ns": {"p50": 90.0}}], "targets": [missed]}})
        self.assert_has(text.split("</section>")[0], "time of a step, pan: 90 ns, where at most 50 is asked")

    def with_files(self, files):
        """The text of a report made with these JSON files beside it."""
        for name, value in files.items():
            (FOLDER / name).write_text(json.dumps(value))
        try:
            done = report(out="more.html")
            self.assertEqual(done.returncode, 0, done.stderr)
            text = (FOLDER / "more.html").read_text()
            self.assertEqual(self.check(text), "")
            return text
        finally:
            for name in files:
                (FOLDER / name).unlink()
            report()

    def asked(self, *words):
        """What the program writes with --json."""
        out = FOLDER / "asked.json"
        subprocess.run([TYPE21, *words, "--json", out], check=True, capture_output=True, cwd=ROOT)
        return json.loads(out.read_text())

    def test_names_what_was_not_run(self):
        for words in ("build/report/mutation.json is missing", "type21 accuracy --json build/report/accuracy.json", "type21 bench --json build/report/bench.json",
                      "type21 lockstep --json build/report/lockstep.json"):
            self.assert_has(self.text, words)
        for section in ("accuracy", "speed", "lockstep"):
            self.assertRegex(self.text.split(f'<section id="{section}">')[1].split("</section>")[0], "Not (measured|compared)")

    def test_mutations_are_shown_when_they_are_there(self):
        mutations = [{"effect": "Pmax", "broken": "infinite", "case": "pmax_plateau", "red": red} for red in (True, False)]
        self.assert_has(self.with_files({"mutation.json": {"mutations": mutations}}), "1 of 2 broken effects made a criterion fail")

    def test_accuracy_is_told_in_numbers_of_the_file(self):
        found = self.asked("accuracy", "--quick", "--quiet", "--repeats", "3", "--scene", "mesh_flat", "--scene", "adversarial")
        effect = {"effect": "friction", "off_means": "Fric 0", "implementation": "optimized", "call": "step_lean", "nodes": 9, "cycles": 5, "extra_ns": 7.5,
                  "extra_error": 0.5, "off_ratio": 1.01, "off_error": 0.02, "same_ratio": 1.0, "same_program": True, "bytes_absent": 8, "bytes_off": 8,
                  "bytes_on": 16, "acts": True} | {f"ns_{name}": {"p50": 50.0, "p95": 51.0, "max": 60.0, "min": 49.0} for name in ("absent", "off", "on")}
        found["effects"] = [effect]
        plain = next(row for row in found["rows"] if row["scene"] == "mesh_flat" and row["method"] == "double")
        plain |= {"wrong": 5, "decisions": 20, "ns": {"p50": 1234.0, "p95": 1300.0, "max": 1400.0, "min": 1200.0}}
        text = self.with_files({"accuracy.json": found})
        self.assert_has(text, "On mesh_flat plain double gets 25 % wrong in 1.23 µs, &#39;optimized, in stages&#39; none in ")
        self.assert_has(text, "costs most when on, 7.5 ± 0.5 ns for each node and cycle")
        self.assert_has(text, "An effect that is off costs nothing")
        self.assert_has(text, found["cpu"])
        self.assert_has(text, found["flags_optimized"])
        effect["same_program"] = False
        next(row for row in found["rows"] if row["exact"])["wrong"] = 3
        text = self.with_files({"accuracy.json": found})
        self.assert_has(text, "NOT free when off: friction")
        self.assert_has(text, '<span class="bad">3</span>')

    def test_speed_says_which_targets_are_missed(self):
        row = {"scene": "bowl", "implementation": "optimized", "method": "step", "ns": {"p50": 60.0}, "decisions": 10, "wrong": 0}
        ratios = [{"scene": "bowl", "what": "step against search", "slow": "search", "fast": "step", "of_medians": value} for value in (0.5, 4.0)]
        targets = [{"target": name, "scene": "bowl", "unit": "x", "better": "higher", "at_least": 10, "aim": 20, "measured": 5, "reached": reached, "note": ""}
                   for name, reached in (("one", "no"), ("other", "aim"))]
        growth = [{"scene": "a", "segments": 100, "nodes": 500, "coherent": 10.0}, {"scene": "b", "segments": 1000, "nodes": 500, "coherent": 20.0},
                  {"scene": "c", "segments": 1000, "nodes": 5000, "coherent": 70.0}]
        text = self.with_files({"bench.json": {"rows": [row], "cpu": "a cpu", "compiler": "a compiler", "repeats": 3, "ratios": ratios, "targets": targets, "growth": growth}})
        self.assert_has(text, "1 of 2 targets reached")
        self.assert_has(text, "NOT REACHED")
        self.assert_has(text, "in 1 of 2 comparisons, those below 1, the first is faster")
        self.assert_has(text, "On a tool with 10 times the segments coherent takes 2 times as long.")
        self.assert_has(text, "coherent, 5 000 nodes")
        self.with_files({"bench.json": {"rows": [row], "cpu": "a cpu", "compiler": "a compiler", "repeats": 3}})

    def test_lockstep_and_sliding_are_shown(self):
        steps = self.asked("lockstep", "flat_press", "--quiet")
        jumps = {"first_step_mm": 0.02, "holds": True, "residual_bound": {"normal": 1.0, "friction": 1.0}}
        jumps |= {name: {"largest_jump": [4.0, 2.0, 1.0], "residual": 0.0} for name in ("normal", "friction")}
        jumps |= {f"facet_{name}": {"largest_jump": [9.0, 9.0, 9.0], "residual": 9.0} for name in ("normal", "friction")}
        stays = jumps | {"tool": "flat", "mesh": "warped", "normal": {"largest_jump": [2.0, 2.0, 1.8], "residual": 1.8}}
        text = self.with_files({"lockstep.json": steps, "stability.json": {"sliding": [jumps | {"tool": "flat", "mesh": "quad"}, stays]}})
        self.assert_has(text, "were compared, none differs")
        self.assert_has(text, "On 1 of 2 tools the jump of the normal force halves")
        self.assert_has(text, "on flat warped a part of it remains, at most 20 % of the jump with facet normals")
        steps["runs"][0] |= {"different": 7, "ok": False}
        steps["all"]["different"], steps["ok"] = 7, False
        text = self.with_files({"lockstep.json": steps})
        self.assert_has(text, "7 DIFFER")
        self.assert_has(text, "1 run DIFFER")

    def test_a_case_shows_its_laws(self):
        self.assert_has(self.text, "Rings: |Fₜ| / |Fₙ| of nodes that slip, 0.086 to 0.741; lines: the law of the card at their speeds, dotted that of the optimized "
                                   "implementation, equal in every bit")
        sheet = self.text.split('id="case-pmax_plateau"')[1].split("</details>")[0]
        self.assertRegex(sheet, r"Run documented\. Pmax \(10 MPa\) lowers the force in .*; on the plateau F / A is Pmax, for penetrations from 0.01\d* to 0.0[45]\d* mm")
        self.assertRegex(self.text, "[Hh]eat flows with a conductance of")

    def test_without_results_it_names_the_script_that_makes_them(self):
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
    unittest.main(argv=[sys.argv[0], {"content": "Content", "looks": "Looks"}[sys.argv[1]]], verbosity=2)
