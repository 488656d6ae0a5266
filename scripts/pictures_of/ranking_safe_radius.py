"""Balls in which no other sub-triangle takes the node, seen from above; and the argument along one path."""

import numpy as np

from . import dome, style
from .program import Contradiction

HEIGHT = 0.6  # of the nodes over T [mm]
U, V = np.linspace(-1.2, 5.6, 273), np.linspace(-1.6, 4.4, 241)
NODES = np.array([(1.35, 1.05), (3.0, 0.85), (1.7, 2.6), (3.9, 2.2), (1.9, -0.75), (0.35, 2.2)])  # x, y
STUDIED = 1  # the node of the right half
PATH = np.linspace(0, 0.86, 35)  # its way [mm]
DIRECTION = np.array([0.998, 0.06, 0])
LOWEST = -0.01  # a sub-triangle with a smaller weight does not take the node
APART = 0.01  # of the nodes between which the slope of a weight is measured [mm]


def weights(account):
    """The three weights of step 2 of every sub-triangle that is near; explain prints those that reject, too."""
    return {
        place: np.array([1 - one["b'"] - one["c'"], one["b'"], one["c'"]])
        for place, one in account.sub_triangles.items()
        if "b'" in one
    }


def ranges(scene, node):
    """For each other sub-triangle that is near: its least weight there, and how fast that changes in any direction."""
    around = [node, *(node + APART * way for way in np.eye(3)), *(node - APART * way for way in np.eye(3))]
    at, *moved = [weights(account) for account in scene.explain(around)]
    for place, here in at.items():
        least = int(here.argmin())
        if here[least] < LOWEST and all(place in one for one in moved):
            slope = [(moved[i][place][least] - moved[i + 3][place][least]) / (2 * APART) for i in range(3)]
            yield place, here[least], np.linalg.norm(slope)


def from_above(axes, scene):
    points = dome.level(U, V, HEIGHT)
    found = scene.decide(points)
    retained = np.where(found.contact, found.segment, -1)
    shades = [style.NEXT] * len(dome.TRIANGLES)
    shades[dome.T] = style.OWN
    style.field(axes, U, V, style.shaded(retained.reshape(len(V), len(U)), shades))
    for own in range(len(dome.TRIANGLES)):
        style.outline(axes, U, V, retained.reshape(len(V), len(U)) == own, 0.03, width=0.8)
    middles = np.column_stack([NODES, np.full(len(NODES), HEIGHT)])
    owners = scene.decide(middles).segment
    for i, (middle, own) in enumerate(zip(middles, owners)):
        radius = min((LOWEST - least) / slope for place, least, slope in ranges(scene, middle) if place[0] != own + 1)
        inside = np.linalg.norm(points - middle, axis=1) < radius
        if not (retained[inside] == own).all():
            raise Contradiction(f"another sub-triangle is retained within {radius} mm of the node at {middle}")
        axes.add_patch(style.plt.Circle(middle[:2], radius, fc="white", alpha=0.5, lw=0, zorder=5))
        axes.add_patch(style.plt.Circle(middle[:2], radius, fc="none", ec=style.BLUE, lw=1.8, zorder=6))
        style.dot(axes, middle[:2], style.BLUE, 4)
    start, end = middles[STUDIED], middles[STUDIED] + PATH[-1] * DIRECTION
    style.arrow(axes, start[:2], end[:2], style.INK, 1.2, 9, over=8)
    style.label(axes, start[:2], "$P$", (-9, 0))
    style.label(axes, (2.25, 1.75), "$T$", size=12)
    style.label(axes, (4.5, 1.4), "$E$", size=12)
    axes.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", title=f"From above, {HEIGHT} mm over $T$")


def along_path(axes, scene):
    """The least weight of E on the way from P, the steepest line that it could follow, and where decisions change."""
    start = np.array([*NODES[STUDIED], HEIGHT])
    way = start + PATH[:, None] * DIRECTION
    e = (dome.E + 1, 1)
    least = np.array([weights(account)[e].min() for account in scene.explain(way)])
    _, _, slope = next(one for one in ranges(scene, start) if one[0] == e)
    radius = (LOWEST - least[0]) / slope
    fine = start + np.linspace(0, PATH[-1], 2001)[:, None] * DIRECTION
    s = np.linspace(0, PATH[-1], 2001)
    takes, retained = (
        s[scene.decide(fine, but=(dome.T,)).contact.argmax()],
        s[(scene.decide(fine).segment != dome.T).argmax()],
    )
    axes.axhline(LOWEST, color=style.INK, lw=0.8)
    axes.plot(PATH, least, color=style.GREEN, lw=2, label="least weight of $E$")
    axes.plot(
        [0, radius], [least[0], LOWEST], color=style.RED, lw=1.6, ls=(0, (5, 2)), label="its steepest rise from $P$"
    )
    axes.axvspan(0, radius, color=style.BLUE, alpha=0.12, lw=0)
    axes.axvline(radius, color=style.BLUE, lw=1.8)
    for at, name in ((takes, "$E$ begins to take the node"), (retained, "$E$ is retained")):
        axes.axvline(at, color=style.INK, lw=0.8, ls=":")
        axes.text(at - 0.006, -0.035, name, rotation=90, ha="right", va="top", fontsize=8.5)
    axes.text(
        radius - 0.012, -0.035, "ranking-safe radius", rotation=90, ha="right", va="top", fontsize=8.5, color=style.BLUE
    )
    axes.text(0.01, LOWEST + 0.002, "limit of the weights, $-0.01$", fontsize=8.5, va="bottom")
    axes.set(
        xlabel="way of the node from $P$ [mm]",
        ylabel="weight [-]",
        title="Why the ball holds",
        xlim=(0, PATH[-1] + 0.02),
        ylim=(-0.2, 0.02),
    )
    axes.legend(loc="upper left", bbox_to_anchor=(0.0, 0.86))


def draw(program):
    scene = dome.Dome(program)
    drawn, left, right = style.figure(7.8, 3.9, 1, 1)
    from_above(left, scene)
    along_path(right, scene)
    return drawn
