"""Normal force against penetration with Igap 2 and Pmax: a shipped case, with its thickening and without."""

import numpy as np

from . import style

CASE, NODE = "pmax_plateau", 1
STEP, LAST, EVERY = 1e-6, 1400, 10


def curve(program, thickness):
    """p and F of the node in the cycles when it is in contact, and the last account."""
    deck = program.cases / CASE / f"{CASE}_0000.rad"
    accounts = program.explain_all([(deck, NODE, cycle * STEP, thickness) for cycle in range(0, LAST + 1, EVERY)])
    touched = [one for one in accounts if one.has("P0")]
    return (np.array([one.number("p") for one in touched]), np.array([one.number("F") for one in touched]), touched[-1])


def draw(program):
    p, force, last = curve(program, program.cases / CASE / "thickness.csv")
    p_plain, force_plain, _ = curve(program, None)
    growth, limit = last.number("Delta"), last.number("P_A")
    drawn, axes = style.figure(6.4, 3.8)
    axes.plot(p_plain, force_plain, color=style.GREY, lw=1.5, ls=(0, (5, 2)), label="thickness constant: $F = k\\,p$")
    axes.plot(p, force, "o-", color=style.BLUE, lw=1.8, ms=2.5, label="thickness grown: the plateau")
    axes.axvline(growth, color=style.INK, lw=0.7, ls=":")
    axes.axhline(limit, color=style.INK, lw=0.7, ls=":")
    axes.set(xlabel="penetration $p$ [mm]", ylabel="elastic force $F$ [N]", xlim=(0, p.max() * 1.03), ylim=(0, 68))
    style.label(axes, (growth, 65), f"$\\Delta = g - g_0 = {growth:.3g}$ mm", (5, 0), ha="left")
    style.label(axes, (p.max(), limit), f"$A\\,P_{{max}} = {limit:.3g}$ N", (0, -8), ha="right")
    for at, other in ((p, force), (p_plain, force_plain)):
        style.label(axes, (np.interp(40, other, at), 40), "slope $k$", (22, -4), style.INK, 8.5)
    axes.legend(loc="upper left")
    return drawn
