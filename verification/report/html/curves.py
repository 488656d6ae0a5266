"""Panels of curves under each other, drawn by matplotlib as SVG with text left as text."""

import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

# Tol's muted colours: apart also for colour-blind readers.
COLOURS = ("#332288", "#117733", "#aa4466", "#2f7fa3", "#997700", "#882255", "#44aa99", "#777777")
FONT = "system-ui,-apple-system,'Segoe UI','Helvetica Neue',Arial,sans-serif"
plt.rcParams.update({
    "svg.fonttype": "none", "font.size": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "axes.titlecolor": "#333333",
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#888888", "axes.linewidth": 0.6,
    "xtick.color": "#555555", "ytick.color": "#555555", "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.formatter.limits": (-3, 4),
    "legend.frameon": False, "legend.fontsize": 8, "lines.linewidth": 1.2, "grid.color": "#e6e6e6", "grid.linewidth": 0.6, "axes.grid": True,
    "axes.axisbelow": True, "path.simplify": True, "path.simplify_threshold": 0.6,
})


def thinned(x, y, most=500):
    """Smallest and largest of each of `most`/2 stretches: no peak is lost."""
    if len(x) <= most:
        return x, y
    kept = [0, len(x) - 1]
    for part in np.array_split(np.arange(len(x)), most // 2):
        kept += [part[np.argmin(y[part])], part[np.argmax(y[part])]]
    kept = np.unique(kept)
    return x[kept], y[kept]


def draw_line(axes, line):
    colour = COLOURS[line.colour % len(COLOURS)]
    if line.style == "measured":
        step = max(1, len(line.x) // 28)
        axes.plot(line.x[::step], line.y[::step], "o", ms=3.2, mfc="white", mec=colour, mew=0.9, zorder=3)
    elif line.style == "expected":
        axes.plot(line.x, line.y, "o", ms=7, mfc="none", mec=colour, mew=1.2, zorder=4)
    elif line.style == "tolerance":
        axes.plot(line.x, line.y, ":", color=colour, lw=1.2)
    else:
        x, y = thinned(np.asarray(line.x), np.asarray(line.y))
        axes.plot(x, y, "--" if line.style == "other" else "-", color=colour, label=line.label or None)


def as_svg(figure, salt):
    """SVG text with coordinates of 2 digits behind the point and the reader's own sans-serif font."""
    plt.rcParams["svg.hashsalt"] = salt
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    plt.close(figure)
    text = out.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.S)
    text = re.sub(r"(\d\.\d\d)\d+", r"\1", text)
    text = re.sub(r"'DejaVu Sans'[^;\"]*", FONT, text)
    return re.sub(r">\s+<", "><", text)


def draw(panels, time_unit, units, salt):
    """SVG of the panels over one axis of time."""
    heights = [1.25 if panel.log else 1.5 for panel in panels]
    figure, rows = plt.subplots(len(panels), 1, figsize=(6.6, sum(heights) + 0.55 * len(panels)), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": heights}, layout="constrained")
    for axes, panel in zip(rows[:, 0], panels):
        for line in panel.lines:
            draw_line(axes, line)
        unit = units.get(panel.unit, panel.unit)
        axes.set_title(panel.title + (f" [{unit}]" if unit else ""))
        if panel.log and any(len(line.x) and line.style != "tolerance" for line in panel.lines):
            axes.set_yscale("log")
        elif panel.log:
            axes.set_yscale("log")
            axes.text(0.01, 0.5, "no difference in any bit", transform=axes.transAxes, color="#555555")
        handles, labels = axes.get_legend_handles_labels()
        if handles:
            axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2, borderaxespad=0.3)
    rows[-1, 0].set_xlabel(f"time [{time_unit}]")
    return as_svg(figure, salt)
