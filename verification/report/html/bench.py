"""Speed of the optimized implementation, from build/report/bench.json (verification/performance/bench/README.md has its format). Parts that it lacks are not shown."""

from pathlib import Path

import curves
from store import digest

HERE = Path(__file__).resolve().parent
REACHED = {"aim": "goal reached", "at least": "least reached", "no": "NOT REACHED"}


def draw_ratios(ratios):
    """Ratio of two times, one row for each comparison."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.6, 0.8 + 0.24 * len(ratios)), layout="constrained")
    for y, row in enumerate(ratios):
        axes.plot([row["of_medians"], row.get("of_minima", row["of_medians"])], [y, y], "-", lw=1, color=curves.COLOURS[0])
        axes.plot(row["of_medians"], y, "o", ms=5, color=curves.COLOURS[0])
    axes.axvline(1, color="#444444", lw=0.8)
    axes.set_xscale("log")
    curves.plain_log(axes.xaxis)
    axes.set_yticks(range(len(ratios)), [curves.short(f"{row['scene']}: {row['what']}", 62) for row in ratios], fontsize=7)
    axes.set_ylim(len(ratios) - 0.4, -0.6)
    axes.set_xlabel("time of the first / time of the second (mark: medians, line: to minima)")
    return curves.as_svg(figure, "bench-ratios")


def draw_stages(stages):
    import matplotlib.pyplot as plt

    scenes = list(dict.fromkeys(row["scene"] for row in stages))
    names = list(dict.fromkeys(row["stage"] for row in stages))
    figure, axes = plt.subplots(figsize=(6.6, 1.3 + 0.34 * len(scenes)), layout="constrained")
    for y, scene in enumerate(scenes):
        start = 0.0
        for row in (row for row in stages if row["scene"] == scene and row["ns"] > 0):
            axes.barh(y, row["ns"], left=start, height=0.7, color=curves.COLOURS[names.index(row["stage"]) % len(curves.COLOURS)])
            start += row["ns"]
    for number, name in enumerate(names):
        axes.barh(0, 0, color=curves.COLOURS[number % len(curves.COLOURS)], label=name)
    axes.set_yticks(range(len(scenes)), scenes)
    axes.set_ylim(len(scenes) - 0.4, -0.6)
    axes.set_xlabel("ns per node and cycle")
    curves.legend_below(figure, axes, 4)
    return curves.as_svg(figure, "bench-stages")


def growth_lines(growth):
    """Names of the methods of the curve; `segments` and `nodes` are sizes."""
    return [name for name in dict.fromkeys(key for row in growth for key, value in row.items() if isinstance(value, (int, float))) if name not in ("segments", "nodes")]


def of_usual_nodes(growth):
    """Rows with the number of nodes of the first one, which is that of all other comparisons."""
    return sorted((row for row in growth if row.get("nodes") == growth[0].get("nodes")), key=lambda row: row["segments"])


def draw_growth(growth):
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.6, 2.8), layout="constrained")
    for number, name in enumerate(growth_lines(growth)):
        rows = [row for row in of_usual_nodes(growth) if name in row]
        axes.plot([row["segments"] for row in rows], [row[name] for row in rows], "o-", ms=4, color=curves.COLOURS[number % len(curves.COLOURS)], label=name.replace("_", " "))
    # The step with other numbers of nodes.
    others = [nodes for nodes in dict.fromkeys(row.get("nodes") for row in growth) if nodes != growth[0].get("nodes")]
    for number, nodes in enumerate(others):
        rows = sorted((row for row in growth if row.get("nodes") == nodes and "coherent" in row), key=lambda row: row["segments"])
        axes.plot([row["segments"] for row in rows], [row["coherent"] for row in rows], "^v<>"[number % 4], ls=":", ms=4, lw=0.8, color=curves.COLOURS[0], label="coherent, " + f"{nodes:,} nodes".replace(",", " "))
    axes.set_xscale("log")
    axes.set_yscale("log")
    curves.plain_log(axes.yaxis)
    axes.set_xlabel("segments of the tool")
    axes.set_title("ns per node and cycle")
    curves.legend_below(figure, axes, 5)
    return curves.as_svg(figure, "bench-growth")


def note_on_ratios(ratios):
    slower = [row for row in ratios if row["of_medians"] < 1]
    least, most = (pick(ratios, key=lambda row: row["of_medians"]) for pick in (min, max))
    text = f"The first takes {least['of_medians']:.3g} times ({least['scene']}: {least['what']}) to {most['of_medians']:.3g} times ({most['scene']}: {most['what']}) the time of the second"
    return text + (f"; in {len(slower)} of {len(ratios)} comparisons, those below 1, the first is faster." if slower else f", so the second is faster in all {len(ratios)} comparisons.")


def note_on_stages(stages):
    text = []
    for scene in dict.fromkeys(row["scene"] for row in stages):
        mine = [row for row in stages if row["scene"] == scene]
        most = max(mine, key=lambda row: row["ns"])
        text.append(f"on {scene} '{most['stage']}' takes most, {most['ns']:.3g} of {sum(row['ns'] for row in mine):.3g} ns")
    out = "; ".join(text)
    return out[:1].upper() + out[1:] + "."


def note_on_growth(growth):
    rows = of_usual_nodes(growth)
    text = [f"{name.replace('_', ' ')} takes {both[-1] / both[0]:.3g} times as long" for name in growth_lines(growth)
            if len(both := [row[name] for row in rows if name in row]) > 1]
    return f"On a tool with {rows[-1]['segments'] / rows[0]['segments']:.3g} times the segments " + ", ".join(text) + "." if text else "Only one size was measured."


def section(found, store):
    """None without a bench.json in this format."""
    if not isinstance(found, dict) or not found.get("rows"):
        return None
    code = digest(HERE / "bench.py", HERE / "curves.py")
    figures = dict.fromkeys(("ratios", "stages", "growth"))
    for name, title, draw, note in (("ratios", "Ratios of times", draw_ratios, note_on_ratios), ("stages", "Where the time of a step goes", draw_stages, note_on_stages),
                                    ("growth", "Time against the size of the tool", draw_growth, note_on_growth)):
        rows = found.get(name) or []
        if rows:
            figures[name] = {"svg": store.get(f"bench-{name}", digest(code, repr(rows)), lambda d=draw, r=rows: d(r)), "title": title, "note": note(rows)}
    targets = found.get("targets") or []
    missed = [row for row in targets if row["reached"] == "no"]
    about = {name: found[name] for name in ("command", "cpu", "compiler", "flags", "repeats", "commit") if found.get(name) not in (None, "")}
    for name, value in (found.get("machine") or {}).items():
        if isinstance(value, (str, int, float)) and name not in about:
            about[name] = value
    return {"about": about, "figures": figures, "targets": targets, "missed": missed, "words": REACHED,
            **{name: found.get(name) or [] for name in ("scenes", "rows", "ratios", "stages", "effects", "searches", "threads")}, "roofline": found.get("roofline"), "check": found.get("check")}
