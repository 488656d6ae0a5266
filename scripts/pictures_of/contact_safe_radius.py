"""Balls around nodes in which one sub-triangle takes the node as contact, on the same side, in a vertical section."""

import numpy as np

from . import dome, style
from .program import Contradiction

SECTION = 1.1  # y [mm]
U, V = np.linspace(-0.4, 4.6, 321), np.linspace(-1.45, 1.5, 189)
NODES = ((1.95, 0.64), (0.8, 0.6), (3.2, 0.55), (2.75, 0.12), (1.35, -0.5), (2.75, -0.72))  # x, z
SHADES = (style.OWN, style.NEXT)  # in front, behind


def limits(scene, middles, answers):
    """What ends each ball: a larger gap and DEPTH would make it larger, or the surface is as far, or a weight."""
    wider = scene.decide(middles, which=(dome.T,), gap=dome.GAP + 1, depth=dome.DEPTH + 1).margin
    for z, side, margin, other in zip(middles[:, 2], answers.side, answers.margin, wider):
        if other > margin * (1 + 1e-9):
            yield "gap $g$" if side > 0 else "DEPTH"
        else:
            yield "surface" if abs(abs(z) - margin) < 1e-9 else "a weight"


def draw(program):
    scene = dome.Dome(program)
    points = np.array([(x, SECTION, z) for z in V for x in U])
    found = scene.decide(points, which=(dome.T,))
    middles = np.array([(x, SECTION, z) for x, z in NODES])
    answers = scene.decide(middles, which=(dome.T,))
    drawn, axes = style.figure(7.4, 4.4)
    which = np.where(found.contact, np.where(found.side > 0, 0, 1), -1).reshape(len(V), len(U))
    style.field(axes, U, V, style.shaded(which, SHADES))
    axes.plot((U[0], U[-1]), (0, 0), color=style.INK, lw=2)
    for middle, radius, side, limit in zip(middles, answers.margin, answers.side, limits(scene, middles, answers)):
        inside = np.linalg.norm(points - middle, axis=1) < radius
        if not (found.contact & (found.side == side))[inside].all():
            raise Contradiction(f"the answer changes within the margin {radius} of the node at {middle}")
        at = middle[[0, 2]]
        axes.add_patch(style.plt.Circle(at, radius, fc="white", alpha=0.5, lw=0, zorder=5))
        axes.add_patch(style.plt.Circle(at, radius, fc="none", ec=style.BLUE, lw=1.8, zorder=6))
        style.dot(axes, at, style.BLUE, 4)
        low = radius < 0.2
        style.label(axes, at, limit, (-34, 3) if low else (0, -10), size=8.5)
    style.label(axes, (0.62, 1.07), "in front", size=9)
    style.label(axes, (0.9, -1.05), "behind", size=9)
    style.label(axes, (4.2, 0), "plane of $T$", (0, 9), size=9)
    axes.set(
        aspect="equal",
        xlabel="x [mm]",
        ylabel="z [mm]",
        xlim=(U[0], U[-1]),
        ylim=(V[0], V[-1]),
        title=f"Where $T$ takes a node as contact, section at y = {SECTION} mm;\nin each ball what ends it",
    )
    return drawn
