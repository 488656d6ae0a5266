"""Where a declaration of C++ is defined: the lines of its text, and a hash of it that comments and layout do not change."""

import hashlib
import re
from functools import lru_cache

TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+'|[^\s"'/]+|\s+|.""", re.S)


@lru_cache(maxsize=None)
def lines_of(path):
    return path.read_text().splitlines()


def end_of(lines, start):
    """(last line, has a body) of what begins in line `start`, both counted from 0: up to the ; or the } that ends it."""
    braces = parentheses = 0
    text = "\n".join(lines[start:])
    line = start
    for token in TOKEN.finditer(text):
        word = token[0]
        if word[:2] not in ("//", "/*") and word[0] not in "\"'":
            for mark in word:
                if mark == "{":
                    braces += 1
                elif mark == "}":
                    braces -= 1
                    if braces == 0 and parentheses == 0:
                        return line, True
                elif mark == "(":
                    parentheses += 1
                elif mark == ")":
                    parentheses -= 1
                elif mark == ";" and braces == 0 and parentheses == 0:
                    return line, False
        line += word.count("\n")
    return len(lines) - 1, False


def definitions_in(path, pattern):
    """(path, first line, last line), from 1, of what begins at the left margin of a file, matches, and has a body."""
    lines = lines_of(path)
    found = []
    for start, line in enumerate(lines):
        if pattern.match(line):
            end, has_body = end_of(lines, start)
            if has_body:
                found.append((path, start + 1, end + 1))
    return found


def pieces(root, path, line, name):
    """All that belongs to the declaration of `name` in this line: its text, and the definitions that stand elsewhere.

    Of a class the members that are defined outside of it; of a function that is only declared, its definition in the source
    beside the header, in the folder, or, for what another class implements, anywhere in reference/ and optimized/.
    """
    lines = lines_of(path)
    beside = path.with_suffix(".cpp")
    if lines[line - 1].lstrip().startswith("//"):  # a tag in the comment of a file
        return [(p, 1, len(lines_of(p))) for p in dict.fromkeys((path, beside)) if p.exists()]
    end, has_body = end_of(lines, line - 1)
    here = [(path, line, end + 1)]
    if re.match(r"\s*(class|struct)\s", lines[line - 1]):
        member = re.compile(rf"[^\s/#].*\b{name}::[\w~]+\s*(\(|$)|{name}::")
        return here + (definitions_in(beside, member) if beside != path and beside.exists() else [])
    if has_body:
        return here
    free = re.compile(rf"[^\s/#].*\b{re.escape(name)}\s*\(")
    member = re.compile(rf"[^\s/#].*::{re.escape(name)}\s*\(")
    for places, pattern in (
        ([beside] if beside.exists() else [], free),
        (sorted(path.parent.glob("*.cpp")), free),
        (sorted(p for top in ("reference", "optimized") for p in (root / top).rglob("*.cpp")), member),
    ):
        found = [piece for place in places for piece in definitions_in(place, pattern)]
        if found:
            return here + found
    return here


def hash_of(found):
    """A short hash of these pieces without comments and spaces."""
    sha = hashlib.sha256()
    for path, first, last in found:
        text = "\n".join(lines_of(path)[first - 1:last])
        for token in TOKEN.finditer(text):
            if token[0][:2] not in ("//", "/*") and not token[0].isspace():
                sha.update(token[0].encode())
    return sha.hexdigest()[:12]
