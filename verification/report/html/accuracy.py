"""Accuracy against time, from build/report/bench.json:

  {"command": "type21 bench ...", "cpu": "...", "flags": "...", "repeats": 9,
   "rows": [{"scene": "bowl", "kind": "common", "method": "double + filter", "implementation": "optimized",
             "ns": {"p50": 61, "p95": 64, "max": 80}, "decisions": 100489, "wrong": 0,
             "force": {"ulps_max": 3, "ulps_p99": 1, "relative_max": 2e-16, "relative_p99": 1e-16}}],
   "effects": [{"effect": "Coulomb friction", "ns_off": 50.1, "ns_on": 53.0, "ns_absent": 50.0}]}

ns are per node and cycle over the repeats. Whatever a row leaves out is left out of the figure and shown as a dash."""

from pathlib import Path

from store import digest

HERE = Path(__file__).resolve().parent


def rows_of(found):
    """Rows that have a method and a time; nested groups made flat. `ns` may be one number."""
    out = []
    for row in found.get("rows") or found.get("results") or []:
        if not isinstance(row, dict) or "method" not in row:
            continue
        ns = row.get("ns", row.get("ns_per_node_cycle"))
        ns = ns if isinstance(ns, dict) else {"p50": ns} if isinstance(ns, (int, float)) else {}
        force = row.get("force") or {}
        wrong, decisions = row.get("wrong"), row.get("decisions")
        out.append({"scene": row.get("scene", ""), "method": row["method"], "implementation": row.get("implementation", ""),
                    "p50": ns.get("p50", ns.get("median")), "p95": ns.get("p95"), "max": ns.get("max"), "wrong": wrong, "decisions": decisions,
                    "share": wrong / decisions if decisions and wrong is not None else None,
                    "ulps_max": force.get("ulps_max"), "ulps_p99": force.get("ulps_p99"), "relative_max": force.get("relative_max"),
                    "relative_p99": force.get("relative_p99")})
    return [row for row in out if row["p50"]]


def draw(rows, scenes, what, title, salt):
    """One axis of time, one of error; a method is a colour, a scene a mark, the line goes from p50 to p95."""
    import curves
    import matplotlib.pyplot as plt

    methods = list(dict.fromkeys(f"{row['implementation']} {row['method']}".strip() for row in rows))
    shown = [row for row in rows if row[what] is not None]
    least = min((row[what] for row in shown if row[what] > 0), default=1.0)
    figure, axes = plt.subplots(figsize=(6.6, 3.4), layout="constrained")
    for row in shown:
        colour = curves.COLOURS[methods.index(f"{row['implementation']} {row['method']}".strip()) % len(curves.COLOURS)]
        mark = "osD^vPX*"[scenes.index(row["scene"]) % 8]
        y = row[what] if row[what] > 0 else least / 10
        axes.plot([row["p50"], row["p95"] or row["p50"]], [y, y], "-", color=colour, lw=1)
        axes.plot(row["p50"], y, mark, color=colour, ms=6, mfc="white" if row[what] == 0 else colour)
    for number, name in enumerate(methods):
        axes.plot([], [], "-", lw=4, color=curves.COLOURS[number % len(curves.COLOURS)], label=name)
    for number, name in enumerate(scenes):
        axes.plot([], [], "osD^vPX*"[number % 8], color="#555555", mfc="none", label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    if any(row[what] == 0 for row in shown):
        axes.axhline(least / 10, color="#bbbbbb", lw=0.6, ls=":")
        axes.annotate("none", (0.005, least / 10), xycoords=("axes fraction", "data"), va="bottom", fontsize=8, color="#555555")
    axes.set_xlabel("ns per node and cycle (mark: median, line: to the 95th percentile)")
    axes.set_title(title)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return curves.as_svg(figure, salt)


def name_of(row):
    return f"{row['implementation']} {row['method']}".strip()


def note_on_decisions(rows, scene):
    """One sentence: who is fastest without an error, and what the fastest of all gets wrong."""
    mine = [row for row in rows if row["scene"] == scene and row["wrong"] is not None]
    right = min((row for row in mine if row["wrong"] == 0), key=lambda row: row["p50"], default=None)
    first = min(mine, key=lambda row: row["p50"], default=None)
    if not mine:
        return ""
    if right is None:
        return f"On {scene} every method decides something wrongly."
    text = f"On {scene} the fastest method without a wrong decision is {name_of(right)} with {right['p50']:.4g} ns"
    if first is not right:
        text += f"; {name_of(first)} needs {first['p50']:.4g} ns and gets {first['wrong']} of {first['decisions']} wrong"
    else:
        text += ", and none is faster"
    return text + "."


def note_on_forces(rows):
    known = [row for row in rows if row["ulps_max"] is not None]
    worst = max(known, key=lambda row: row["ulps_max"], default=None)
    return "" if worst is None else (f"The largest force error is {worst['ulps_max']:.4g} ulps, of {name_of(worst)} on {worst['scene']}.")


def section(found, store):
    """Figures with their notes and tables; None without a bench.json that says anything."""
    if not isinstance(found, dict):
        return None
    rows = rows_of(found)
    if not rows:
        return None
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    key = digest(HERE / "accuracy.py", HERE / "curves.py", repr(rows))
    figures = []
    for what, title, note in (("share", "wrong decisions, share of all", " ".join(note_on_decisions(rows, scene) for scene in scenes)),
                              ("ulps_max", "largest force error [ulp]", note_on_forces(rows))):
        if any(row[what] is not None for row in rows):
            svg = store.get(f"bench-{what}", key, lambda w=what, t=title: draw(rows, scenes, w, t, w))
            figures.append({"svg": svg, "title": title, "note": note})
    effects = [effect for effect in found.get("effects", []) if isinstance(effect, dict) and "effect" in effect]
    about = {name: found[name] for name in ("command", "cpu", "compiler", "flags", "repeats", "version", "commit") if found.get(name)}
    return {"rows": rows, "figures": figures, "effects": effects, "about": about}
