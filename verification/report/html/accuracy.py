"""Accuracy against time, from build/report/accuracy.json (verification/performance/accuracy/README.md has its format)."""

from pathlib import Path

import words
from accuracy_figures import draw_effects, draw_stages, draw_methods, draw_search
from store import digest

HERE = Path(__file__).resolve().parent


def name_of(row):
    return ", ".join(word for word in (row["implementation"], row["method"]) if word)


def note_on_decisions(rows):
    """One sentence: the cost of always being right, against plain double, and the share that plain double gets wrong."""
    text = []
    for scene in dict.fromkeys(row["scene"] for row in rows):
        mine = [row for row in rows if row["scene"] == scene]
        right = min((row for row in mine if row["wrong"] == 0 and row["undecided"] == 0), key=lambda row: row["ns"]["p50"], default=None)
        plain = next((row for row in mine if row["method"] == "double"), None)
        if plain is None:
            continue
        of_double = f"plain double gets {words.percent(plain['wrong'], plain['decisions'])} wrong in {words.nanoseconds(plain['ns']['p50'])}"
        if right is plain:
            text.append(f"on {scene} plain double happens to be right, in {words.nanoseconds(plain['ns']['p50'])}")
        elif right is None:
            text.append(f"on {scene} {of_double} and NO method is always right")
        else:
            text.append(f"on {scene} {of_double}, '{name_of(right)}' none in {words.nanoseconds(right['ns']['p50'])}")
    out = "; ".join(text)
    return out[:1].upper() + out[1:] + "." if out else ""


def note_on_forces(rows):
    """The effect of exact decisions on the forces: the worst method with and without that guarantee."""
    text = []
    for promise, word in ((False, "without"), (True, "with")):
        known = [row for row in rows if row["exact"] == promise and "ulps_max" in row["force"]]
        worst = max(known, key=lambda row: row["force"]["relative_max"], default=None)
        if worst:
            text.append(f"the largest relative error of a force {word} guaranteed exact decisions is {worst['force']['relative_max']:.2g} "
                        f"('{name_of(worst)}' on {worst['scene']}: {worst['force']['ulps_max']:.2g} ulps)")
    out = "; ".join(text)
    easy = [row["force"]["relative_max"] for row in rows if row["exact"] and row["kind"] != "adversarial" and "relative_max" in row["force"]]
    if easy:
        out += f"; on easy and common scenes methods with that guarantee stay below {max(easy):.2g}"
    return out[:1].upper() + out[1:] + "." if out else ""


def note_on_search(rows):
    text = []
    for scene in dict.fromkeys(row["scene"] for row in rows):
        mine = [row for row in rows if row["scene"] == scene]
        first, last = (pick(mine, key=lambda row: row["ns"]["p50"]) for pick in (min, max))
        text.append(f"on {scene} '{name_of(first)}' is {words.number(float(format(last['ns']['p50'] / first['ns']['p50'], '.2g')), 2)} times as fast as '{name_of(last)}'")
    wrong = sum(row["wrong"] for row in rows)
    return f"With {'the same answers' if not wrong else f'{wrong} WRONG answers'}, " + "; ".join(text) + "."


def note_on_stages(rows):
    """The share of each scene that each implementation settles in its last stage."""
    text = []
    for implementation in dict.fromkeys(row["implementation"] for row in rows):
        parts = []
        for row in (row for row in rows if row["implementation"] == implementation):
            decided = sum(stage["settled"] for stage in row["stages"])
            last = row["stages"][-1]
            parts.append(f"{words.percent(last['settled'], decided)} of {row['scene']}" + (f" ({words.nanoseconds(last['ns']['p50'])} each)" if "ns" in last else ""))
        text.append(f"The {implementation} implementation needs its last and slowest stage for " + ", ".join(parts))
    return ". ".join(text) + "."


def note_on_effects(effects):
    """Whether an effect that is off is free, and which effect costs most."""
    other = [row["effect"] for row in effects if not row["same_program"] or row["bytes_off"] != row["bytes_absent"]]
    beyond = [row for row in effects if abs(row["off_ratio"] - 1) > 3 * row["off_error"]]
    furthest = max(effects, key=lambda row: abs(row["off_ratio"] - 1))
    text = ("An effect that is off costs nothing: each scene has the same effects and the same bytes for each node as without it"
            if not other else f"NOT free when off: {', '.join(dict.fromkeys(other))}")
    text += (f"; the times differ by at most {100 * abs(furthest['off_ratio'] - 1):.2g} % ({furthest['effect']}, {furthest['implementation']}, "
             f"standard error {100 * furthest['off_error']:.2g} %), {len(beyond)} of {len(effects)} by more than three standard errors")
    fast = [row for row in effects if row["implementation"] == "optimized"]
    if fast:
        most = max(fast, key=lambda row: row["extra_ns"])
        text += f". In the optimized contact {most['effect']} costs most when on, {most['extra_ns']:.3g} ± {most['extra_error']:.2g} ns for each node and cycle"
    return text + ". Bars in the figure: two standard errors."


def figures_of(found, store):
    rows = found["rows"]
    arithmetic = [row for row in rows if row["group"] == "arithmetic"]
    search = [row for row in rows if row["group"] == "search"]
    code = digest(HERE / "accuracy_figures.py", HERE / "curves.py")

    def one(name, title, note, data, draw):
        svg = store.get(f"accuracy-{name}", digest(code, repr(data)), lambda: draw(data))
        return {"svg": svg, "title": title, "note": note}

    out = [one("wrong", "Share of wrong decisions against time for each method",
               note_on_decisions(arithmetic), arithmetic, lambda data: draw_methods(data, "wrong")),
           one("force", "Error of the force against time for each method", note_on_forces(arithmetic), arithmetic, lambda data: draw_methods(data, "force"))]
    if search:
        out.append(one("search", "Time of a decision with the search for candidates", note_on_search(search), search, draw_search))
    return out


def section(found, store):
    """Figures with their notes and tables; None without an accuracy.json."""
    if not isinstance(found, dict) or not found.get("rows"):
        return None
    about = {name: found[name] for name in ("command", "cpu", "compiler", "flags", "flags_optimized", "repeats", "seed", "clock", "commit") if found.get(name) not in (None, "")}
    out = {"about": about, "scenes": found["scenes"], "rows": found["rows"], "figures": figures_of(found, store), "stage_counts": None, "effects": None}
    code = digest(HERE / "accuracy_figures.py", HERE / "curves.py")
    if found["stage_counts"]:
        svg = store.get("accuracy-stage_counts", digest(code, repr(found["stage_counts"])), lambda: draw_stages(found["stage_counts"]))
        out["stage_counts"] = {"svg": svg, "title": "Share of the decisions that each stage settles", "note": note_on_stages(found["stage_counts"]), "rows": found["stage_counts"]}
    if found["effects"]:
        svg = store.get("accuracy-effects", digest(code, repr(found["effects"])), lambda: draw_effects(found["effects"]))
        out["effects"] = {"svg": svg, "title": "What each effect costs on and off", "note": note_on_effects(found["effects"]), "rows": found["effects"]}
    return out
