"""Near a side only the sub-triangle T and its neighbour E over that side can take a node, away from the corners."""

import numpy as np

from . import dome, style

HEIGHT = 0.6  # of the nodes that are drawn, over T [mm]
U, V = np.linspace(0.9, 5.5, 185), np.linspace(-0.7, 4.3, 201)
ZOOM_U, ZOOM_V = np.linspace(3.9, 4.5, 121), np.linspace(0.0, 0.6, 121)
SHADES = (style.OWN, style.BOTH, style.NEXT, style.THIRD, style.OTHERS)
NAMES = ("$T$ alone", "$T$ and $E$", "$E$ alone", "$T$ and a third", "others")
LOWEST = -0.01  # weight that a sub-triangle takes


def takers(scene, points, shape=-1):
    """Ranks of SHADES; -1 where nobody takes the node."""
    t, e, other = (
        scene.decide(points, **who).contact
        for who in ({"which": (dome.T,)}, {"which": (dome.E,)}, {"but": (dome.T, dome.E)})
    )
    which = np.full(len(points), -1)
    which[other | e] = 4
    which[e & ~t & ~other] = 2
    which[t & ~other] = 0
    which[t & e & ~other] = 1
    which[t & other] = 3
    return which.reshape(shape)


def least_pair_weight(scene):
    """The smallest m2: no point asked that T takes with both weights of the side above m2 is taken by a third."""
    weights = dome.rim(np.linspace(-0.01, 0.06, 36))
    least = 0.0
    for height in dome.HEIGHTS:
        third = takers(scene, weights @ scene.lifted(height)) == 3
        least = max(least, weights[third][:, dome.SIDE].min(axis=1).max(initial=0))
    return least


def zone(corners, m2):
    """Both weights of the side at least m2, the third one as far down as T takes a node."""
    least = np.full(3, m2)
    least[[i for i in range(3) if i not in dome.SIDE]] = LOWEST
    return dome.drawn_in(corners, least)[:, :2]


def draw(program):
    scene = dome.Dome(program)
    m2 = least_pair_weight(scene)
    corners = scene.lifted(HEIGHT)
    outline = zone(corners, m2)
    drawn, left, right = style.figure(7.8, 4.0, 1, 1.05)
    for axes, u, v in ((left, U, V), (right, ZOOM_U, ZOOM_V)):
        points = dome.level(u, v, HEIGHT)
        style.field(axes, u, v, style.shaded(takers(scene, points, (len(v), len(u))), SHADES))
        style.polygon(axes, outline, None, edge=style.BLUE, width=2.2, over=6)
        axes.set(xlabel="x [mm]", aspect="equal", xlim=(u[0], u[-1]), ylim=(v[0], v[-1]))
    style.polygon(left, [(ZOOM_U[i], ZOOM_V[j]) for i, j in ((0, 0), (-1, 0), (-1, -1), (0, -1))], None, width=1)
    style.label(left, corners[:, :2].mean(axis=0), "$T$", size=13)
    style.label(left, (4.15, 2.5), "$E$", size=13)
    left.set(ylabel="y [mm]", title=f"From above, {HEIGHT} mm over $T$")
    right.set(title="The corner in the box")
    style.label(right, (4.36, 0.47), f"both weights\nof the side\nat least {m2:.3f}", color=style.BLUE, size=8.5)
    retained = scene.decide(dome.level(ZOOM_U, ZOOM_V, HEIGHT))
    which = np.where(retained.contact, retained.segment, -1).reshape(len(ZOOM_V), len(ZOOM_U))
    style.outline(right, ZOOM_U, ZOOM_V, which == dome.T, 0.004, color="white", width=1.6, line=(0, (1.5, 1.2)), over=7)
    style.label(right, (3.985, 0.3), "$T$ is\nretained", size=8.5)
    style.label(right, (4.4, 0.31), "$E$ is\nretained", size=8.5)
    for shade, name in zip(SHADES, NAMES):
        left.fill([], [], color=shade, label=name)
    left.plot([], [], color=style.BLUE, lw=2.2, label="zone of $T$ and $E$")
    style.legend_below(drawn, left, 3, 0.14)
    return drawn
