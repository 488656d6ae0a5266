"""An isometric drawing of the scene at time 0, as SVG: blank, tool, and the motion of the tool."""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import words

# Seen from (-1, -1, 1): to the right x - y, upward z and half of x + y; deeper is larger.
RIGHT = np.array([1.0, -1.0, 0.0]) / np.sqrt(2)
UP = np.array([1.0, 1.0, 2.0]) / np.sqrt(6)
DEEP = np.array([1.0, 1.0, -1.0]) / np.sqrt(3)
WIDTH, HEIGHT, MARGIN = 460, 300, 26


def geometry(program, deck):
    """(nodes {id: position}, secondary segments, main segments, deck summary) of a deck; None when it is refused."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "check.json"
        done = subprocess.run([program, "check", deck, "--geometry", "--json", out], capture_output=True, text=True)
        if done.returncode == 2:
            return None
        if done.returncode != 0:
            raise RuntimeError(f"type21 check {deck}: exit code {done.returncode}: {done.stderr.strip()}")
        summary = json.loads(out.read_text())
    nodes = {row[0]: np.array(row[1:]) for row in summary["geometry"]["nodes"]}
    sides = summary["geometry"]["interfaces"]
    secondary, main = ({tuple(segment) for side in sides for segment in side[name]} for name in ("secondary", "main"))
    return nodes, sorted(secondary), sorted(main), summary


class View:
    """Scale and origin of the picture."""

    def __init__(self, points):
        flat = np.array([[point @ RIGHT, point @ UP] for point in points])
        low, high = flat.min(axis=0), flat.max(axis=0)
        span = np.maximum(high - low, 1e-12 * max(1.0, np.abs(flat).max()))
        self.scale = float(min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1]))
        self.low = (low + high) / 2
        self.height = min(HEIGHT, float(span[1] * self.scale) + 2 * MARGIN + 14)

    def at(self, point):
        x = WIDTH / 2 + (point @ RIGHT - self.low[0]) * self.scale
        y = self.height / 2 - (point @ UP - self.low[1]) * self.scale
        return x, y


def polygons(view, nodes, segments, side):
    for segment in segments:
        corners = [nodes[corner] for corner in segment]
        depth = float(np.mean([corner @ DEEP for corner in corners]))
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(view.at, corners))
        yield depth, f'<polygon class="{side}" points="{points}"/>'


def in_order(view, nodes, secondary, main):
    """Shapes from back to front. Sheets that touch cannot be sorted piece by piece: the side that is
    behind is drawn first as a whole, and the one in front is transparent."""
    middle = lambda segments: np.array([np.mean([nodes[corner] for corner in segment], axis=0) for segment in segments])
    blank, tool = middle(secondary), middle(main)
    flat = [np.stack([points @ RIGHT, points @ UP], axis=1) for points in (blank, tool)]
    nearest = np.linalg.norm(flat[0][:, None] - flat[1][None, :], axis=2).argmin(axis=1)
    tool_in_front = np.mean(tool[nearest] @ DEEP - blank @ DEEP) < 0
    sides = [(secondary, "blank"), (main, "tool" if tool_in_front else "tool back")]
    return [shape for segments, name in (sides if tool_in_front else sides[::-1])
            for _, shape in sorted(polygons(view, nodes, segments, name), key=lambda s: -s[0])]


def arrow(view, start, way):
    """The motion of the tool; not to scale when it would be too short or too long."""
    direction = np.array([way @ RIGHT, -(way @ UP)])
    length = float(np.linalg.norm(direction)) * view.scale
    if length < 1e-9:
        return "", ""
    shown = min(max(length, 34.0), 110.0)
    x, y = view.at(start)
    dx, dy = direction / np.linalg.norm(direction) * shown
    note = "" if shown == length else ", arrow not to scale"
    return (f'<line class="way" x1="{x:.1f}" y1="{y:.1f}" x2="{x + dx:.1f}" y2="{y + dy:.1f}" marker-end="url(#tip)"/>', note)


def triad(view):
    out = []
    for name, axis in zip("xyz", np.eye(3)):
        dx, dy = 18 * (axis @ RIGHT), -18 * (axis @ UP)
        x, y = 24, view.height - 22
        out.append(f'<line class="axis" x1="{x}" y1="{y:.1f}" x2="{x + dx:.1f}" y2="{y + dy:.1f}"/>'
                   f'<text x="{x + 1.45 * dx:.1f}" y="{y + 1.45 * dy + 3:.1f}" text-anchor="middle">{name}</text>')
    return "".join(out)


STYLE = (".blank{fill:#9dbcd4;stroke:#3f6e91}.tool{fill:#d9c9a8;stroke:#8c7440;fill-opacity:.5}.back{fill-opacity:1}"
         "polygon{stroke-width:.6;stroke-linejoin:round}.way{stroke:#222;stroke-width:1.8}.axis{stroke:#777}"
         "text{font:11px system-ui,sans-serif;fill:#555}")


def way_of_tool(rbody):
    """Displacement of the first rigid body over the run and the largest turn of any [rad]; zeros without a history."""
    if rbody is None or not len(rbody.data):
        return np.zeros(3), 0.0
    table = rbody.of(rbody["rbody"][0])
    way = np.array([table.value(name, "end") - table.value(name, 0.0) if name in table else 0.0 for name in ("DX", "DY", "DZ")])
    rates = np.linalg.norm(np.stack([table[n] for n in ("VRX", "VRY", "VRZ")]), axis=0) if "VRX" in table else np.zeros(1)
    turn = float(np.trapz(rates, table["time"])) if len(rates) > 1 else 0.0
    return way, turn


def draw(found, rbody):
    """{svg, caption} of what geometry() found."""
    nodes, secondary, main, summary = found
    used = sorted({corner for segment in (*secondary, *main) for corner in segment})
    view = View([nodes[corner] for corner in used])
    shapes = in_order(view, nodes, secondary, main)
    way, turn = way_of_tool(rbody)
    corners = sorted({corner for segment in main for corner in segment})
    line, note = arrow(view, np.mean([nodes[corner] for corner in corners], axis=0), way)
    length = summary["units"]["length"]
    moves = []
    if np.linalg.norm(way) > 0:
        moves.append(f"the tool moves {np.linalg.norm(way):.4g} {length}{note}")
    if turn > 1e-12:
        moves.append(f"turns {np.degrees(turn):.4g}°")
    size = np.ptp(np.array([nodes[corner] for corner in used]), axis=0)
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {view.height:.0f}" width="{WIDTH}" height="{view.height:.0f}">'
           f'<style>{STYLE}</style><defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="6" markerHeight="6" '
           f'orient="auto"><path d="M0,0 L8,4 L0,8 z" fill="#222"/></marker></defs>'
           f'{"".join(shapes)}{line}{triad(view)}</svg>')
    caption = (f"Blank (blue) of {words.plural(len(secondary), 'segment')}, tool (sand) of {len(main)}, {size[0]:.4g} × {size[1]:.4g} × {size[2]:.4g} "
               f"{length}" + ("; " + ", ".join(moves) if moves else "") + ".")
    return {"svg": svg, "caption": caption}
