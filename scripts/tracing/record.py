"""The record of which test reaches which function: verification/tests/reach.json, and what in it is older than the sources.

It holds, for each test with a tag, a hash of its text, and the functions of its rows that ran and that did not run when the test
ran alone; for each function a hash of its text. scripts/coverage writes it.
"""

import json

from tracing.source_text import hash_of, pieces

PLACE = "verification/tests/reach.json"
ABOUT = ("Which functions each test reaches when it runs alone, among those that carry a row of the test in their @manual tag. "
         "Written by scripts/coverage; texts are hashes of the sources measured.")


def key_of(function):
    return f"{function['place'].rsplit(':', 1)[0]} {function['name']}"


class Texts:
    """The sources as they are: the pieces and the hash of each function and test of the table, and who belongs to whom."""

    def __init__(self, root, table):
        self.pieces = {}    # function -> [(path, first, last)]
        self.functions = {}  # function -> hash
        self.tests = {}      # test -> hash
        self.place = {}      # test -> its file
        self.asked = {}      # test -> functions that share a row with it
        for entry in table.values():
            for item in functions_of(entry):
                path, line = item["place"].rsplit(":", 1)
                found = self.pieces.setdefault(key_of(item), [])
                found += [p for p in pieces(root, root / path, int(line), item["name"]) if p not in found]
            for item in entry["tests"]:
                path, line = item["place"].rsplit(":", 1)
                self.place[item["name"]] = path
                self.tests[item["name"]] = hash_of(pieces(root, root / path, int(line), item["name"]))
                self.asked.setdefault(item["name"], set()).update(key_of(f) for f in functions_of(entry))
        self.functions = {key: hash_of(found) for key, found in self.pieces.items()}


def functions_of(entry):
    return entry["functions"] + entry["optimized"]


def read(root):
    path = root / PLACE
    return json.loads(path.read_text()) if path.exists() else {"functions": {}, "tests": {}}


def write(root, texts, tests):
    """All tests of the record as measured; what no tag names any more goes."""
    def block(name, items):
        lines = [f"  {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}" for key, value in items]
        return f' {json.dumps(name)}: {{\n' + ",\n".join(lines) + "\n }"

    kept = [(name, tests[name]) for name in sorted(texts.tests) if name in tests]
    parts = [f' "about": {json.dumps(ABOUT)}', block("functions", sorted(texts.functions.items())), block("tests", kept)]
    (root / PLACE).write_text("{\n" + ",\n".join(parts) + "\n}\n")


def changed(texts, record):
    """test -> why what the record says of it no longer counts."""
    why = {}
    for name, text in texts.tests.items():
        old = record["tests"].get(name)
        if old is None:
            why[name] = "it is not in the record"
            continue
        if old["text"] != text:
            why[name] = "its text has changed"
            continue
        known = set(old["reaches"]) | set(old["misses"])
        others = [f for f in sorted(texts.asked[name])
                  if f not in known or record["functions"].get(f) != texts.functions[f]]
        if others:
            why[name] = "changed or new: " + ", ".join(others)
    return why
