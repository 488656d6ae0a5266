"""Jump of the force against the step, from build/report/stability.json (type21 stability --json)."""

from pathlib import Path

import curves
from store import digest

HERE = Path(__file__).resolve().parent
MARKS = "os^D"
ROUNDING = 1e-9  # of forces of some hundred newtons [N]


def steps(row):
    return [row["first_step_mm"] / 2**number for number in range(len(row["normal"]["largest_jump"]))]


def draw(rows):
    """A panel for each shape of tool; solid: interpolated normals, as documented, dashed: those of the facets."""
    import matplotlib.pyplot as plt

    # Smaller jumps are rounding, and are drawn as such.
    seen = [jump for row in rows for what in ("normal", "facet_normal") for jump in row[what]["largest_jump"] if jump > ROUNDING]
    none = min(seen, default=1.0) / 10
    tools = list(dict.fromkeys(row["tool"] for row in rows))
    meshes = list(dict.fromkeys(row["mesh"] for row in rows))
    figure, panels = plt.subplots(1, len(tools), figsize=(6.6, 3.1), sharey=True, layout="constrained", squeeze=False)
    for tool, axes in zip(tools, panels[0]):
        for row in (row for row in rows if row["tool"] == tool):
            number = meshes.index(row["mesh"])
            for what, line in (("normal", "-"), ("facet_normal", "--")):
                jumps = [max(jump, none) for jump in row[what]["largest_jump"]]
                axes.plot(steps(row), jumps, line, marker=MARKS[number % len(MARKS)], ms=3.5, mfc="none" if line == "--" else None, lw=1.0, color=curves.COLOURS[number])
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(tool)
        axes.set_xlabel("displacement in a cycle [mm]")
        axes.minorticks_off()
        decades = [10.0 ** power for power in range(-12, 6) if none * 2 < 10.0 ** power <= 2 * max(seen, default=1.0)]
        axes.set_yticks([none, *decades], ["rounding", *(f"{jump:g}" for jump in decades)])
        axes.set_xticks(steps(rows[0])[::2], [f"{x:g}" for x in steps(rows[0])[::2]])
    panels[0, 0].set_ylabel("largest jump of $F_n$ [N]".replace("$F_n$", "Fₙ"))
    for number, mesh in enumerate(meshes):
        panels[0, -1].plot([], [], "-", marker=MARKS[number % len(MARKS)], ms=4, color=curves.COLOURS[number], label=mesh)
    panels[0, -1].plot([], [], "-", color="#555555", label="interpolated normals")
    panels[0, -1].plot([], [], "--", color="#555555", label="facet normals")
    curves.legend_below(figure, panels[0, -1], 3)
    return curves.as_svg(figure, "sliding")


def note(rows):
    """Tools on which the jump halves with the step, and the remaining share where it does not."""
    none = [row for row in rows if row["normal"]["largest_jump"][-1] <= ROUNDING]
    smooth = [row for row in rows if row not in none and row["normal"]["largest_jump"][-1] < 0.6 * row["normal"]["largest_jump"][-2]]
    rest = [row for row in rows if row not in smooth and row not in none]
    text = f"On {len(smooth) + len(none)} of {len(rows)} tools the jump of the normal force halves with the step or is within rounding: the force is continuous"
    if rest:
        worst = max(rest, key=lambda row: row["normal"]["residual"] / row["facet_normal"]["residual"] if row["facet_normal"]["residual"] else 0)
        text += (f"; on {', '.join(row['tool'] + ' ' + row['mesh'] for row in rest)} a part of it remains, at most "
                 f"{100 * worst['normal']['residual'] / worst['facet_normal']['residual']:.2g} % of the jump with facet normals ({worst['tool']} {worst['mesh']})")
    bad = [row for row in rows if not row["holds"]]
    return text + ("; all stay below their bounds." if not bad else f"; {len(bad)} EXCEED their bounds.")


def figure(found, store):
    """None without a stability.json that slides."""
    rows = (found or {}).get("sliding") or []
    if not rows:
        return None
    key = digest(HERE / "sliding.py", HERE / "curves.py", repr(rows))
    return {"svg": store.get("sliding", key, lambda: draw(rows)), "title": "Largest jump of the normal force between cycles against the displacement in a cycle", "note": note(rows), "rows": rows,
            "long_runs": found.get("long_runs") or []}
