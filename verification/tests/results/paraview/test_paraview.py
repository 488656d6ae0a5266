#!/usr/bin/env python3
"""The files of `type21 run --paraview` as VTK's own reader sees them, against the histories of the same run. Run by ctest; 77
means skipped (no VTK for Python).

usage: paraview_test.py TYPE21 FOLDER"""

import csv
import json
import math
import os
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[4]
SKIPPED = 77
CASE = "cylinder_slide"
FRICTION = 0.15
TYPE21 = FOLDER = vtkXMLUnstructuredGridReader = None


def find_vtk():
    """Loads the reader, if need be with the Python of the system; False when there is none."""
    global vtkXMLUnstructuredGridReader
    try:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        return True
    except ImportError:
        pass
    python = "/usr/bin/python3"
    if os.environ.get("TYPE21_VTK_TRIED") or not Path(python).exists():
        return False
    os.execve(python, [python, "-B", *sys.argv], {**os.environ, "TYPE21_VTK_TRIED": "1"})


def arrays(data):
    """Name to list of values; tuples where there is more than one component."""
    out = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        tuples = [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]
        out[array.GetName()] = [t[0] for t in tuples] if array.GetNumberOfComponents() == 1 else tuples
    return out


class Grid:
    def __init__(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        self.points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
        self.cells = [[grid.GetCell(i).GetPointId(k) for k in range(grid.GetCell(i).GetNumberOfPoints())]
                      for i in range(grid.GetNumberOfCells())]
        self.point, self.cell = arrays(grid.GetPointData()), arrays(grid.GetCellData())
        field = grid.GetFieldData()
        self.time = field.GetArray("TimeValue").GetValue(0)
        units = field.GetAbstractArray("units")
        self.units = [units.GetValue(i) for i in range(units.GetNumberOfValues())]


def series(folder, name):
    """(time of the list, grid) of a time series."""
    root = ElementTree.parse(folder / "paraview" / f"{name}.pvd").getroot()
    for entry in root.find("Collection"):
        yield float(entry.get("timestep")), Grid(folder / "paraview" / entry.get("file"))


def table(path):
    with open(path) as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(line for line in file if line[0] != "#")]


def total(vectors):
    return [math.fsum(v[i] for v in vectors) for i in range(3)]


def length(v):
    return math.hypot(*v)


