"""Contact normals along a strip over two folds: they turn continuously, facet normals jump."""

import numpy as np

from . import small_deck, style

# Facets of the strip: length [mm] and slope [degrees]. The first fold is convex, the two after it are concave.
FACETS = [(4.0, 0.0), (4.0, 0.0), (5.0, -50.0), (4.5, -15.0), (4.0, 0.0)]
WIDTH = 4.0
STEPS = 24  # nodes on each facet


def strip():
    profile = [np.zeros(2)]
    for length, slope in FACETS:
        profile.append(profile[-1] + length * np.array([np.cos(np.radians(slope)), np.sin(np.radians(slope))]))
    profile = np.round(profile, 9)
    m = len(profile)
    nodes = np.array([[x, y, z] for y in (-WIDTH / 2, WIDTH / 2) for x, z in profile])
    return profile, (nodes, [(i, i + 1, m + i + 1, m + i) for i in range(m - 1)])


def along(profile):
    """Places on the surface, all facets in turn: path length and point in the plane of the picture."""
    lengths = np.concatenate([[0], np.cumsum([length for length, _ in FACETS])])
    s = np.unique(np.concatenate([np.linspace(lengths[i], lengths[i + 1], STEPS + 1) for i in range(len(FACETS))]))
    return lengths, s, np.column_stack([np.interp(s, lengths, profile[:, i]) for i in (0, 1)])


def draw(program):
    profile, tool = strip()
    lengths, s, points = along(profile)
    blank = small_deck.grid(range(len(s)), (0.02, 0.1), lambda i, y: (points[i][0], y, points[i][1]))
    found = program.contact_at_time_zero(small_deck.write(program.folder, "strip", tool, blank, gap=0.5))
    rank = found["NODE_ID"] - small_deck.FIRST_BLANK
    order = np.argsort(rank)
    normals = found["normal"][order][: len(s)]

    drawn, top = style.figure(7.2, 4.6)
    drawn.clear()
    top, below = drawn.subplots(2, 1, height_ratios=(1.25, 1))
    top.fill_between(profile[:, 0], profile[:, 1], profile[:, 1].min() - 0.9, color=style.PALE, lw=0)
    top.plot(*profile.T, color=style.INK, lw=2)
    for i in range(0, len(s), 3):
        style.arrow(top, points[i], points[i] + 1.7 * normals[i][[0, 2]], style.BLUE, 1.0, 7)
    for i, (length, slope) in enumerate(FACETS):
        middle = (profile[i] + profile[i + 1]) / 2
        tip = middle + 2.7 * np.array([-np.sin(np.radians(slope)), np.cos(np.radians(slope))])
        style.arrow(top, middle, tip, style.ORANGE, 2.0, 10, line=(0, (4, 2)))
    for i in range(len(profile)):
        style.dot(top, profile[i], size=4)
    style.label(top, profile[2], "convex\nfold", (-20, -18), size=8.5)
    style.label(top, profile[3], "concave\nfold", (-24, -14), size=8.5)
    style.bare(top)

    angle = np.degrees(np.arctan2(normals[:, 0], normals[:, 2]))
    below.plot(s, angle, color=style.BLUE, lw=2, label="interpolated normal $\\nu$ (contact)")
    below.step(
        lengths,
        [-FACETS[0][1], *(-slope for _, slope in FACETS)],
        where="pre",
        color=style.ORANGE,
        lw=1.8,
        ls=(0, (4, 2)),
        label="normal of the facet",
    )
    for x in lengths[1:-1]:
        below.axvline(x, color=style.GREY, lw=0.6, ls=":")
    below.set(xlabel="path along the surface [mm]", ylabel="angle to the vertical [deg]", xlim=(0, lengths[-1]))
    below.legend(loc="upper left", borderaxespad=0)
    return drawn
