"""The figures of accuracy against time. What they draw comes as plain rows of accuracy.json."""

import curves
import matplotlib.pyplot as plt
import words

MARKS = "osD^vP"
KINDS = ("easy", "common", "adversarial")
# Light to dark: the later a stage, the darker.
STAGE_COLOURS = ("#e3e6ea", "#88a9bf", "#b5c98a", "#d1b464", "#6b4f83")


def label(row):
    return ", ".join(word for word in (row["implementation"], row["method"]) if word)


def times(axes, row, y, colour):
    """A bar from the median to the 95th percentile, a thin one to the largest."""
    ns = row["ns"]
    axes.plot([ns["p50"], ns["max"]], [y, y], "-", color=colour, lw=0.6)
    axes.plot([ns["p50"], ns["p95"]], [y, y], "-", color=colour, lw=2.2)


def wrong_mark(axes, row, mark, colour, least):
    share = row["wrong"] / row["decisions"]
    y = share if share > 0 else least
    times(axes, row, y, colour)
    axes.plot(row["ns"]["p50"], y, mark, color=colour, ms=6, mfc=colour if share > 0 else "white", zorder=3)
    if row["undecided"]:
        axes.plot(row["ns"]["p50"], max(row["undecided"] / row["decisions"], least), "x", color=colour, ms=5, mew=1.2, zorder=4)


def force_mark(axes, row, mark, colour, least):
    force = row["force"]
    if "ulps_max" not in force:
        return
    high, usual = (max(force[name], least) for name in ("ulps_max", "ulps_p99"))
    times(axes, row, high, colour)
    axes.plot([row["ns"]["p50"]] * 2, [usual, high], "-", color=colour, lw=0.8, alpha=0.6)
    axes.plot(row["ns"]["p50"], usual, "_", color=colour, ms=7)
    axes.plot(row["ns"]["p50"], high, mark, color=colour, ms=6, zorder=3)


def draw_methods(rows, what):
    """A panel for each kind of scene over one axis of time; a method is a colour, a scene of the kind a mark."""
    methods = list(dict.fromkeys(label(row) for row in rows))
    kinds = [kind for kind in KINDS if any(row["kind"] == kind for row in rows)]
    figure, panels = plt.subplots(len(kinds), 1, figsize=(6.6, 1.1 + 1.75 * len(kinds)), sharex=True, layout="constrained", squeeze=False)
    shares = [row["wrong"] / row["decisions"] for row in rows if row["wrong"]]
    none = min(shares, default=0.01) / 4
    for kind, axes in zip(kinds, panels[:, 0]):
        scenes = list(dict.fromkeys(row["scene"] for row in rows if row["kind"] == kind))
        for row in (row for row in rows if row["kind"] == kind):
            colour, mark = curves.COLOURS[methods.index(label(row)) % len(curves.COLOURS)], MARKS[scenes.index(row["scene"])]
            (wrong_mark if what == "wrong" else force_mark)(axes, row, mark, colour, none if what == "wrong" else 0.5)
        axes.set_xscale("log")
        axes.set_yscale("log")
        if what == "wrong":
            axes.set_ylim(none / 2, 1.5)
            decades = [10.0 ** power for power in range(-12, 1) if 10.0 ** power > 1.5 * none]
            axes.set_yticks([none, *decades], ["none", *(f"{share:.6g}" for share in decades)])
            axes.minorticks_off()
        named = ", ".join(f"{'○□◇△▽✚'[number]} {scene}" for number, scene in enumerate(scenes))
        axes.set_title(f"{kind}: {named}" if kind != scenes[0] or len(scenes) > 1 else kind)
        axes.set_ylabel("wrong, share" if what == "wrong" else "error [ulp]", fontsize=8)
    for number, name in enumerate(methods):
        panels[0, 0].plot([], [], "-", lw=4, color=curves.COLOURS[number % len(curves.COLOURS)], label=name)
    panels[-1, 0].set_xlabel("ns for a decision; mark: median, bar: to p95, line: to max; cross: share not decided" if what == "wrong" else "ns for a decision; mark: largest error, dash: 99th percentile")
    curves.legend_below(figure, panels[0, 0], 3)
    return curves.as_svg(figure, f"accuracy-{what}")


