"""The built program, called as a user calls it. All numbers of the pictures come from here."""

import base64
import itertools
import json
import os
import re
import subprocess
import xml.etree.ElementTree as xml
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np


class PictureError(Exception):
    """A picture cannot be drawn; the message says what to do."""


class ProgramFailed(PictureError):
    """The program ended with an error, or its output lacks what a picture needs."""


class Contradiction(PictureError):
    """The program's answers are not what the picture is to show."""


class Answers:
    """What `type21 decide` says of many nodes; one array element for each node."""

    def __init__(self, answers):
        self.segment = np.array([a["segment"] for a in answers])
        self.triangle = np.array([a.get("triangle", 0) for a in answers])
        self.side = np.array([a.get("side", 0) for a in answers])
        self.kind = np.array([a["kind"] for a in answers])
        self.contact = self.kind == "contact"
        self.margin = np.array([np.inf if a["margin"] is None else float.fromhex(a["margin"]) for a in answers])


class Account:
    """What `type21 explain` says of one node at one time."""

    def __init__(self, record):
        self.cycle, self.time, self.step = record["cycle"], record["time"], record["step"]
        interface = record["interfaces"][0]
        self.sub_triangles = {
            (segment["segment"], one["k"]): one
            for segment in interface["candidates"]["segments"]
            for one in segment["triangles"]
        }
        self._lines = [line for section in interface["sections"] for line in section["lines"] if "symbol" in line]

    def _value(self, symbol, kind):
        for line in self._lines:
            if line["symbol"] == symbol and isinstance(line.get("value"), kind):
                return line["value"]
        raise ProgramFailed(f"explain prints no '{symbol}' at t = {self.time}; take a time when the node is in contact")

    def has(self, symbol):
        return any(line["symbol"] == symbol for line in self._lines)

    def number(self, symbol):
        return float(self._value(symbol, (int, float)))

    def vector(self, symbol):
        return np.array(self._value(symbol, list), dtype=float)

    def retained(self):
        """(segment, k) of the retained impact, segments from 1; None when there is none."""
        if not self.has("segment"):
            return None
        words = re.match(r"(\d+) .*k = (\d)", self._value("segment", str))
        return int(words.group(1)), int(words.group(2))

    def weights(self):
        """(a, b, c) of the retained impact."""
        return np.array([float(x) for x in self._value("a, b, c", str).split(",")])


class Program:
    """@param folder  for its input and output   @param cases  the folder of the shipped cases"""

    def __init__(self, path, folder, cases):
        self.cases = Path(cases)
        self.path, self.folder, self._files = Path(path), Path(folder), itertools.count(1)

    def _call(self, *arguments):
        command = [str(self.path), *map(str, arguments)]
        try:
            done = subprocess.run(command, capture_output=True, text=True)
        except OSError as error:
            raise ProgramFailed(f"{self.path} cannot be run: {error.strerror}") from error
        if done.returncode != 0:
            raise ProgramFailed(f"exit code {done.returncode} of: {' '.join(command)}\n{done.stderr.strip()}")

    def new_file(self, suffix=".json"):
        return self.folder / f"{next(self._files)}{suffix}"

    def decide(self, tool, points, gap, depth):
        """@param tool  (nodes, normals, segments); segments have four ranks from 0, a triangle repeats its third"""
        nodes, normals, segments = tool
        queries = [{"p": list(map(float, p)), "gap": gap, "depth": depth} for p in points]
        block = {
            "nodes": np.asarray(nodes, float).tolist(),
            "normals": np.asarray(normals, float).tolist(),
            "segments": [list(map(int, s)) for s in segments],
            "queries": queries,
        }
        asked, out = self.new_file(), self.new_file()
        asked.write_text(json.dumps({"blocks": [block]}))
        self._call("decide", asked, "--out", out)
        return Answers(json.loads(out.read_text())["blocks"][0]["answers"])

    def explain(self, deck, node, time, thickness=None):
        out = self.new_file()
        self._call(
            "explain",
            deck,
            "--node",
            node,
            "--time",
            repr(float(time)),
            "--json",
            out,
            *(["--thickness", thickness] if thickness else []),
        )
        return Account(json.loads(out.read_text()))

    def explain_all(self, asked):
        """The accounts of many (deck, node, time), in their order."""
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(lambda one: self.explain(*one), asked))

    def contact_at_time_zero(self, deck):
        """Arrays of the blank's nodes in the first cycle: {"NODE_ID": ..., "normal": ..., "penetration": ...}."""
        out = self.new_file("")
        self._call("run", deck, "--out", out, "--paraview", "--quiet")
        return read_vtu(min((out / "paraview").glob("blank_*.vtu")))


def read_vtu(path):
    """Points and point arrays of a .vtu file of `type21 run --paraview`."""
    types = {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}
    arrays = {}
    for place in ("PointData", "Points"):
        for array in xml.parse(path).getroot().iter(place):
            for one in array:
                raw = base64.b64decode(one.text.strip())[8:]
                values = np.frombuffer(raw, types[one.get("type")])
                parts = int(one.get("NumberOfComponents"))
                arrays[one.get("Name")] = values if parts == 1 else values.reshape(-1, parts)
    return arrays
