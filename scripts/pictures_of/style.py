"""The look that all pictures share: colours that stay apart for the colour-blind and in grey."""

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from contourpy import contour_generator  # noqa: E402

BLUE, ORANGE, RED, GREEN = "#0072B2", "#E69F00", "#D55E00", "#009E73"
INK, GREY, PALE = "#222222", "#7A7A7A", "#E9E9E9"
# Regions: of T, of its neighbour, of both, of T and a third one, of others. They differ in lightness, too.
OWN, NEXT, BOTH, THIRD, OTHERS = "#9CCBE8", "#FAE8B4", "#CC7A00", "#6B3510", "#F0F0F0"

matplotlib.rcParams.update(
    {
        "svg.fonttype": "path",
        "svg.hashsalt": "type21",
        "font.family": "DejaVu Sans",
        "font.size": 9.5,
        "mathtext.fontset": "dejavusans",
        "axes.titlesize": 10.5,
        "axes.titlelocation": "left",
        "axes.labelsize": 9.5,
        "axes.edgecolor": INK,
        "axes.labelcolor": INK,
        "text.color": INK,
        "xtick.color": INK,
        "ytick.color": INK,
        "axes.linewidth": 0.8,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "legend.frameon": False,
        "legend.fontsize": 9,
        "figure.facecolor": "white",
        "savefig.facecolor": "white",
        "path.simplify": True,
        "path.simplify_threshold": 0.6,
        "image.interpolation": "nearest",
    }
)


def figure(width, height, *columns):
    """A figure of so many inches; columns: relative widths of its axes, one by default."""
    widths = columns or (1,)
    drawn, axes = plt.subplots(
        1,
        len(widths),
        figsize=(width, height),
        squeeze=False,
        layout="constrained",
        gridspec_kw={"width_ratios": widths},
    )
    drawn.get_layout_engine().set(w_pad=0.08, h_pad=0.06)
    return (drawn, *axes[0])


def as_svg(drawn):
    """The bytes of the picture: the same for the same numbers, without a date."""
    out = io.BytesIO()
    drawn.savefig(
        out,
        format="svg",
        dpi=200,
        bbox_inches="tight",
        pad_inches=0.06,
        metadata={"Date": None, "Creator": "scripts/pictures"},
    )
    return out.getvalue()


def legend_below(drawn, axes, columns, share=0.09):
    """The legend of these axes below all of the picture, which leaves it so much of its height."""
    drawn.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    drawn.legend(
        *axes.get_legend_handles_labels(), loc="lower center", ncols=columns, columnspacing=2.5, borderaxespad=0
    )


def bare(axes):
    """For sketches: no axes, the same scale in both directions."""
    axes.set_aspect("equal", anchor="N")
    axes.axis("off")


def arrow(axes, start, end, color=INK, width=1.6, head=11, style="-|>", line="-", over=5):
    """From start to end, both in the data's units."""
    axes.annotate(
        "",
        xy=end,
        xytext=start,
        zorder=over,
        arrowprops={
            "arrowstyle": style,
            "color": color,
            "lw": width,
            "mutation_scale": head,
            "shrinkA": 0,
            "shrinkB": 0,
            "linestyle": line,
        },
    )
    axes.update_datalim([start, end])
    axes.autoscale_view()


def label(axes, at, text, shift=(0, 0), color=INK, size=None, **more):
    """Text beside a point, shifted by points of the page; a pale ground keeps it readable on lines."""
    options = {"ha": "center", "va": "center", "zorder": 9, **more}
    return axes.annotate(
        text,
        xy=at,
        xytext=shift,
        textcoords="offset points",
        color=color,
        fontsize=size,
        bbox={"boxstyle": "round,pad=0.06", "fc": "white", "ec": "none", "alpha": 0.6},
        **options
    )


def dot(axes, at, color=INK, size=5, filled=True, over=6, mark="o"):
    axes.plot(*at, mark, ms=size, mfc=color if filled else "white", mec=color, mew=1.2, zorder=over, ls="none")


class View:
    """Orthographic view of space: the direction of the eye by azimuth and elevation [degrees]."""

    def __init__(self, azimuth, elevation):
        a, e = np.radians(azimuth), np.radians(elevation)
        self.right = np.array([-np.sin(a), np.cos(a), 0])
        self.up = np.array([-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)])

    def __call__(self, points):
        points = np.asarray(points, float)
        return np.stack([points @ self.right, points @ self.up], axis=-1)


def polygon(axes, corners, color, alpha=1.0, edge=INK, width=1.0, line="-", over=2):
    """@param color  None: the rim alone"""
    axes.add_patch(
        plt.Polygon(
            np.asarray(corners),
            closed=True,
            ec=edge,
            lw=width,
            ls=line,
            zorder=over,
            joinstyle="round",
            fc=matplotlib.colors.to_rgba(color, alpha) if color else "none",
        )
    )


def field(axes, u, v, colours, over=0):
    """A raster of colours: an array len(v) x len(u) x 4 of values from 0 to 1 at the middles of its cells."""
    du, dv = (u[-1] - u[0]) / (len(u) - 1) / 2, (v[-1] - v[0]) / (len(v) - 1) / 2
    axes.imshow(
        colours, extent=(u[0] - du, u[-1] + du, v[0] - dv, v[-1] + dv), origin="lower", aspect="auto", zorder=over
    )


def shaded(which, shades):
    """Colours for `field`: shades[i] where which == i, nothing where which < 0."""
    colours = np.zeros((*which.shape, 4))
    for i, shade in enumerate(shades):
        colours[which == i] = matplotlib.colors.to_rgba(shade)
    return colours


def simplified(line, tolerance):
    """The corners of a line that are needed to stay within this distance of it (Ramer, Douglas, Peucker)."""
    keep = np.zeros(len(line), bool)
    keep[[0, -1]] = True
    spans = [(0, len(line) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        way, off = line[last] - line[first], line[first + 1 : last] - line[first]
        length = np.hypot(*way)
        far = np.abs(way[0] * off[:, 1] - way[1] * off[:, 0]) / length if length > 0 else np.hypot(*off.T)
        if far.max() > tolerance:
            keep[first + 1 + far.argmax()] = True
            spans += [(first, first + 1 + far.argmax()), (first + 1 + far.argmax(), last)]
    return line[keep]


def outline(axes, u, v, inside, tolerance, color=INK, width=1.1, line="-", over=3):
    """The rim of a region that is given on a raster, smoothed by about one of its cells."""
    wider = [np.concatenate([[2 * w[0] - w[1]], w, [2 * w[-1] - w[-2]]]) for w in (u, v)]
    for rim in contour_generator(*wider, np.pad(inside.astype(float), 1)).lines(0.5):
        axes.plot(*simplified(np.asarray(rim), tolerance).T, color=color, lw=width, ls=line, zorder=over)
