"""Panels of curves under each other, drawn by matplotlib as SVG with text left as text."""

import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402
import numpy as np  # noqa: E402

# Tol's muted colours: apart also for colour-blind readers.
COLOURS = ("#332288", "#117733", "#cc5566", "#2f93b8", "#997700", "#555555", "#44aa99", "#882255")
# Inches of a figure: its width, left and right of the axes, above each and below the last.
WIDE, LEFT, RIGHT, ABOVE, BELOW = 6.6, 0.62, 1.75, 0.36, 0.45
FONT = "system-ui,Helvetica,Arial,sans-serif"
plt.rcParams.update({
    "svg.fonttype": "none", "font.size": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "axes.titlecolor": "#333333",
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#888888", "axes.linewidth": 0.6,
    "xtick.color": "#555555", "ytick.color": "#555555", "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.formatter.limits": (-4, 6), "axes.formatter.useoffset": False,
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


def thousands(arrays, least=1e-3):
    """Power of ten, a multiple of three, that values are given in; 0 while they read well as they are."""
    top = max((float(np.abs(values).max()) for values in arrays if len(values)), default=0.0)
    return 0 if not 0 < top < np.inf or least <= top < 1e5 else int(3 * np.floor(np.log10(top) / 3))


def raised(power):
    return "10" + str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")) + " "


def short(label, most=21):
    return label if len(label) <= most else label[: most - 1] + "…"


def draw_line(axes, line, time_factor, factor):
    x = np.asarray(line.x) * time_factor
    y = np.asarray(line.y) * factor
    colour = COLOURS[line.colour % len(COLOURS)]
    if line.style == "measured":
        step = max(1, len(x) // 28)
        axes.plot(x[::step], y[::step], "o", ms=3.2, mfc="white", mec=colour, mew=0.9, zorder=3)
    elif line.style == "expected":
        axes.plot(x, y, "o", ms=7, mfc="none", mec=colour, mew=1.2, zorder=4)
    elif line.style == "tolerance":
        axes.plot(x, y, ":", color=colour, lw=1.2)
    else:
        x, y = thinned(x, y)
        axes.plot(x, y, "--" if line.style == "other" else "-", color=colour, label=short(line.label) or None)


def one_style(found):
    """Marks of one line repeat their style: it is written once, on their group."""
    styles = set(re.findall(r' style="[^"]*"', found[2]))
    if len(styles) != 1 or " style=" in found[1]:
        return found[0]
    style = styles.pop()
    return f"<g{found[1]}{style}>{found[2].replace(style, '')}</g>"


def plain_log(axis):
    """Ticks of a logarithmic axis at 1, 2, 5, written as they are."""
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_locator(matplotlib.ticker.NullLocator())


def legend_below(figure, axes, columns):
    """A legend of what `axes` draws under the whole figure, so that a narrow screen shows it. For constrained layouts."""
    handles, labels = axes.get_legend_handles_labels()
    rows = -(-len(labels) // columns)
    share = (0.19 * rows + 0.1) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.legend(handles, labels, loc="lower left", bbox_to_anchor=(0, 0), ncol=columns, handlelength=1.4, columnspacing=1.2)


def as_svg(figure, salt):
    """SVG text with coordinates of 2 digits behind the point and the reader's own sans-serif font."""
    plt.rcParams["svg.hashsalt"] = salt
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    plt.close(figure)
    text = out.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.S)
    text = re.sub(r"<[^>]*>", lambda tag: re.sub(r"(\d\.\d\d)\d+", r"\1", tag[0]), text)
    text = re.sub(r"(font: [\d.]+px )[^;\"]*", rf"\1{FONT}", text)
    text = re.sub(r"\s*\n\s*", " ", re.sub(r">\s+<", "><", text))
    return re.sub(r"<g([^>]*)>((?:<use [^>]*/>)+)</g>", one_style, text)


def draw(panels, time_unit, units, salt):
    """SVG of the panels over one axis of time."""
    heights = [1.25 if panel.log else 1.5 for panel in panels]
    high = sum(heights) + ABOVE * len(panels) + BELOW
    figure = plt.figure(figsize=(WIDE, high))
    top, shared = high, None
    clock = thousands([line.x for panel in panels for line in panel.lines], least=0.1)
    for panel, height in zip(panels, heights):
        # Placed by hand: matplotlib's own layouts and titles measure every text, which takes half of the time.
        top -= ABOVE + height
        axes = figure.add_axes((LEFT / WIDE, top / high, (WIDE - LEFT - RIGHT) / WIDE, height / high), sharex=shared)
        shared = shared or axes
        axes.tick_params(labelbottom=panel is panels[-1])
        power = 0 if panel.log else thousands([line.y for line in panel.lines])
        for line in panel.lines:
            draw_line(axes, line, 10.0 ** -clock, 10.0 ** -power)
        unit = (raised(power) if power else "") + units.get(panel.unit, panel.unit)
        axes.text(0, 1.05, panel.title + (f" [{unit}]" if unit else ""), transform=axes.transAxes, color="#333333", va="bottom")
        if panel.log and any(len(line.x) and line.style != "tolerance" for line in panel.lines):
            axes.set_yscale("log")
        elif panel.log:
            axes.set_yscale("log")
            axes.text(0.01, 0.5, "no difference in any bit", transform=axes.transAxes, color="#555555")
        least, most = axes.get_ylim()
        if not panel.log and most - least < 1e-5 * max(abs(least), abs(most)):
            # Constant to rounding: ticks that only differ in their last digit say nothing.
            axes.set_ylim(*sorted((0.9 * least, 1.1 * most) if least > 0 else (1.1 * least, 0.9 * most)))
        handles, labels = axes.get_legend_handles_labels()
        if handles:
            axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2, borderaxespad=0.3)
    axes.set_xlabel(f"time [{raised(clock) if clock else ''}{time_unit}]")
    return as_svg(figure, salt)
