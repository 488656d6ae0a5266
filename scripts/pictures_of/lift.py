"""Steps 2 and 3 of the projection: corners lifted to the node's height, then down along the interpolated normal."""

import numpy as np

from . import small_deck, style
from .program import Contradiction

# A triangle (A, B, C) = (x_3, x_1, x_2) with neighbours that fall away on all three sides: its normals fan out.
NODES = np.array([[0, 0, 0.0], [5, 0, 0], [2, 4.4, 0], [2.5, -1.7, 0.5], [5.2, 3.4, 0.4], [-1.9, 2.6, -2.6]])
SEGMENTS = [(0, 1, 2, 2), (3, 1, 0, 0), (4, 2, 1, 1), (5, 0, 2, 2)]
A, B, C = 2, 0, 1
NODE = np.array([3.3, 1.0, 1.5])
# A convex fold of two strips, seen from the side.
FOLD = np.array([[x, y, z] for y in (-4.0, 4.0) for x, z in ((-7, -2.8), (0, 0), (7, -2.8))])
STRIPS = [(0, 1, 4, 3), (1, 2, 5, 4)]
FOLD_NODE = np.array([0.45, 0.1, 1.9])
GAP = 2.6


def explained(program, tool, node, name):
    blank = small_deck.grid([0, 1], [0, 1], lambda u, v: node + [u, v, 0])
    deck = small_deck.write(program.folder, name, tool, blank, gap=4.0, depth=4.0)
    return program.explain(deck, small_deck.FIRST_BLANK, 0)


def lifted(corners, normals, one):
    """V' = V + n_V H/<n_V, N>, with H and <n_V, N> as explain prints them; they must carry its weights b', c'."""
    return corners + normals * (one["H"] / np.array(one["<n_V,N>"]))[:, None]


def check(node, corners, one):
    weights = np.array([1 - one["b'"] - one["c'"], one["b'"], one["c'"]])
    if np.abs(weights @ corners - node).max() > 1e-9:
        raise Contradiction("the lifted corners do not carry the node with the weights b', c' of explain")
    return weights


def space(axes, program):
    view = style.View(-108, 24)
    normals = small_deck.nodal_normals(program, (NODES, SEGMENTS))
    account = explained(program, (NODES, SEGMENTS), NODE, "lift")
    one = account.sub_triangles[1, 1]
    base, n = NODES[[A, B, C]], normals[[A, B, C]]
    top = lifted(base, n, one)
    w_top = check(NODE, top, one)
    x, nu = account.vector("X"), account.vector("nu")
    for corners in SEGMENTS[1:]:
        style.polygon(axes, view(NODES[list(corners)[:3]]), style.PALE, edge="#BBBBBB", width=0.8, over=1)
    style.polygon(axes, view(base), "#CFE6F5", width=1.6)
    style.polygon(axes, view(top), style.ORANGE, 0.28, edge=style.RED, line=(0, (4, 2)), over=4)
    for v, v_top, name, shift, shift_top in zip(
        base, top, "ABC", ((11, 0), (-8, -7), (8, -7)), ((-10, 0), (-9, 4), (9, 4))
    ):
        style.arrow(axes, view(v), view(v_top), style.BLUE, 1.4, 9)
        style.dot(axes, view(v))
        style.dot(axes, view(v_top), style.RED, 4)
        style.label(axes, view(v), f"${name}$", shift)
        style.label(axes, view(v_top), f"${name}'$", shift_top, style.RED)
        axes.plot(*np.transpose(view([NODE, v_top])), color=style.RED, lw=0.7, zorder=5)
        axes.plot(*np.transpose(view([x, v])), color=style.INK, lw=0.7, zorder=3)
    style.arrow(axes, view(NODE), view(x), style.INK, 1.8, 11)
    style.label(axes, view((NODE + x) / 2), "$n$", (-8, 3))
    style.dot(axes, view(NODE), style.INK, 7)
    style.label(axes, view(NODE), "node $P$", (4, 10))
    style.dot(axes, view(x), style.INK, 6, filled=False)
    style.label(axes, view(x), "$Q$", (9, -5))
    w = account.weights()
    axes.text(
        0.0,
        -0.02,
        f"in $A'B'C'$:  $b' = {w_top[1]:.3f}$,  $c' = {w_top[2]:.3f}$   (step 2)\n"
        f"in $ABC$:      $b = {w[1]:.3f}$,  $c = {w[2]:.3f}$   (step 3)",
        transform=axes.transAxes,
        va="top",
        fontsize=9,
    )
    axes.set_title("Corners lifted along their normals\nto the height of the node")
    style.bare(axes)


def side(axes, program):
    """The fold from the side: which strip is retained above it, and the lifted corners of one sub-triangle."""
    tool = (FOLD, STRIPS)
    normals = small_deck.nodal_normals(program, tool)
    u, v = np.linspace(-4.5, 4.5, 361), np.linspace(-1.8, 2.8, 185)
    answers = program.decide((FOLD, normals, STRIPS), [(x, FOLD_NODE[1], z) for z in v for x in u], GAP, 0.4)
    retained = np.where(answers.contact & (answers.side > 0), answers.segment, -1).reshape(len(v), len(u))
    style.field(axes, u, v, style.shaded(retained, (style.OWN, style.NEXT)))
    flat = FOLD[:3][:, [0, 2]]
    axes.fill_between(flat[:, 0], flat[:, 1], -2.4, color=style.PALE, lw=0, zorder=1)
    axes.plot(*flat.T, color=style.INK, lw=2, zorder=3)
    for strip in (flat[:2], flat[1:]):
        along = (strip[1] - strip[0]) / np.linalg.norm(strip[1] - strip[0])
        up = flat[1] + 3.4 * np.array([-along[1], along[0]])
        axes.plot(*np.transpose([flat[1], up]), color=style.GREY, lw=1, ls=(0, (2, 2)), zorder=2)
        style.label(axes, up, "perpendicular\nto a facet", (-34 if strip[0][0] < 0 else 34, 2), style.GREY, 8)
    style.arrow(axes, flat[1], flat[1] + 3.0 * normals[1][[0, 2]], style.BLUE, 1.8)
    style.label(axes, flat[1] + 3.0 * normals[1][[0, 2]], "$n_V$", (2, 8), style.BLUE)
    account = explained(program, tool, FOLD_NODE, "fold")
    p, x = FOLD_NODE[[0, 2]], account.vector("X")[[0, 2]]
    style.arrow(axes, p, x, style.INK, 1.6)
    style.dot(axes, p, style.INK, 7)
    style.label(axes, p, "$P$", (9, 4))
    style.dot(axes, x, style.INK, 6, filled=False)
    style.label(axes, x, "$Q$", (10, 4))
    style.label(axes, (-2.7, 0.5), "goes to the\nleft facet", size=8.5)
    style.label(axes, (2.9, 0.4), "goes to the\nright facet", size=8.5)
    axes.set_title("Seen from the side: the lifted corners\nleave no gap above a fold")
    style.bare(axes)
    axes.set(xlim=(-4.5, 4.5), ylim=(-2.4, 3.7))


def draw(program):
    drawn, left, right = style.figure(7.6, 3.4, 1, 1)
    space(left, program)
    side(right, program)
    return drawn
