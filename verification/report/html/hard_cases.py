"""Hard geometric questions: the answers of the program by question family, and drawings of the atlas."""

import json
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy as np

import scene
from store import digest

HERE = Path(__file__).resolve().parent


def ask(program, file, how):
    """The answers of type21 decide to a file; exit code 3 means that some differ from those of the file."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "answers.json"
        done = subprocess.run([program, "decide", file, "--with", how, "--out", out], capture_output=True, text=True)
        if done.returncode not in (0, 3):
            raise RuntimeError(f"type21 decide {file}: exit code {done.returncode}: {done.stderr.strip()}")
        return json.loads(out.read_text())


def plain(answer):
    return tuple(answer.get(name) for name in (("kind",) if answer["kind"] == "none" else ("segment", "triangle", "side", "kind")))


def differing(truth, answers):
    """Number of answers that are not those of the file."""
    return sum(plain(a) != plain(b) for block, other in zip(truth["blocks"], answers["blocks"])
               for a, b in zip(block["answers"], other["answers"], strict=True))


def question_family(program, file):
    """One row of the table: queries, kinds, wrong answers of each method, stage shares, cost of the stages."""
    truth = json.loads(file.read_text())
    staged, double = ask(program, file, "reference"), ask(program, file, "double")
    answers = [answer for block in truth["blocks"] for answer in block["answers"]]
    return {
        "name": truth.get("family", file.stem) if file.parent.name == "decisions" else file.stem,
        "queries": len(answers),
        "kinds": {kind: sum(answer["kind"] == kind for answer in answers) for kind in ("contact", "proximity", "none")},
        "wrong": {"reference": differing(truth, staged), "double": differing(truth, double)},
        "stage_counts": staged["stage_counts"],
    }


def question_families(program, folder, store):
    """One row for each file of a folder; kept while the file and the program are unchanged."""
    binary = digest(program) if program.is_file() else "no program"
    code = digest(HERE / "hard_cases.py")
    return [store.get(f"decide-{file.stem}", digest(binary, code, file), lambda file=file: question_family(program, file))
            for file in sorted(folder.glob("*.json"))]


def exact(value):
    return Fraction(float.fromhex(value) if isinstance(value, str) else float(value))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def projection(block, query, answer):
    """The point Q of the answered sub-triangle below a node, in rational numbers; None when there is no answer.
    Lift A, B, C along their normals to the height of P, take the weights there, go along the interpolated normal."""
    if answer["kind"] == "none":
        return None
    nodes, normals = ([[exact(x) for x in row] for row in block[name]] for name in ("nodes", "normals"))
    p = [exact(x) for x in query["p"]]
    corners = block["segments"][answer["segment"]]
    if len(corners) == 3 or corners[2] == corners[3]:
        points, lifts = [nodes[i] for i in corners[:3]], [normals[i] for i in corners[:3]]
    else:
        k = answer["triangle"] - 1
        pair = [corners[k], corners[(k + 1) % 4]]
        mean = lambda rows: [sum(rows[i][axis] for i in corners) / 4 for axis in range(3)]
        points, lifts = [mean(nodes), *(nodes[i] for i in pair)], [mean(normals), *(normals[i] for i in pair)]
    a, b, c = points
    area = cross(minus(b, a), minus(c, a))
    height = dot(minus(p, a), area)
    if height != 0:
        if any(dot(n, area) <= 0 for n in lifts):
            return None
        lifted = [[v + n_v * height / dot(n, area) for v, n_v in zip(point, n)] for point, n in zip(points, lifts)]
    else:
        lifted = points
    la, lb, lc = lifted
    m = cross(minus(lb, la), minus(lc, la))
    if dot(m, m) == 0:
        return None
    wb = dot(cross(minus(p, la), minus(lc, la)), m) / dot(m, m)
    wc = dot(cross(minus(lb, la), minus(p, la)), m) / dot(m, m)
    n = [(1 - wb - wc) * x + wb * y + wc * z for x, y, z in zip(*lifts)]
    if dot(n, area) <= 0:
        return None
    step = dot(area, minus(a, p)) / dot(n, area)
    return [x + direction * step for x, direction in zip(p, n)]


def times(ratio):
    """A ratio in words; the doubles' own range does not hold every ratio of two of them."""
    try:
        return f"{float(ratio):.3g} times"
    except OverflowError:
        return f"1e{len(str(int(ratio))) - 1} times"


class Frame:
    """Axes stretched so that a needle 1e-16 wide can be seen; `words` names the stretched axes."""

    def __init__(self, points):
        axes = list(zip(*points))
        self.low = [min(axis) for axis in axes]
        spans = [max(axis) - min(axis) for axis in axes]
        top = max(spans)
        self.spans = [span if span * 20 > top else (span * 3 if span else top) for span in spans]
        self.spans = [top if span * 20 > top else span for span in self.spans]
        self.words = [f"{name} stretched {times(top / span)}" for name, span in zip("xyz", self.spans) if span and span != top]

    def __call__(self, point):
        return np.array([float((x - low) / span) if span else 0.0 for x, low, span in zip(point, self.low, self.spans)])


