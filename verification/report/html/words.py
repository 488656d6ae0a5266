"""Numbers and pictures as text for the report."""

from markupsafe import Markup


def number(value, digits=10):
    """A value to read and compare: up to ten digits, no zeros behind."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if isinstance(value, int) or (float(value).is_integer() and abs(value) < 1e9):
        return f"{int(value):,}".replace(",", "\u202f")
    return f"{value:.{digits}g}".replace("-", "−")


def small(value):
    """A difference or tolerance: two digits."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    return "0" if value == 0 else f"{value:.1e}".replace("-", "−")


def nanoseconds(value):
    """A time to read: three digits and a unit."""
    for limit, unit in ((1e3, "ns"), (1e6, "µs"), (1e9, "ms")):
        if value < limit:
            return f"{value * 1e3 / limit:.3g} {unit}"
    return f"{value * 1e-9:.3g} s"


def percent(part, whole):
    if not whole:
        return "–"
    share = 100 * part / whole
    return "0 %" if part == 0 else f"{share:.3g} %" if share >= 0.001 else f"{share:.0e} %"


def picture(svg, alt):
    """An SVG as an image with its data inside; ids and styles of one picture cannot meet those of another."""
    data = svg.replace('"', "'").replace("%", "%25").replace("#", "%23").replace("&", "%26").replace("\n", "%0A")
    return Markup('<img loading="lazy" decoding="async" src="data:image/svg+xml,{}" alt="{}">').format(Markup(data), alt)


def plural(count, one, many=None):
    return f"{number(count)} {one if count == 1 else many or one + 's'}"
