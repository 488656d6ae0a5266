"""A warped quad with its centre, its four sub-triangles and its nodal normals; a triangle beside it."""

import numpy as np

from . import small_deck, style
from .program import Contradiction

QUAD = np.array([[0, 0, 0.3], [5, 0.4, 0.0], [5.3, 4.6, 1.9], [-0.3, 4.2, 0.2], [9, 0.2, -1.6], [9.4, 4.4, -0.9]])
QUADS = [(0, 1, 2, 3), (1, 4, 5, 2)]
TRIANGLE = np.array([[0, 0, 0.0], [4.6, 0.6, 0.4], [1.6, 4.2, 0.9], [6.0, 4.4, -0.9]])
TRIANGLES = [(0, 1, 2, 2), (1, 3, 2, 2)]


def centre_of(program):
    """Where the program puts A of the first quad, and the contact normal there."""
    start = QUAD[:4].mean(axis=0)
    blank = small_deck.grid([0, 1], [0, 1], lambda u, v: start + [u, v, 0])
    account = program.explain(
        small_deck.write(program.folder, "centre", (QUAD, QUADS), blank, gap=0.5), small_deck.FIRST_BLANK, 0
    )
    if np.abs(account.weights() - [1, 0, 0]).max() > 1e-9:
        raise Contradiction("a node at the mean of a quad's corners does not have the weights 1, 0, 0 there")
    return account.vector("X"), account.vector("nu")


def arrows(axes, view, points, normals, names, length, color=style.BLUE):
    for point, normal, (name, shift) in zip(points, normals, names):
        tip = point + length * normal
        style.arrow(axes, view(point), view(tip), color, 1.8)
        style.label(axes, view(tip), name, shift, color)


def draw(program):
    drawn, left, right = style.figure(7.6, 3.5, 1.75, 1)
    view = style.View(-70, 28)
    a, nu_a = centre_of(program)
    normals = small_deck.nodal_normals(program, (QUAD, QUADS))
    style.polygon(left, view(QUAD[list(QUADS[1])]), style.PALE, edge=style.GREY, over=1)
    shades = ("#CFE6F5", "#F7E3B5", "#CDEBDF", "#F3D9E6")
    for k in range(4):
        corners = np.array([a, QUAD[k], QUAD[(k + 1) % 4]])
        style.polygon(left, view(corners), shades[k], edge=style.INK, width=0.9, line=(0, (4, 2)))
        style.label(left, view(corners.mean(axis=0)), f"$k={k + 1}$", ((0, -2), (2, 2), (22, 0), (0, 0))[k])
    style.polygon(left, view(QUAD[:4]), None, width=1.6, over=3)
    arrows(
        left,
        view,
        QUAD[:4],
        normals[:4],
        [("$n_1$", (-8, 4)), ("$n_2$", (9, 3)), ("$n_3$", (9, 3)), ("$n_4$", (-8, 4))],
        2.0,
    )
    arrows(left, view, [a], [nu_a], [("$n_A$", (-9, 3))], 2.0, style.RED)
    for i, shift in enumerate([(-9, -7), (2, -11), (14, -3), (-11, -2)]):
        style.dot(left, view(QUAD[i]))
        style.label(left, view(QUAD[i]), f"$x_{i + 1}$", shift)
    style.dot(left, view(a), style.RED)
    style.label(left, view(a), "$A$", (9, -6), style.RED)
    style.label(left, view(QUAD[list(QUADS[1])].mean(axis=0)), "next\nsegment", color=style.GREY)
    left.set_title("A quad: four sub-triangles $(A, x_k, x_{k+1})$")

    normals = small_deck.nodal_normals(program, (TRIANGLE, TRIANGLES))
    style.polygon(right, view(TRIANGLE[list(TRIANGLES[1])[:3]]), style.PALE, edge=style.GREY, over=1)
    style.polygon(right, view(TRIANGLE[:3]), shades[0], width=1.6)
    style.label(right, view(TRIANGLE[:3].mean(axis=0)), "$k=1$")
    arrows(right, view, TRIANGLE[:3], normals[:3], [("$n_1$", (-8, 4)), ("$n_2$", (9, 3)), ("$n_3$", (-8, 4))], 2.0)
    for i, (name, shift) in enumerate([("$x_1 = B$", (-4, -11)), ("$x_2 = C$", (8, -11)), ("$x_3 = A$", (-26, -4))]):
        style.dot(right, view(TRIANGLE[i]))
        style.label(right, view(TRIANGLE[i]), name, shift)
    right.set_title("A triangle: one sub-triangle")
    for axes in (left, right):
        style.bare(axes)
        axes.margins(0.06)
    drawn.text(
        0.64,
        0.36,
        "$n_j$: the unit normals of the sub-triangles\nat corner $j$, added and normalised\n\n"
        "$n_A$: the mean of $n_1 ... n_4$, not normalised\n(drawn with unit length)",
        fontsize=8.5,
        va="top",
        linespacing=1.35,
    )
    return drawn
