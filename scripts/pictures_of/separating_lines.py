"""Separating lines in a vertical section: a node beyond one of them is not taken by the neighbour."""

import numpy as np

from . import dome, style

SECTION = 1.1  # y [mm]
U, V = np.linspace(-0.6, 6.2, 341), np.linspace(-2.0, 1.8, 191)
SHADES = (style.OWN, style.NEXT, style.BOTH)
GAP_AT = -0.05  # x of the dimensions of gap and DEPTH


def corners_of(points):
    """The corners of a region that is nearly a quadrilateral, from the upper left one on, counter-clockwise."""
    return [points[np.argmax(points @ way)] for way in ((-1, 1), (-1, -1), (1, -1), (1, 1))]


def lines(points):
    """Lines along the sides of the region, moved out so that no point lies beyond: start, direction, normal, bound."""
    corners = corners_of(points)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        along = (b - a) / np.linalg.norm(b - a)
        outward = np.array([along[1], -along[0]])
        yield a, along, outward, (points @ outward).max()


def surface(nodes, triangle):
    """Where the plane of the section cuts a triangle."""
    cut = []
    for i in range(3):
        a, b = nodes[triangle[i]], nodes[triangle[i - 1]]
        if (a[1] - SECTION) * (b[1] - SECTION) < 0:
            share = (SECTION - a[1]) / (b[1] - a[1])
            cut.append((a + share * (b - a))[[0, 2]])
    return np.array(cut)


def draw(program):
    scene = dome.Dome(program)
    points = np.array([(x, SECTION, z) for z in V for x in U])
    own, neighbour = (scene.decide(points, which=(one,)).contact for one in (dome.T, dome.E))
    which = np.where(own & neighbour, 2, np.where(own, 0, np.where(neighbour, 1, -1))).reshape(len(V), len(U))
    drawn, axes = style.figure(7.4, 4.4)
    style.field(axes, U, V, style.shaded(which, SHADES))
    for rank, name in ((dome.T, "facet of $T$"), (dome.E, "facet of $E$")):
        line = surface(scene.nodes, dome.TRIANGLES[rank])
        axes.plot(*line.T, color=style.INK, lw=2.4, zorder=4)
        style.label(axes, line.mean(axis=0), name, (0, -11), size=8.5)
    taken = points[neighbour][:, [0, 2]]
    for i, (start, along, outward, bound) in enumerate(lines(taken)):
        foot = start + (bound - start @ outward) * outward
        ends = [foot + t * along for t in (-9, 9)]
        facing = i == 0
        axes.plot(
            *np.transpose(ends),
            color=style.RED if facing else style.GREY,
            lw=2 if facing else 0.9,
            ls="-" if facing else (0, (4, 2)),
            zorder=5,
        )
        if facing:
            middle = foot + 1.95 * along
            style.arrow(axes, middle, middle + 0.6 * outward, style.RED, 1.6)
            style.label(axes, middle + 0.62 * outward, "not taken by $E$", (-48, 0), style.RED, 9)
            style.label(axes, foot - 0.3 * along, "separating line\nof $E$", (38, 4), style.RED, 9)
    style.label(axes, (1.9, 0.65), "$T$ takes the node", size=9)
    style.label(axes, (4.35, 0.45), "$E$ takes\nthe node", size=9)
    axes.annotate("both", (3.72, 0.75), (3.05, 1.45), fontsize=9, arrowprops={"arrowstyle": "-", "lw": 0.8})
    for at, name, up in ((GAP_AT, "gap $g$", dome.GAP), (GAP_AT, "DEPTH", -dome.DEPTH)):
        axes.annotate("", (at, 0), (at, up), arrowprops={"arrowstyle": "<->", "lw": 0.9, "shrinkA": 0, "shrinkB": 0})
        axes.text(at - 0.07, up / 2, name, ha="right", va="center", fontsize=9)
    axes.plot([], [], color=style.GREY, lw=0.9, ls=(0, (4, 2)), label="the other lines of $E$")
    axes.legend(loc="lower left")
    axes.set(
        aspect="equal",
        xlabel="x [mm]",
        ylabel="z [mm]",
        xlim=(U[0], U[-1]),
        ylim=(V[0], V[-1]),
        title=f"Section at y = {SECTION} mm",
    )
    return drawn
