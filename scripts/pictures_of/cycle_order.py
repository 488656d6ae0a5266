"""The order of a cycle on the axis of time, with the numbers of a node that slides to rest in a shipped case."""

import numpy as np

from . import style
from .program import Contradiction

CASE, NODE, TIME = "sliding_to_rest", 1, 1e-3
PREVIOUS, HALF_BEFORE, NOW, HALF_AFTER, NEXT = range(5)


def accounts(program):
    """Of the cycle and the next one; what they print must follow from each other by the order that is drawn."""
    deck = program.cases / CASE / f"{CASE}_0000.rad"
    now = program.explain(deck, NODE, TIME)
    after = program.explain(deck, NODE, now.time + now.step)
    moved = after.vector("x") - now.vector("x")
    if np.abs(moved - after.vector("v") * after.step).max() > 1e-9 * np.abs(after.vector("x")).max():
        raise Contradiction(f"{CASE}: x of cycle {after.cycle} is not x of cycle {now.cycle} + v dt")
    return now, after


def box(axes, at, text, color, width=1.5, height=0.62):
    corners = [
        (at[0] - width / 2, at[1] - height / 2),
        (at[0] + width / 2, at[1] - height / 2),
        (at[0] + width / 2, at[1] + height / 2),
        (at[0] - width / 2, at[1] + height / 2),
    ]
    style.polygon(axes, corners, "white", over=1)
    style.polygon(axes, corners, color, 0.22, color, 1.2)
    axes.text(*at, text, ha="center", va="center", fontsize=8.8, zorder=8)


def draw(program):
    now, after = accounts(program)
    n, unit = now.cycle, 1e6
    drawn, axes = style.figure(7.6, 4.7)
    levels = {"state": 6.0, "contact": 4.9, "elements": 4.0, "acceleration": 3.1, "velocity": 2.1, "position": 1.1}
    times = [now.time - now.step, now.time - now.step / 2, now.time, now.time + after.step / 2, after.time]
    names = ["$t_{n-1}$", "$t_{n-1/2}$", "$t_n$", "$t_{n+1/2}$", "$t_{n+1}$"]
    for i, (time, name) in enumerate(zip(times, names)):
        axes.plot([i, i], [0.35, 6.6], color=style.GREY, lw=0.6, ls=":" if i % 2 else "-", zorder=0)
        axes.text(i, 0.0, f"{name}\n{time * unit:.6g} µs", ha="center", va="center", fontsize=9)
    style.arrow(axes, (-0.3, 0.35), (4.45, 0.35), style.INK, 1.0, 9)

    x, v = now.vector("x")[0], now.vector("v")[0]
    x_next, v_next = after.vector("x")[0], after.vector("v")[0]
    force = "(" + ", ".join(f"{component:.3g}" for component in now.vector("F").round(9) + 0.0) + ")"
    style.dot(axes, (HALF_BEFORE, levels["state"]), style.RED, 7, mark="s")
    axes.text(
        HALF_BEFORE - 0.08,
        levels["state"] + 0.12,
        f"$v_{{n-1/2}}$, $V_t$, $\\Omega$\n$v_x = {v:.2f}$ mm/s",
        ha="right",
        va="center",
    )
    style.dot(axes, (NOW, levels["state"]), style.BLUE, 7)
    axes.text(
        NOW + 0.08,
        levels["state"] + 0.12,
        f"$x_n$, pose $x_G$, $R$ of the tool\n$x = {x:.6f}$ mm",
        ha="left",
        va="center",
    )
    box(axes, (NOW, levels["contact"]), f"contact:  the node gets $F_n\\nu - F_t = {force}$ N", style.GREEN, 2.7)
    box(axes, (NOW, levels["elements"]), "elements:  internal forces, thickness", style.GREEN, 2.7)
    box(axes, (NOW, levels["acceleration"]), "acceleration  $a_n$ = (all forces and loads) / mass", style.GREEN, 2.7)
    style.arrow(axes, (HALF_BEFORE, levels["velocity"]), (HALF_AFTER, levels["velocity"]), style.RED, 2.0)
    style.dot(axes, (HALF_BEFORE, levels["velocity"]), style.RED, 7, mark="s")
    style.dot(axes, (HALF_AFTER, levels["velocity"]), style.RED, 7, mark="s")
    axes.text(
        NOW,
        levels["velocity"] + 0.24,
        "$v_{n+1/2} = v_{n-1/2} + a_n (\\Delta t_1 + \\Delta t_2)/2$",
        ha="center",
        zorder=8,
    )
    axes.text(HALF_AFTER + 0.1, levels["velocity"], f"$v_x = {v_next:.2f}$ mm/s", va="center")
    style.arrow(axes, (NOW, levels["position"]), (NEXT, levels["position"]), style.BLUE, 2.0)
    style.dot(axes, (NOW, levels["position"]), style.BLUE, 7)
    style.dot(axes, (NEXT, levels["position"]), style.BLUE, 7)
    axes.text(HALF_AFTER, levels["position"] + 0.24, "$x_{n+1} = x_n + v_{n+1/2}\\,\\Delta t_2$", ha="center", zorder=8)
    axes.text(NEXT - 0.02, levels["position"] - 0.3, f"$x = {x_next:.6f}$ mm", va="center", ha="center")
    for i, (name, level) in enumerate(levels.items()):
        axes.text(
            -0.55,
            level,
            f"{i + 1}",
            ha="center",
            va="center",
            fontsize=9,
            color="white",
            zorder=9,
            bbox={"boxstyle": "circle,pad=0.25", "fc": style.INK, "ec": "none"},
        )
    for (start, end), name in (((PREVIOUS, NOW), "$\\Delta t_1$"), ((NOW, NEXT), "$\\Delta t_2$")):
        axes.annotate(
            "", (start, 6.62), (end, 6.62), arrowprops={"arrowstyle": "<->", "lw": 0.9, "shrinkA": 0, "shrinkB": 0}
        )
        axes.text((start + end) / 2, 6.68, name, ha="center", va="bottom")
    axes.set_title(f"Cycle n = {n} of cases/{CASE}, node {NODE}")
    axes.axis("off")
    axes.set(xlim=(-0.75, 4.6), ylim=(-0.4, 7.1))
    return drawn
