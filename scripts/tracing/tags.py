"""Tags in the comments of the sources, `@manual eq 5, 6; field Pmax`, and the declaration that each stands before."""

import re

TAG = re.compile(r"^\s*//[/!]?<?\s*@manual\s+(.*\S)\s*$")
COMMENT = re.compile(r"^\s*//")
TEST = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)")


def rows_of_tag(text):
    """'eq 5, 6; field Pmax' -> ['eq 5', 'eq 6', 'field Pmax']; a range is written 1-4."""
    for clause in text.split(";"):
        kind, _, items = clause.strip().partition(" ")
        for item in items.split(","):
            item = item.strip()
            numbers = re.fullmatch(r"(\d+)-(\d+)", item)
            if numbers:
                for n in range(int(numbers[1]), int(numbers[2]) + 1):
                    yield f"{kind} {n}"
            else:
                yield f"{kind} {item}"


def name_of_code(line):
    """Name of what a line of C++ declares."""
    record = re.match(r"\s*(?:class|struct|enum(?: class)?)\s+(\w+)", line)
    if record:
        return record[1]
    # The last qualified name before the first parenthesis, else before = or ;.
    function = re.match(r"[^()=;]*?([\w:~]+)\s*\(", line)
    if function:
        return function[1]
    variable = re.search(r"(\w+)\s*(?:\[\])?\s*[={;]", line)
    return variable[1] if variable else None


def tags(path, is_test, complaints):
    """(row, line number of the target, its name) for each tag of a file."""
    lines = path.read_text().splitlines()
    for number, line in enumerate(lines):
        tag = TAG.match(line)
        if not tag:
            continue
        at = number + 1
        while at < len(lines) and (COMMENT.match(lines[at]) or lines[at].startswith("template")):
            at += 1
        code = lines[at] if at < len(lines) else ""
        if is_test:
            test = TEST.match(code)
            name = f"{test[1]}.{test[2]}" if test else None
        elif code.startswith("#"):
            name = path.stem  # a tag in the comment of the file
            at = number
        else:
            name = name_of_code(code)
        if name is None:
            complaints.append(f"{path}:{number + 1}: the tag stands before no {'test' if is_test else 'declaration'}")
            continue
        for row in rows_of_tag(tag[1]):
            yield row, number + 1, at + 1, name