def draw_search(rows):
    """One row a search, one mark a scene, over time."""
    names = list(dict.fromkeys(label(row) for row in rows))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, axes = plt.subplots(figsize=(6.6, 1.3 + 0.34 * len(names)), layout="constrained")
    for row in rows:
        number = scenes.index(row["scene"])
        y = names.index(label(row)) + 0.11 * (number - (len(scenes) - 1) / 2)
        times(axes, row, y, curves.COLOURS[number])
        axes.plot(row["ns"]["p50"], y, MARKS[number], color=curves.COLOURS[number], ms=4.5)
    for number, scene in enumerate(scenes):
        axes.plot([], [], MARKS[number], color=curves.COLOURS[number], ms=5, label=scene)
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_xscale("log")
    axes.set_xlabel("ns for a decision, with the search")
    curves.legend_below(figure, axes, 4)
    return curves.as_svg(figure, "accuracy-search")


def draw_stages(rows):
    """A bar for each scene and implementation, cut into the shares of its stages; each implementation has its own stages."""
    implementations = list(dict.fromkeys(row["implementation"] for row in rows))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, panels = plt.subplots(len(implementations), 1, figsize=(6.6, 0.75 + len(implementations) * (0.6 + 0.24 * len(scenes))), sharex=True,
                                  layout="constrained", squeeze=False)
    for implementation, axes in zip(implementations, panels[:, 0]):
        for row in (row for row in rows if row["implementation"] == implementation):
            y, start = scenes.index(row["scene"]), 0.0
            decided = sum(stage["settled"] for stage in row["stages"])
            colours = STAGE_COLOURS if len(row["stages"]) == len(STAGE_COLOURS) else (*STAGE_COLOURS[:2], *STAGE_COLOURS[3:])
            for stage, colour in zip(row["stages"], colours):
                width = 100 * stage["settled"] / decided
                axes.barh(y, width, left=start, height=0.72, color=colour, label=stage["stage"] if y == 0 else None)
                if width > 10 and "ns" in stage:
                    axes.text(start + width / 2, y, words.nanoseconds(stage["ns"]["p50"]), ha="center", va="center", fontsize=7, color="white" if colour == STAGE_COLOURS[-1] else "#333333")
                start += width
        axes.set_yticks(range(len(scenes)), scenes)
        axes.set_ylim(len(scenes) - 0.4, -0.6)
        axes.set_xlim(0, 100)
        axes.grid(False)
        axes.set_title(implementation)
        axes.legend(loc="lower left", bbox_to_anchor=(0.16, 0.99), ncol=5, handlelength=1.0, columnspacing=1.0, borderaxespad=0.1, fontsize=7)
    panels[-1, 0].set_xlabel("share of the decisions [%]; the time is that of a decision settled in the stage")
    return curves.as_svg(figure, "accuracy-stage_counts")


def draw_effects(effects):
    """Left what an effect costs when on, right what it costs when off, with standard errors."""
    names = list(dict.fromkeys(row["effect"] for row in effects))
    figure, (on, off) = plt.subplots(1, 2, figsize=(6.6, 1.1 + 0.24 * len(names)), sharey=True, layout="constrained", width_ratios=(1, 1))
    for number, implementation in enumerate(dict.fromkeys(row["implementation"] for row in effects)):
        colour = curves.COLOURS[number]
        for row in (row for row in effects if row["implementation"] == implementation):
            y = names.index(row["effect"]) + 0.18 * (2 * number - 1)
            base = row["ns_off"]["p50"]
            on.errorbar(100 * row["extra_ns"] / base, y, xerr=200 * row["extra_error"] / base, fmt="o", ms=3.5, lw=1, color=colour)
            off.errorbar(100 * (row["off_ratio"] - 1), y, xerr=200 * row["off_error"], fmt="o", ms=3.5, lw=1, color=colour)
        off.plot([], [], "o", ms=4, color=colour, label=implementation)
    for axes, title in ((on, "on − off [% of a cycle]"), (off, "off − absent [% of a cycle]")):
        axes.axvline(0, color="#444444", lw=0.8)
        axes.set_title(title)
    on.set_yticks(range(len(names)), names)
    on.set_ylim(len(names) - 0.4, -0.6)
    curves.legend_below(figure, off, 2)
    return curves.as_svg(figure, "accuracy-effects")
