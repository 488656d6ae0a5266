"""The penetration offset P0 over the cycles of three shipped cases: a first impact, Inacti 5 and Inacti 6."""

import numpy as np

from . import style
from .program import ProgramFailed

# Title, case, node, first and last cycle, cycles between two that are asked for.
RUNS = [
    ("First impact\nat $t > 0$", "impact_relax", 1009, 0, 14, 1),
    ("Inacti 5:\nin contact at time 0", "inacti_5", 1006, 0, 220, 4),
    ("Inacti 6:\nin contact at time 0", "inacti_6", 1006, 0, 220, 4),
]


def histories(program, case, node, first, last, every):
    """cycle, p_g, P0, p of the node in the cycles when it is in contact."""
    deck = program.cases / case / f"{case}_0000.rad"
    step = program.explain(deck, node, 1e-5).step
    accounts = program.explain_all([(deck, node, cycle * step) for cycle in range(first, last + 1, every)])
    touched = [one for one in accounts if one.has("P0")]
    if len(touched) < 5:
        raise ProgramFailed(
            f"node {node} of case {case} is hardly in contact; choose another node in offset_relaxation.py"
        )
    return [
        np.array([one.cycle for one in touched]),
        *(np.array([one.number(symbol) for one in touched]) for symbol in ("p_g", "P0", "p")),
    ]


def draw(program):
    drawn, *panels = style.figure(7.6, 3.2, 0.8, 1, 1)
    for axes, (title, *asked) in zip(panels, RUNS):
        cycle, p_g, offset, p = histories(program, *asked)
        mark = {"marker": "o", "ms": 3.5} if asked[-1] == 1 else {}
        axes.fill_between(cycle, offset, np.maximum(p_g, offset), color=style.BLUE, alpha=0.18, lw=0)
        axes.plot(cycle, p_g, color=style.INK, lw=1.8, label="$p_g$  penetration", **mark)
        axes.plot(cycle, offset, color=style.RED, lw=1.8, ls=(0, (5, 2)), label="$P_0$  offset", **mark)
        axes.plot(
            cycle, p, color=style.BLUE, lw=1.8, ls=(0, (1.2, 1.2)), label="$p = \\max(0, p_g - P_0)$  pushes", **mark
        )
        axes.set(title=title, xlabel="cycle", xlim=(asked[2], asked[3]), ylim=(0, None))
    panels[0].set_ylabel("length [mm]")
    style.legend_below(drawn, panels[1], 3)
    return drawn
