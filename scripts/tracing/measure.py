"""Which functions run when a test runs alone: each test is a process of its own, counted by clang, read by LLVM's tools."""

import json
import os
import re
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path


def executable_of(test_file):
    """verification/tests/decisions/queries/test_a.cpp -> test_decisions_queries, as CMake names it; optimized/sorted -> test_optimized."""
    folders = Path(test_file).parts[2:-1]
    floors = ("decisions", "results", "criteria", "performance")  # one executable for each of their folders
    return "test_" + "_".join(folders[:2] if folders[0] in floors else folders[:1])


def run(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


class Executable:
    """A test executable of the coverage build, and where each counted function of it begins."""

    def __init__(self, root, build, name):
        self.root = root
        self.path = build / "verification/tests" / name
        self.places = {}  # name of the linker -> (path, line)

    def run_alone(self, test, folder):
        """Names of the functions that ran."""
        if not self.path.exists():
            sys.exit(f"error: {self.path} is not built; scripts/coverage builds it")
        raw, data = Path(folder) / "counts.profraw", Path(folder) / "counts.profdata"
        said = run(self.path, f"--gtest_filter={test}", cwd=self.root,
                   env=os.environ | {"LLVM_PROFILE_FILE": str(raw)})
        if "[  PASSED  ] 1 test." not in said:
            sys.exit(f"error: {self.path.name} has no test {test} that passes:\n{said[-2000:]}")
        run("llvm-profdata", "merge", "-sparse", raw, "-o", data)
        if not self.places:
            self.read_places(data)
        return names_that_ran(run("llvm-profdata", "show", "--all-functions", data))

    def read_places(self, data):
        whole = json.loads(run("llvm-cov", "export", "-skip-expansions", f"-instr-profile={data}", self.path))
        for function in whole["data"][0]["functions"]:
            path = real(function["filenames"][0])
            if path.is_relative_to(self.root):
                self.places[function["name"]] = (path, function["regions"][0][0])


@lru_cache(maxsize=None)
def real(name):
    return Path(name).resolve()  # headers are seen through links of the build


def names_that_ran(shown):
    ran = set()
    name = ""
    for line in shown.splitlines():
        if line.startswith("  ") and not line.startswith("   ") and line.endswith(":"):
            name = line.strip()[:-1]
        count = re.fullmatch(r"\s+Function count: (\d+)", line)
        if count and count[1] != "0":
            ran.add(name)
    return ran


def measure(root, build, texts, names, say):
    """test -> its entry of the record, for the tests named."""
    entries = {}
    executables = {}
    with tempfile.TemporaryDirectory() as folder:
        for name in sorted(names, key=lambda n: (texts.place[n], n)):
            target = executable_of(texts.place[name])
            executable = executables.setdefault(target, Executable(root, build, target))
            ran = [executable.places[f] for f in executable.run_alone(name, folder) if f in executable.places]
            reaches = sorted(f for f in texts.asked[name] if within(ran, texts.pieces[f]))
            entries[name] = {"text": texts.tests[name], "reaches": reaches,
                             "misses": sorted(texts.asked[name] - set(reaches))}
            say(f"{target} {name}: {len(reaches)} of {len(texts.asked[name])}")
    return entries


def within(places, found):
    return any(path == there and first <= line <= last for path, line in places for there, first, last in found)
