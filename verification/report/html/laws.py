"""The range of its laws that a case covers: friction over pressure and speed, pressure over penetration, heat over distance (type21 laws)."""

import json
import subprocess
import tempfile
from pathlib import Path

import words

MOST = 6  # interfaces drawn
ULP = 2.0**-52


def runs_to_show(case):
    """Names of the runs to show: runs with heat exchange; in the case families of laws also those with friction or a pressure limit."""
    wanted = ("heat exchange", *(("friction (", "limit of the contact pressure") if case.family in ("friction law", "Pmax limit") else ()))
    return [name for name, run in case.run_json.items()
            if any(effect.startswith(wanted) for interface in run["interfaces"] for effect in interface["effects"])]


def points_of(program, case, run_name):
    """What type21 laws says of a run; None if it does not run."""
    run = case.runs[run_name]
    command = [program, "laws", case.deck_of(run_name)]
    if run.get("as_built"):
        command += ["--as-built", run["as_built"]]
    if run.get("thickness"):
        command += ["--thickness", case.folder / run["thickness"]]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "laws.json"
        done = subprocess.run([*command, "--json", out], capture_output=True, text=True)
        return json.loads(out.read_text()) if done.returncode == 0 and out.is_file() else None


def panels_of(found):
    """(what, interface) of the panels that have something to show."""
    out = []
    for what in ("friction", "normal", "heat"):
        out += [(what, interface) for interface in found["interfaces"] if interface[what]][:MOST]
    return out


def draw_friction(axes, interface, units, colours):
    for number, curve in enumerate(interface["curves"]):
        axes.plot(interface["pressures"], curve["mu"], "-", lw=1.1, color=colours[number], label=f"{curve['speed']:.4g} {units['speed']}")
        axes.plot(interface["pressures"], curve["mu_optimized"], ":", lw=2.2, color=colours[number])
    speeds = [curve["speed"] for curve in interface["curves"]]
    for pressure, speed, mu in interface["friction"]:
        nearest = min(range(len(speeds)), key=lambda number: abs(speeds[number] - speed))
        axes.plot(pressure, mu, "o", ms=3.5, mfc="none", mew=0.9, color=colours[nearest])
    axes.set_title(f"Ifric {interface['ifric']}: µ over pressure [{units['pressure']}]")
    high = max(mu for curve in interface["curves"] for mu in curve["mu"])
    axes.set_ylim(0, 1.15 * max(high, *(point[2] for point in interface["friction"])))
    axes.legend(loc="best", fontsize=7, handlelength=1.2)


def draw_normal(axes, interface, units, colours):
    ordered = sorted(interface["normal"])
    axes.plot([p for p, _ in ordered], [f for _, f in ordered], "o", ms=2.2, color=colours[0])
    axes.axhline(interface["pmax"], color="#444444", lw=0.8, ls="--")
    axes.annotate("Pmax", (1.0, interface["pmax"]), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize=7, color="#444444")
    axes.set_title(f"F / A [{units['pressure']}] over penetration [{units['length']}]")


def draw_heat(axes, interface, units, colours):
    axes.plot([d for d, _ in interface["heat"]], [k for _, k in interface["heat"]], "o", ms=2.5, color=colours[4])
    axes.set_title(f"heat conductance [{units['conductance']}] over distance [{units['length']}]")


def draw(found, salt):
    """A panel an interface and law, two in a row."""
    import curves
    import matplotlib.pyplot as plt

    panels = panels_of(found)
    rows = -(-len(panels) // 2)
    figure, grid = plt.subplots(rows, 2, figsize=(6.6, 0.2 + 2.0 * rows), layout="constrained", squeeze=False)
    for axes, (what, interface) in zip(grid.flat, panels):
        {"friction": draw_friction, "normal": draw_normal, "heat": draw_heat}[what](axes, interface, found["units"], curves.COLOURS)
        axes.title.set_fontsize(8)
        if len(found["interfaces"]) > 1 and interface["title"]:
            axes.text(0.99, 0.02, interface["title"], transform=axes.transAxes, ha="right", fontsize=7, color="#555555")
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    return curves.as_svg(figure, f"laws-{salt}")


def note_on_limit(limit, pmax, units):
    """Whether Pmax acts: counted over all nodes and cycles, as the points drawn are only some of them."""
    if not limit["lowered"]:
        return f"the force is k p in all {words.number(limit['node_cycles'])} node-cycles, up to {limit['largest']:.3g} {units['pressure']}, so Pmax ({pmax:.4g} {units['pressure']}) does not act"
    out = f"Pmax ({pmax:.4g} {units['pressure']}) lowers the force in {words.percent(limit['lowered'], limit['node_cycles'])} of the {words.number(limit['node_cycles'])} node-cycles"
    if limit["plateau"]:
        out += f"; on the plateau F / A is Pmax, for penetrations from {limit['first']:.3g} to {limit['last']:.3g} {units['length']}"
    if limit["largest"] > 1.000001 * pmax:
        out += f"; past the growth of the gap it rises again, to {limit['largest']:.4g} {units['pressure']}"
    return out


def note(found):
    """What the points are, and their result."""
    text = []
    sliding = [interface for interface in found["interfaces"] if interface["friction"]]
    if sliding:
        mu = [point[2] for interface in sliding for point in interface["friction"]]
        apart = max(interface["difference"] for interface in sliding)
        text.append(f"Rings: |Fₜ| / |Fₙ| of nodes that slip, {min(mu):.3g} to {max(mu):.3g}; lines: the law of the card at their speeds, dotted that of the optimized implementation, "
                    + ("equal in every bit" if apart == 0 else f"at most {apart / ULP:.2g} ulps apart"))
        if any(interface["several_mu"] for interface in sliding):
            text.append("parts, temperature or a limit of the friction force move nodes off that line")
    limited = [interface for interface in found["interfaces"] if interface["normal"]]
    for interface in limited:
        text.append(note_on_limit(interface["limit"], interface["pmax"], found["units"]))
    warm = [interface for interface in found["interfaces"] if interface["heat"]]
    if warm:
        k = [value for interface in warm for _, value in interface["heat"]]
        text.append(f"heat flows with a conductance of {min(k):.3g} to {max(k):.3g} {found['units']['conductance']}" if max(k) > min(k) else f"heat flows with a conductance of {k[0]:.3g} {found['units']['conductance']} at every node in contact")
    out = "; ".join(text)
    return out[:1].upper() + out[1:] + "."


def figure(case, program):
    """{svg, note} of the first run with something to show; None if there is none."""
    for name in runs_to_show(case):
        found = points_of(program, case, name)
        if found and panels_of(found):
            return {"svg": draw(found, case.name), "note": f"Run {name}. {note(found)}"}
    return None