def marks(view, places, answers):
    """A mark and a number for each node. Nodes within a mark's width of each other stand in a row, so that each shows its own answer."""
    rows = []
    apart = 13 if len(places) < 10 else 18  # room for the numbers
    for number, place in enumerate(places):
        x, y = view.at(place)
        row = next((row for row in rows if -9 < x - row[0] < apart * len(row[2]) and abs(row[1] - y) < 9), None)
        if row is None:
            rows.append((x, y, [number]))
        else:
            row[2].append(number)
    out = []
    for x, y, numbers in rows:
        if len(numbers) > 1:
            out.append(f'<line class="row" x1="{x:.1f}" y1="{y:.1f}" x2="{x + apart * (len(numbers) - 1):.1f}" y2="{y:.1f}"/>')
        for k, number in enumerate(numbers):
            out.append(f'<circle class="{answers[number]["kind"]}" cx="{x + apart * k:.1f}" cy="{y:.1f}" r="3.4"/>'
                       f'<text x="{x + apart * k + (0 if len(numbers) > 1 else 5):.1f}" y="{y - 5:.1f}"{" text-anchor=" + chr(34) + "middle" + chr(34) if len(numbers) > 1 else ""}>{number + 1}</text>')
    return out


def draw(block, answers):
    """SVG of a small tool with normals, the nodes asked about, their gaps' answers and projections."""
    points = [[exact(x) for x in row] for row in block["nodes"]]
    asked = [[exact(x) for x in query["p"]] for query in block["queries"]]
    feet = [projection(block, query, answer) for query, answer in zip(block["queries"], answers)]
    frame = Frame(points + asked)
    nodes = {i: frame(point) for i, point in enumerate(points)}
    tips = {}
    for i, row in enumerate(block["normals"]):
        normal = np.array([float(exact(x)) for x in row])
        size = np.linalg.norm(normal)
        tips[i] = nodes[i] + (0.16 * normal / size if size else 0)
    places = [frame(point) for point in asked]
    view = scene.View([*nodes.values(), *tips.values(), *places])
    shapes = [shape for _, shape in sorted(scene.polygons(view, nodes, block["segments"], "tool"), key=lambda s: -s[0])]

    def line(a, b, name):
        (x1, y1), (x2, y2) = view.at(a), view.at(b)
        return f'<line class="{name}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>'

    shapes += [line(nodes[i], tips[i], "normal") for i in nodes]
    for place, foot in zip(places, feet):
        if foot is not None:
            shapes.append(line(place, frame(foot), "foot"))
    shapes += marks(view, places, answers)
    style = scene.STYLE + (".normal{stroke:#8c7440;stroke-width:.8}.foot{stroke:#222;stroke-width:.9;stroke-dasharray:3 2}"
                           ".row{stroke:#999;stroke-width:.8}.contact{fill:#332288}.proximity{fill:#2f7fa3}.none{fill:#fff;stroke:#555}")
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {scene.WIDTH} {view.height:.0f}" width="{scene.WIDTH}" '
           f'height="{view.height:.0f}"><style>{style}</style>{"".join(shapes)}{scene.triad(view)}</svg>')
    return svg, frame.words


def entry(program, file):
    """An entry of the atlas: its drawings, and the answers of the file, of plain double and of the program."""
    truth = json.loads(file.read_text())
    ours = ask(program, file, "reference")
    blocks = []
    for block, answered in zip(truth["blocks"], ours["blocks"]):
        # The file's own answers of plain double, else those of the program's.
        double = block.get("double") or ask(program, file, "double")["blocks"][len(blocks)]["answers"]
        svg, words = draw(block, block["answers"])
        rows = [{"exact": truth_, "double": plain_, "wrong": plain(truth_) != plain(plain_), "ours": plain(truth_) == plain(mine),
                 "stage": mine.get("stage", ""), "ulps": mine.get("margin_ulps")}
                for truth_, plain_, mine in zip(block["answers"], double, answered["answers"], strict=True)]
        # A note is one text, or one for each node.
        note = block.get("note", "")
        each = note if isinstance(note, list) and len(note) == len(rows) else []
        blocks.append({"svg": svg, "stretched": words, "note": "" if each else "; ".join(note) if isinstance(note, list) else note,
                       "notes": each, "rows": rows})
    return {"name": file.stem, "title": truth.get("title", file.stem), "what": truth.get("what", ""), "blocks": blocks}


def atlas(program, folder, store):
    binary = digest(program) if program.is_file() else "no program"
    code = digest(HERE / "hard_cases.py", HERE / "scene.py")
    return [store.get(f"atlas-{file.stem}", digest(binary, code, file), lambda file=file: entry(program, file))
            for file in sorted(folder.glob("*.json"))]
