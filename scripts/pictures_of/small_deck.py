"""Small decks for the pictures, in Mg mm s: a fixed or driven tool and a fixed blank."""

import numpy as np

from .program import ProgramFailed

FIRST_TOOL, FIRST_BLANK, MAIN = 1001, 10001, 900


def _number(value):
    text = repr(float(value))
    return f"{text if len(text) <= 20 else format(float(value), '.12e'):>20}"


def _nodes(first, points):
    return "\n".join(f"{first + i:10d}" + "".join(map(_number, p)) for i, p in enumerate(points))


def _shells(part, first_element, first_node, segments):
    """Quads and triangles apart, as the deck wants them."""
    quads, triangles = [], []
    for i, corners in enumerate(segments):
        ids = [first_node + c for c in corners]
        (triangles if ids[2] == ids[3] else quads).append((first_element + i, ids))
    text = []
    if quads:
        text += [f"/SHELL/{part}"] + ["".join(f"{n:10d}" for n in (e, *ids)) for e, ids in quads]
    if triangles:
        text += [f"/SH3N/{part}"] + ["".join(f"{n:10d}" for n in (e, *ids[:3])) for e, ids in triangles]
    return "\n".join(text)


def _function(rank, points):
    return "\n".join([f"/FUNCT/{rank}", "function"] + [_number(t) + _number(v) for t, v in points])


def write(folder, name, tool, blank, gap, depth=0.0, fric=0.0, velocity=None, step=1e-6, cycles=1):
    """@param tool, blank  (nodes, segments); segments have four ranks from 0, a triangle repeats its third
    @param velocity  of the tool: {"X": [(time, value), ...], ...}; none: the tool is fixed
    @return path of the starter deck"""
    velocity = velocity or {}
    moves = [axis for axis in "XYZ" if axis in velocity]
    guided = "".join("0" if axis in velocity else "1" for axis in "XYZ")
    motion = "\n".join(
        _function(i + 1, velocity[axis])
        + f"\n/IMPVEL/{i + 1}\ntool\n{i + 1:10d}{axis:>10}{0:10d}{0:10d}{9:10d}{0:10d}\n"
        + _number(1)
        + _number(1)
        + _number(0)
        + _number(0)
        for i, axis in enumerate(moves)
    )
    shell = (
        "property\n"
        + f"{0:10d}" * 5
        + _number(0)
        + "\n"
        + _number(0) * 5
        + f"\n{1:10d}"
        + _number(1)
        + _number(0)
        + f"{0:10d}" * 3
    )
    starter = f"""#RADIOSS STARTER
/BEGIN
{name}
      2025         0
                  Mg                  mm                   s
                  Mg                  mm                   s
/TITLE
{name}
/MAT/ELAST/1
blank
              7.8e-9
            210000.0                 0.3
/MAT/VOID/2
tool
              7.8e-9            210000.0                 0.3
/PROP/SHELL/1
{shell}
/PART/1
blank
         1         1         0                 0.0
/PROP/SHELL/101
{shell}
/PART/101
tool
       101         2         0                 0.0
/NODE
{_nodes(FIRST_TOOL, tool[0])}
{_nodes(FIRST_BLANK, blank[0])}
{_nodes(MAIN, [(0, 0, 0)])}
{_shells(1, 1, FIRST_BLANK, blank[1])}
{_shells(101, 100001, FIRST_TOOL, tool[1])}
/SURF/PART/1
blank
         1
/SURF/PART/2
tool
       101
/GRNOD/PART/1
blank
         1
/GRNOD/PART/101
tool
       101
/GRNOD/NODE/9
main node
{MAIN:10d}
/RBODY/1
tool
{MAIN:10d}         0         0         0                 1.0       101         1         4         0
              1000.0              1000.0              1000.0
                 0.0                 0.0                 0.0
         0                   0
/BCS/1
blank fixed
   111 111         0         1
/BCS/2
tool guided
   {guided} 111         0         9
{motion}
/INTER/TYPE21/1
contact
         1         2
{_number(0)}{_number(0)}{_number(depth)}

{_number(0)}{_number(fric)}{_number(gap)}







         1
/END
""".replace(
        "\n\n/INTER", "\n/INTER"
    )
    engine = (
        f"#RADIOSS ENGINE\n/VERS/2025\n/RUN/{name}/1\n{_number((cycles - 0.5) * step)}\n/TFILE/1\n{_number(step)}\n"
        f"/DTIX\n{_number(step)}{_number(step)}\n/PRINT/-100\n"
    )
    starter_file = folder / f"{name}_0000.rad"
    starter_file.write_text(starter)
    (folder / f"{name}_0001.rad").write_text(engine)
    return starter_file


def grid(u, v, point):
    """A blank of quads: nodes point(u_i, v_j), u fastest."""
    nodes = [point(x, y) for y in v for x in u]
    m = len(u)
    return np.array(nodes, float), [
        (j * m + i, j * m + i + 1, (j + 1) * m + i + 1, (j + 1) * m + i)
        for j in range(len(v) - 1)
        for i in range(m - 1)
    ]


def explain_points(program, tool, points, gap, depth, together=16):
    """The accounts of nodes at these points at time 0. Each node has a small quad of its own. A deck has few nodes,
    because explain computes all of them."""
    asked = []
    for first in range(0, len(points), together):
        part = np.asarray(points[first : first + together], float)
        nodes = np.concatenate([p + np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0]]) for p in part])
        quads = [(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3) for i in range(len(part))]
        deck = write(program.folder, program.new_file("").name, tool, (nodes, quads), gap, depth)
        asked += [(deck, FIRST_BLANK + 4 * i, 0) for i in range(len(part))]
    return program.explain_all(asked)


def nodal_normals(program, tool):
    """The program's own nodal normals: a node that lies in a corner has that corner's normal as its contact normal."""
    deck = write(program.folder, f"normals{program.new_file('').name}", tool, tool, gap=0.5)
    of = program.contact_at_time_zero(deck)
    rank = of["NODE_ID"] - FIRST_BLANK
    normals = np.zeros((len(tool[0]), 3))
    normals[rank] = of["normal"]
    if np.abs(np.linalg.norm(normals, axis=1) - 1).max() > 1e-12:
        raise ProgramFailed("a node in the place of a tool corner is not in contact: its nodal normal is unknown")
    return normals
