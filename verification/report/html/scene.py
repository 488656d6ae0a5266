"""A drawing of the scene at time 0 along a diagonal, as SVG: blank, tool, and the motion of the tool."""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import words

WIDTH, HEIGHT, MARGIN = 460, 300, 26
USUAL = np.array([-1.0, -1.0, 1.0]) / np.sqrt(3)  # towards the viewer
DIAGONALS = [USUAL] + [np.array([x, y, z]) / np.sqrt(3) for z in (1.0, -1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
FLAT = 0.999  # length of the mean normal of a tool that has one side only
SAND, BACK = np.array([222, 207, 174]), np.array([168, 156, 136])


def geometry(program, deck):
    """(nodes {id: position}, secondary segments, main segments of each tool, deck summary) of a deck; None when it is refused."""
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
    tools = []
    for side in sides:
        tool = sorted({tuple(segment) for segment in side["main"]})
        if tool not in tools:
            tools.append(tool)
    return nodes, sorted({tuple(segment) for side in sides for segment in side["secondary"]}), tools, summary


def area_vector(nodes, segment):
    a, b, c, d = (nodes[corner] for corner in (*segment, segment[2])[:4])
    return 0.5 * np.cross(c - a, d - b) if len(segment) == 4 and segment[3] != segment[2] else 0.5 * np.cross(b - a, c - a)


def middles(nodes, segments):
    return np.array([np.mean([nodes[corner] for corner in segment], axis=0) for segment in segments])


def side_of(nodes, blank, tool):
    """(mean area vector of a tool where the blank is nearest, that of the whole tool), over its area there and in all."""
    vectors = np.array([area_vector(nodes, segment) for segment in tool])
    sizes = np.linalg.norm(vectors, axis=1)
    places, centres = middles(nodes, blank), middles(nodes, tool)
    near = np.unique([np.linalg.norm(centres - place, axis=1).argmin() for place in places])
    return vectors[near].sum(axis=0) / max(sizes[near].sum(), 1e-300), vectors.sum(axis=0) / max(sizes.sum(), 1e-300)


def towards_viewer(sides):
    """From above, unless a tool that is not flat would show its back: then from where its contact side is seen best.
    A convex tool seen from behind would look concave."""
    if all(np.linalg.norm(whole) > FLAT for _, whole in sides):
        return USUAL
    seen = lambda way: sum(near @ way + 0.5 * whole @ way for near, whole in sides)
    best = max(DIAGONALS, key=seen)
    return USUAL if seen(USUAL) > 0 and all(near @ USUAL > 0 for near, _ in sides) else best


class View:
    """Direction, scale and origin of the picture. `deep` is larger farther away. What is seen from below is turned upside
    down, z downward: readers take every such drawing for one from above, and would see its edges the wrong way round."""

    def __init__(self, points, towards=USUAL):
        self.right = np.cross([0.0, 0.0, np.sign(towards[2])], towards)
        self.right /= np.linalg.norm(self.right)
        self.up, self.deep = np.cross(towards, self.right), -towards
        flat = np.array([[point @ self.right, point @ self.up] for point in points])
        low, high = flat.min(axis=0), flat.max(axis=0)
        span = np.maximum(high - low, 1e-12 * max(1.0, np.abs(flat).max()))
        self.scale = float(min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1]))
        self.low = (low + high) / 2
        self.height = min(HEIGHT, float(span[1] * self.scale) + 2 * MARGIN + 14)

    def at(self, point):
        x = WIDTH / 2 + (point @ self.right - self.low[0]) * self.scale
        y = self.height / 2 - (point @ self.up - self.low[1]) * self.scale
        return x, y


def shade(view, vector):
    """Sand in the light for the contact side of a tool, darker and greyer for its back."""
    size = np.linalg.norm(vector)
    if not size:
        return "#d9c9a8"
    front = vector @ view.deep < 0
    light = 0.84 + 0.16 * (vector @ (0.9 * view.up - 0.4 * view.right)) / size * (1 if front else -1)
    return "#" + "".join(f"{int(channel):02x}" for channel in np.clip((SAND if front else BACK) * light, 0, 255))


def polygons(view, nodes, segments, side):
    """(depth, SVG) of each segment."""
    for segment in segments:
        corners = [nodes[corner] for corner in segment]
        depth = float(np.mean([corner @ view.deep for corner in corners]))
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(view.at, corners))
        fill = "" if side == "blank" else f' fill="{shade(view, area_vector(nodes, segment))}"'
        yield depth, f'<polygon class="{side}"{fill} points="{points}"/>'


def in_order(view, nodes, blank, tools, sides):
    """Shapes from back to front. Sheets that touch cannot be sorted piece by piece: tools that show their contact side
    are behind the blank, those that show their back are in front of it, and transparent."""
    behind = [near @ view.deep < 0 for near, _ in sides]
    groups = [(tool, "tool back") for tool, far in zip(tools, behind) if far] + [(blank, "blank")] + [(tool, "tool") for tool, far in zip(tools, behind) if not far]
    return [shape for segments, name in groups for _, shape in sorted(polygons(view, nodes, segments, name), key=lambda s: -s[0])]


def arrow(view, start, way):
    """The motion of the tool; not to scale when it would be too short or too long."""
    direction = np.array([way @ view.right, -(way @ view.up)])
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
        dx, dy = 18 * (axis @ view.right), -18 * (axis @ view.up)
        x, y = 24, view.height - (22 if view.up[2] > 0 else 42)
        out.append(f'<line class="axis" x1="{x}" y1="{y:.1f}" x2="{x + dx:.1f}" y2="{y + dy:.1f}"/>'
                   f'<text x="{x + 1.45 * dx:.1f}" y="{y + 1.45 * dy + 3:.1f}" text-anchor="middle">{name}</text>')
    return "".join(out)


STYLE = (".blank{fill:#9dbcd4;stroke:#3f6e91;fill-opacity:.85}.tool{stroke:#8c7440;fill-opacity:.5}.back{fill-opacity:1}"
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
    nodes, secondary, tools, summary = found
    main = sorted({segment for tool in tools for segment in tool})
    used = sorted({corner for segment in (*secondary, *main) for corner in segment})
    sides = [side_of(nodes, secondary, tool) for tool in tools]
    view = View([nodes[corner] for corner in used], towards_viewer(sides))
    shapes = in_order(view, nodes, secondary, tools, sides)
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
    from_below = ", seen from below with z downward" if view.deep[2] > 0 else ""
    caption = (f"Blank (blue) of {words.plural(len(secondary), 'segment')}, tool (sand, its back grey) of {len(main)}{from_below}, {size[0]:.4g} × {size[1]:.4g} × {size[2]:.4g} "
               f"{length}" + ("; " + ", ".join(moves) if moves else "") + ".")
    return {"svg": svg, "caption": caption}
