"""Where a sub-triangle has a node to itself: all of it from above, and one of its corners larger."""

import numpy as np

from . import dome, style

HEIGHT = 0.6  # of the nodes that are drawn, over T [mm]
U, V = np.linspace(-0.7, 4.9, 225), np.linspace(-0.7, 4.3, 201)
ZOOM_U, ZOOM_V = np.linspace(3.72, 4.42, 141), np.linspace(0.0, 0.6, 121)
SHADES = (style.OWN, style.BOTH, style.OTHERS)  # T alone, T and others, others alone


def takers(scene, points, shape=-1):
    """0 where T alone takes a node, 1 where others do too, 2 where only others do, -1 where nobody does."""
    own, others = scene.decide(points, which=(dome.T,)).contact, scene.decide(points, but=(dome.T,)).contact
    return np.where(own, np.where(others, 1, 0), np.where(others, 2, -1)).reshape(shape)


def least_weight(scene):
    """The smallest weight m such that no point asked that T takes with all weights above m is taken by another."""
    weights = dome.rim(np.linspace(-0.01, 0.06, 36))
    shared = [takers(scene, weights @ scene.lifted(height)) == 1 for height in dome.HEIGHTS]
    return max(weights[both].min(axis=1).max(initial=0) for both in shared)


def draw(program):
    scene = dome.Dome(program)
    m = least_weight(scene)
    corners = scene.lifted(HEIGHT)
    region = dome.drawn_in(corners, (m, m, m))[:, :2]
    drawn, left, right = style.figure(7.8, 3.7, 1.05, 1)
    for axes, u, v in ((left, U, V), (right, ZOOM_U, ZOOM_V)):
        which = takers(scene, dome.level(u, v, HEIGHT), (len(v), len(u)))
        style.field(axes, u, v, style.shaded(which, SHADES))
        style.polygon(axes, region, None, edge=style.BLUE, width=2.2, over=6)
        style.polygon(axes, corners[:, :2], None, edge=style.INK, width=1, line=(0, (4, 2)), over=5)
        axes.set(xlabel="x [mm]", aspect="equal", xlim=(u[0], u[-1]), ylim=(v[0], v[-1]))
    style.polygon(left, [(ZOOM_U[i], ZOOM_V[j]) for i, j in ((0, 0), (-1, 0), (-1, -1), (0, -1))], None, width=1)
    style.label(left, region.mean(axis=0), "exclusive region\nof $T$", color=style.BLUE)
    left.set(ylabel="y [mm]", title=f"From above, {HEIGHT} mm over $T$")
    right.set(title="The corner in the box")
    style.label(right, region[1], f"all three weights\nat least {m:.3f}", (-70, 30), style.BLUE, 8.5)
    for shade, name in zip(SHADES, ("$T$ alone takes the node", "$T$ and another", "another only")):
        left.fill([], [], color=shade, label=name)
    left.plot([], [], color=style.INK, lw=1, ls=(0, (4, 2)), label="lifted $T$")
    style.legend_below(drawn, left, 4, 0.08)
    return drawn
