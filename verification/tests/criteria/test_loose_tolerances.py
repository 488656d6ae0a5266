#!/usr/bin/env python3
"""scripts/loose_tolerances lists what is loose, takes the larger difference of two results, and counts rounding as a difference."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[3] / "scripts/loose_tolerances"


def record(name, difference, tolerance, **more):
    return {"case": "a", "id": name, "kind": "ANALYTIC", "difference": difference, "tolerance": tolerance} | more


def listed(*results):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, records in enumerate(results):
            files.append(Path(folder) / f"{number}.json")
            files[-1].write_text(json.dumps(records))
        done = subprocess.run([sys.executable, SCRIPT, *files], capture_output=True, text=True)
    return done.returncode, [line.split()[1] for line in done.stdout.splitlines()[:-1]]


class LooseTolerances(unittest.TestCase):
    def test_a_tolerance_far_above_the_difference_is_listed(self):
        self.assertEqual(listed([record("loose", 2e-12, 1e-5), record("tight", 2e-12, 1e-9)]), (3, ["loose"]))

    def test_nothing_loose_is_no_error(self):
        self.assertEqual(listed([record("tight", 2e-12, 1e-9)]), (0, []))

    def test_the_larger_difference_of_both_implementations_counts(self):
        self.assertEqual(listed([record("one", 0.0, 1e-9)], [record("one", 1e-11, 1e-9)]), (0, []))

    def test_no_difference_counts_as_rounding(self):
        self.assertEqual(listed([record("value", 0.0, 1e-12), record("history", 0.0, 1e-11, columns=[])]), (0, []))
        self.assertEqual(listed([record("value", 0.0, 1e-11), record("history", 0.0, 1e-10, columns=[])]), (3, ["history", "value"]))

    def test_a_criterion_without_a_tolerance_is_left_out(self):
        self.assertEqual(listed([record("stop", 0.0, 0.0), record("refused", None, None), record("tight", 1e-12, 1e-10)]), (0, []))


if __name__ == "__main__":
    unittest.main()
