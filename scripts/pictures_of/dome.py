"""The scene of the pictures about the search: a sub-triangle T in the middle of a convex patch of triangles."""

import numpy as np

from . import small_deck

RADIUS = 7.0  # of the sphere on which the patch lies, nearly [mm]
GAP, DEPTH = 1.2, 1.2
PLAN = np.array(
    [[0, 0], [4.2, 0.2], [1.8, 3.7], [2.3, -3.4], [6.3, 3.5], [-2.4, 3.3], [-2.3, -3.0], [6.4, -3.2], [3.9, 7.0]]
)
TRIANGLES = [
    (0, 1, 2),
    (1, 0, 3),
    (2, 1, 4),
    (0, 2, 5),
    (3, 0, 6),
    (0, 5, 6),
    (1, 3, 7),
    (4, 1, 7),
    (2, 4, 8),
    (5, 2, 8),
]
T, E = 0, 2  # E lies over the side of T that joins nodes 1 and 2
SIDE = (1, 2)
MIDDLE = PLAN[:3].mean(axis=0)


def nodes():
    """T is level, at z = 0."""
    z = -((PLAN - MIDDLE) ** 2).sum(axis=1) / (2 * RADIUS)
    z -= z[:3].mean()
    z[:3] = 0
    return np.column_stack([PLAN, z.round(6)])


class Dome:
    def __init__(self, program):
        self.program, self.nodes = program, nodes()
        self.segments = [(a, b, c, c) for a, b, c in TRIANGLES]
        self.normals = small_deck.nodal_normals(program, (self.nodes, self.segments))

    def decide(self, points, which=None, but=(), gap=GAP, depth=DEPTH):
        """Answers of these sub-triangles alone (all without a choice), without those of `but`."""
        chosen = [s for i, s in enumerate(self.segments) if (which is None or i in which) and i not in but]
        return self.program.decide((self.nodes, self.normals, chosen), points, gap, depth)

    def explain(self, points):
        return small_deck.explain_points(self.program, (self.nodes, self.segments), points, GAP, DEPTH)

    def lifted(self, height):
        """The corners of T lifted to a height over it, from what explain prints of a node there."""
        one = self.explain([(*MIDDLE, height)])[0].sub_triangles[T + 1, 1]
        slopes = np.array(one["<n_V,N>"])[[1, 2, 0]]
        return self.nodes[:3] + self.normals[:3] * (one["H"] / slopes)[:, None]

    def plan(self, axes, color, width=0.9, line="-", over=4):
        for a, b, c in TRIANGLES:
            axes.plot(*self.nodes[[a, b, c, a], :2].T, color=color, lw=width, ls=line, zorder=over)


HEIGHTS = (-1.19, -0.6, 0.05, 0.6, 1.19)  # of nodes over T, from -DEPTH to the gap


def rim(weights):
    """Weights of points along the three sides of a triangle: one of them takes these values."""
    end = np.linspace(0, 0.06, 25)
    along = np.unique(np.concatenate([end, np.linspace(0, 1, 41), 1 - end]))
    ones = [np.insert([(1 - w) * s, (1 - w) * (1 - s)], side, w) for side in range(3) for w in weights for s in along]
    return np.array(ones)


def drawn_in(corners, weights):
    """The triangle of all points whose weights are at least these, one for each corner."""
    least = np.asarray(weights, float)
    room = 1 - least.sum()
    return np.array([(least + room * np.eye(3)[i]) @ corners for i in range(3)])


def level(u, v, height):
    return np.array([(x, y, height) for y in v for x in u])