class Series(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        cls.folder, cls.blank, cls.tool = {}, {}, {}
        for who in ("reference", "optimized"):
            cls.folder[who] = FOLDER / who
            subprocess.run([TYPE21, "run", ROOT / f"cases/{CASE}/{CASE}_0000.rad", "--out", FOLDER / who, "--with", who, "--quiet",
                            "--paraview"], check=True)
            cls.blank[who] = list(series(FOLDER / who, "blank_1"))
            cls.tool[who] = list(series(FOLDER / who, "tool_1"))
        cls.impulses = {who: table(cls.folder[who] / "interface_1.csv") for who in cls.folder}
        cls.nodes = {who: table(cls.folder[who] / "nodes.csv") for who in cls.folder}

    def assert_near(self, got, expected, scale, tolerance=1e-9):
        self.assertLessEqual(abs(got - expected), tolerance * scale, f"{got} is not {expected}")

    def test_times_are_those_of_the_histories(self):
        for who, rows in self.impulses.items():
            times = [row["time"] for row in rows]
            self.assertGreater(len(times), 300)
            for kind in (self.blank, self.tool):
                self.assertEqual([time for time, grid in kind[who]], times)
                self.assertEqual([grid.time for time, grid in kind[who]], times)

    def test_nodes_are_where_nodes_csv_has_them(self):
        for who, rows in self.nodes.items():
            wanted = {}
            for row in rows:
                wanted.setdefault(row["time"], []).append(row)
            start, compared = {}, 0
            for (time, blank), (_, tool) in zip(self.blank[who], self.tool[who]):
                place = dict(zip(blank.point["NODE_ID"], blank.points)) | dict(zip(tool.point["NODE_ID"], tool.points))
                start = start or place
                for row in wanted[time]:
                    if row["node"] not in place:
                        continue
                    compared += 1
                    for i, name in enumerate(("DX", "DY", "DZ")):
                        self.assertEqual(place[row["node"]][i] - start[row["node"]][i], row[name])
            self.assertGreater(compared, 5000)

    def test_forces_are_the_impulses_of_the_histories(self):
        """The tool gets F w from each node in each cycle, w the mean of the steps around it; every cycle is recorded here."""
        for who, rows in self.impulses.items():
            scale = max(abs(row["FNZ"]) for row in rows)
            contacts = 0
            for before, (time, blank), (_, tool), row, after in zip(rows, self.blank[who][1:], self.tool[who][1:], rows[1:], rows[2:]):
                weight = (after["time"] - before["time"]) / 2
                force, friction = total(blank.point["contact_force"]), total(blank.point["tangential_force"])
                on_tool, friction_on_tool = total(tool.cell["contact_force"]), total(tool.cell["tangential_force"])
                for i, axis in enumerate("XYZ"):
                    rise = row[f"FT{axis}"] - before[f"FT{axis}"]
                    self.assert_near(-friction[i] * weight, rise, scale)
                    self.assert_near(-force[i] * weight, rise + row[f"FN{axis}"] - before[f"FN{axis}"], scale)
                    self.assert_near(on_tool[i], -force[i], scale / weight)
                    self.assert_near(friction_on_tool[i], -friction[i], scale / weight)
                contacts += sum(1 for status in blank.point["status"] if status)
                # E t of the sheet: CE_ELAST is the sum of k p^2 / 2.
                elastic = math.fsum(0.5 * 252000 * p * p for p in blank.point["penetration"])
                self.assert_near(elastic, row["CE_ELAST"], max(r["CE_ELAST"] for r in rows))
            self.assertGreater(contacts, 5000)

    def test_pressure_is_the_normal_force_over_the_area(self):
        for who, rows in self.impulses.items():
            scale = max(abs(row["||FN||"]) for row in rows)
            first = self.blank[who][0][1]
            share = [0.0] * len(first.points)
            for cell in first.cells:
                x = [first.points[i] for i in cell]
                a, b = [p - q for p, q in zip(x[2], x[0])], [p - q for p, q in zip(x[3], x[1])]
                cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
                for i in cell:
                    share[i] += length(cross) / 8
            for before, (time, blank), row, after in zip(rows, self.blank[who][1:], rows[1:], rows[2:]):
                force = math.fsum(p * a for p, a in zip(blank.point["contact_pressure"], share))
                self.assert_near(-force * (after["time"] - before["time"]) / 2, row["||FN||"] - before["||FN||"], scale)

    def test_each_node_keeps_the_laws(self):
        for who in self.folder:
            slip_before, slipped, seen = None, 0, set()
            for (time, blank), (_, tool) in zip(self.blank[who], self.tool[who]):
                point, segments = blank.point, tool.cell["SEGMENT_ID"]
                self.assertEqual(segments, list(range(1, len(segments) + 1)))
                counts = [0] * len(segments)
                for i, status in enumerate(point["status"]):
                    seen.add(status)
                    if not status:
                        self.assertEqual((point["SEGMENT_ID"][i], point["penetration"][i], length(point["contact_force"][i])), (0, 0, 0))
                        continue
                    counts[int(point["SEGMENT_ID"][i]) - 1] += 1
                    normal, force, friction = point["normal"][i], point["contact_force"][i], point["tangential_force"][i]
                    self.assertAlmostEqual(length(normal), 1, 12)
                    self.assertGreater(point["gap"][i], 0)
                    pushed = sum(f * n for f, n in zip(force, normal))
                    across = sum(f * n for f, n in zip(friction, normal))
                    self.assertLessEqual(abs(across), 1e-9 * (length(force) + 1))
                    self.assertLessEqual(length(friction), FRICTION * abs(pushed) * (1 + 1e-9) + 1e-9)
                    if status == 2:
                        self.assertAlmostEqual(length(friction), FRICTION * abs(pushed), delta=1e-9 * (abs(pushed) + 1))
                self.assertEqual([int(n) for n in tool.cell["nodes_in_contact"]], counts)
                if slip_before:
                    for before, now, status in zip(slip_before, point["slip"], point["status"]):
                        self.assertGreaterEqual(now, before)
                        self.assertTrue(now == before or status == 2)
                        slipped += now > before
                slip_before = point["slip"]
            self.assertEqual(seen, {0, 1, 2})
            self.assertGreater(slipped, 1000)

    def test_both_implementations_show_the_same(self):
        for kind, data in ((self.blank, "point"), (self.tool, "cell")):
            for (_, ours), (_, theirs) in zip(kind["reference"], kind["optimized"]):
                self.assertEqual(ours.cells, theirs.cells)
                for name, values in getattr(ours, data).items():
                    others = getattr(theirs, data)[name]
                    if name in ("NODE_ID", "SEGMENT_ID", "ELEMENT_ID", "status", "nodes_in_contact"):
                        self.assertEqual(values, others)
                        continue
                    size = max((length(v) if isinstance(v, tuple) else abs(v)) for v in values)
                    for a, b in zip(values, others):
                        far = math.dist(a, b) if isinstance(a, tuple) else abs(a - b)
                        self.assertLessEqual(far, 1e-9 * size, name)

    def test_units_are_given(self):
        blank = self.blank["reference"][0][1]
        self.assertEqual(blank.units[:3], ["time [s]", "points [mm]", "NODE_ID [-]"])
        for words in ("gap [mm]", "contact_force [N]", "contact_pressure [MPa]", "slip [mm]", "status [-]"):
            self.assertIn(words, blank.units)

    def test_a_second_run_leaves_nothing_of_the_first(self):
        folder = FOLDER / "again"
        deck = ROOT / f"cases/{CASE}/{CASE}_0000.rad"
        subprocess.run([TYPE21, "run", deck, "--out", folder, "--quiet", "--paraview"], check=True)
        (folder / "paraview/notes.txt").write_text("of the user")
        refused = subprocess.run([TYPE21, "run", deck, "--out", folder, "--quiet"], stderr=subprocess.PIPE, text=True)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("notes.txt", refused.stderr)
        self.assertTrue(any((folder / "paraview").glob("*.pvd")), "the result of before stays")
        (folder / "paraview/notes.txt").unlink()
        subprocess.run([TYPE21, "run", deck, "--out", folder, "--quiet"], check=True)
        self.assertFalse((folder / "paraview").exists())
        self.assertEqual(json.loads((folder / "run.json").read_text())["status"], "completed")


if __name__ == "__main__":
    TYPE21, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    if not find_vtk():
        print("skipped: VTK for Python (Debian: python3-vtk9) is not there")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0]], verbosity=2)
