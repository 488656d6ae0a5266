"""Trial force and its return to the Coulomb circle, cycle by cycle, under a flat tool that changes its direction."""

import numpy as np

from . import small_deck, style

TOOL = (np.array([[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]], float), [(0, 1, 2, 3)])
NODE = np.array([1.0, 2.0, 0.3])
GAP, FRIC, STEP = 0.5, 0.1, 1e-6
TURN, CYCLES = 12, 34
# Velocity of the tool [mm/s]; it turns between two cycles.
VELOCITY = {
    "X": [(0, -3800), (TURN * STEP, -3800), (TURN * STEP + 1e-9, 2400), (1, 2400)],
    "Y": [(0, 500), (TURN * STEP, 500), (TURN * STEP + 1e-9, -2900), (1, -2900)],
}
ZOOM = 22  # the cycle that is drawn large


def circle(axes, radius):
    turn = np.linspace(0, 2 * np.pi, 361)
    axes.fill(radius * np.cos(turn), radius * np.sin(turn), color=style.PALE, alpha=0.6, lw=0, zorder=0)
    axes.plot(radius * np.cos(turn), radius * np.sin(turn), color=style.INK, lw=1.4, zorder=2)


def plane(vector):
    """The tool is flat, its normal z; in kN."""
    return vector[:2] / 1000


def path(axes, accounts):
    circle(axes, accounts[-1].number("mu|F_n|") / 1000)
    axes.axhline(0, color=style.GREY, lw=0.5)
    axes.axvline(0, color=style.GREY, lw=0.5)
    trial, force = (np.array([plane(one.vector(symbol)) for one in accounts]) for symbol in ("T", "F_t"))
    slips = np.array([one.number("|T|") > one.number("mu|F_n|") for one in accounts])
    axes.plot(*np.vstack([[0, 0], force]).T, color=style.BLUE, lw=1, zorder=3)
    for a, b in zip(trial[slips], force[slips]):
        axes.plot(*np.transpose([a, b]), color=style.RED, lw=0.9, zorder=3)
    axes.plot(*trial[slips].T, "x", color=style.RED, ms=5, mew=1.3, zorder=4, label="trial force $T$ beyond the circle")
    axes.plot(*force[slips].T, "o", color=style.BLUE, ms=5, zorder=5, label="$F_t$ when the node slips")
    axes.plot(*force[~slips].T, "o", mfc="white", mec=style.BLUE, ms=5, zorder=5, label="$F_t = T$ when it sticks")
    style.label(axes, force[TURN - 2], "the tool changes\nits direction", (-42, -22), size=8.5)
    axes.annotate(
        "",
        force[TURN - 2],
        xytext=(-20, -13),
        textcoords="offset points",
        zorder=6,
        arrowprops={"arrowstyle": "-", "lw": 0.8, "shrinkB": 3},
    )
    axes.set(
        title="All cycles", xlabel="$x$ [kN]", ylabel="$y$ [kN]", aspect="equal", xlim=(-4.6, 5.4), ylim=(-4.6, 5.4)
    )


def one_cycle(axes, one):
    limit = one.number("mu|F_n|") / 1000
    circle(axes, limit)
    old, trial, force = (plane(one.vector(symbol)) for symbol in ("F_t old", "T", "F_t"))
    axes.plot(*np.transpose([(0, 0), old]), color=style.GREY, lw=1.6)
    axes.plot(*np.transpose([(0, 0), force]), color=style.BLUE, lw=2.2)
    style.arrow(axes, old, trial, style.INK, 1.6)
    style.arrow(axes, trial, force, style.RED, 1.6)
    for at in (old, force):
        style.dot(axes, at, style.BLUE)
    axes.plot(*trial, "x", color=style.RED, ms=7, mew=1.8, zorder=6)
    style.label(axes, old, "$F_{t,old}$", (14, -10), style.GREY)
    style.label(axes, trial, "$T = F_{t,old} + k\\,v\\,\\Delta t_1$", (6, 11))
    style.label(axes, force, "$F_t = T\\,\\mu F_n\\,/\\,|T|$", (-50, 12), style.BLUE)
    around = (old + trial + force) / 3
    axes.set(
        title=f"Cycle {one.cycle}",
        xlabel="$x$ [kN]",
        aspect="equal",
        xlim=around[0] + np.array([-1.05, 1.05]),
        ylim=around[1] + np.array([-1.05, 0.95]),
    )
    at = limit * np.array([np.cos(1.52), np.sin(1.52)])
    style.label(axes, (-0.62, 3.55), "to the centre", (-34, 0), size=8.5)
    style.label(axes, at, "circle of\nradius $\\mu F_n$", (-4, -34), size=8.5)


def draw(program):
    blank = small_deck.grid([0, 1], [0, 1], lambda u, v: NODE + [u, v, 0])
    deck = small_deck.write(
        program.folder, "friction", TOOL, blank, GAP, fric=FRIC, velocity=VELOCITY, step=STEP, cycles=CYCLES
    )
    accounts = program.explain_all([(deck, small_deck.FIRST_BLANK, cycle * STEP) for cycle in range(1, CYCLES)])
    drawn, left, right = style.figure(7.6, 4.0, 1.15, 1)
    path(left, accounts)
    style.legend_below(drawn, left, 3, 0.07)
    one_cycle(right, next(one for one in accounts if one.cycle == ZOOM))
    return drawn
