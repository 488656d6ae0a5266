#!/usr/bin/env python3
"""Runs what reference/examples/README.md shows and compares.

usage: test_examples.py README FOLDER_OF_THE_PROGRAMS
"""
import pathlib
import re
import subprocess
import sys


def main():
    text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    shown = re.findall(r"^```\n\$ (\w+)([^\n]*)\n(.*?)^```$", text, re.S | re.M)
    wrong = 0
    for program, arguments, expected in shown:
        done = subprocess.run([f"{sys.argv[2]}/{program}", *arguments.split()], capture_output=True, text=True)
        if done.returncode != 0 or done.stdout != expected:
            print(f"{program}{arguments} printed (exit code {done.returncode})\n{done.stdout}instead of\n{expected}")
            wrong += 1
    programs = {program for program, _, _ in shown}
    if programs != {"one_node", "one_node_exact"}:
        print(f"{sys.argv[1]} shows {sorted(programs)}")
        wrong += 1
    print(f"{len(shown)} examples, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
