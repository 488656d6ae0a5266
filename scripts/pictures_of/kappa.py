"""kappa of the retained impact over two quads, seen from above, and where the retained sub-triangle changes."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm
from matplotlib.tri import LinearTriInterpolator, Triangulation

from . import small_deck, style

# Two plane quads; the right one falls away from the shared edge.
NODES = np.array([[0, 0, 0.0], [4, 0.3, 0], [7.6, -0.4, -0.695], [-0.3, 3.6, 0], [3.5, 4.0, 0], [7.9, 3.5, -0.859]])
QUADS = [(0, 1, 4, 3), (1, 2, 5, 4)]
HEIGHT = 0.8  # of the plane of the nodes [mm]
GAP, DEPTH = 2.0, 2.0
U, V = np.linspace(-0.6, 8.3, 357), np.linspace(-0.7, 4.3, 201)  # of `decide`
EVERY = 7  # explain is asked for kappa on each seventh of these lines, and on the rims


def places(retained, one):
    """Rows and columns of U, V where explain is asked about a sub-triangle: a coarse grid, and its rim."""
    inside = retained == one
    inner = inside.copy()
    inner[1:-1, 1:-1] &= inside[2:, 1:-1] & inside[:-2, 1:-1] & inside[1:-1, 2:] & inside[1:-1, :-2]
    y, x = np.nonzero(inside & ~inner)
    rim = np.column_stack([y, x])[::3]
    y, x = np.nonzero(inner)
    keep = (y % EVERY == 0) & (x % EVERY == 0)
    return np.concatenate([np.column_stack([y, x])[keep], rim])


def draw(program):
    tool = (NODES, QUADS)
    normals = small_deck.nodal_normals(program, tool)
    answers = program.decide((NODES, normals, QUADS), [(x, y, HEIGHT) for y in V for x in U], GAP, DEPTH)
    retained = np.where(answers.contact, 4 * answers.segment + answers.triangle, 0).reshape(len(V), len(U))
    drawn, axes = style.figure(7.2, 4)
    kappa = np.full(retained.shape, np.nan)
    for one in range(1, 9):
        at = places(retained, one)
        x, y = U[at[:, 1]], V[at[:, 0]]
        accounts = small_deck.explain_points(
            program, tool, np.column_stack([x, y, np.full(len(x), HEIGHT)]), GAP, DEPTH
        )
        values = [account.sub_triangles[account.retained()]["kappa"] for account in accounts]
        region = retained == one
        between = LinearTriInterpolator(Triangulation(x, y), values)
        kappa[region] = between(*np.meshgrid(U, V))[region].filled(np.nan)
        for row, column in np.argwhere(
            region & np.isnan(kappa)
        ):  # a rim that the triangles between the places leave out
            kappa[row, column] = values[np.argmin((x - U[column]) ** 2 + (y - V[row]) ** 2)]
        style.outline(axes, U, V, region, 0.03)
        style.label(axes, (x.mean(), y.mean()), f"$k={(one - 1) % 4 + 1}$", size=8.5)
    norm = BoundaryNorm(np.arange(0, 1.41, 0.2), 256)
    style.field(axes, U, V, matplotlib.colormaps["cividis_r"](norm(np.ma.masked_invalid(kappa))))
    for quad in QUADS:
        corners = NODES[list(quad)][:, :2]
        for corner in corners:
            axes.plot(
                *np.transpose([corner, corners.mean(axis=0)]), color=style.RED, lw=1.0, ls=(0, (1.5, 2)), zorder=4
            )
    axes.annotate(
        "two sub-triangles overlap by 1 %:\nboth take the node, $\\kappa$ selects one",
        (7.62, 3.18),
        (5.2, 4.3),
        fontsize=8,
        arrowprops={"arrowstyle": "-", "lw": 0.8, "shrinkA": 0},
    )
    for i, j in sorted({tuple(sorted((quad[k], quad[k - 1]))) for quad in QUADS for k in range(4)}):
        axes.plot(*NODES[[i, j], :2].T, color=style.RED, lw=1.2, ls=(0, (4, 2)), zorder=4)
    for at, name in (((2.0, -0.45), "segment 1"), ((5.8, -0.6), "segment 2")):
        style.label(axes, at, name, color=style.RED)
    axes.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", xlim=(-0.7, 8.4), ylim=(-0.9, 4.7))
    bar = drawn.colorbar(ScalarMappable(norm, "cividis_r"), ax=axes, shrink=0.75, pad=0.02)
    bar.set_label("$\\kappa$ of the retained impact")
    bar.outline.set_visible(False)
    axes.plot([], [], color=style.INK, lw=1.6, label="another sub-triangle is retained")
    axes.plot([], [], color=style.RED, lw=1.2, ls=(0, (4, 2)), label="edges of the segments below")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.14), ncols=2)
    return drawn
