"""The report: everything gathered, pictures drawn where needed, templates filled."""

import os
import platform
import re
from concurrent.futures import ProcessPoolExecutor
from datetime import datetime, timezone
from pathlib import Path

import jinja2
from markupsafe import Markup

import accuracy
import bench
import departures
import hard_cases
import lockstep
import pictures
import sliding
import tally
import words
from sources import read_json
from store import digest

HERE = Path(__file__).resolve().parent
CASE_FAMILIES = (
    ("patch test", "Patch tests", "A patch pressed by a tool: the force on each node and its direction."),
    ("sliding continuity", "Sliding continuity", "Nodes slide from one sub-triangle or segment to the next; the force must not jump."),
    ("friction law", "Friction laws", "The friction coefficient of each law, stick and slip, and the filters of the friction force."),
    ("Pmax limit", "Pmax limits", "A sheet thickens while the contact pressure is limited: force, energy and the limit of the friction force."),
)


def draw_cases(cases, store, options):
    """Pictures by case name; only those whose inputs changed are drawn, in processes of their own."""
    keys = {case.name: pictures.key(case) for case in cases}
    found = {case.name: store.find(f"case-{case.name}", keys[case.name]) for case in cases}
    todo = [case for case in cases if found[case.name] is None]
    if todo:
        print(f"report: drawing {words.plural(len(todo), 'case')}, {options.jobs} at a time", flush=True)
        with ProcessPoolExecutor(max_workers=max(1, options.jobs)) as pool:
            for case, drawn in zip(todo, pool.map(pictures.draw_case, todo, [options.type21] * len(todo), chunksize=2)):
                found[case.name] = store.keep(f"case-{case.name}", keys[case.name], drawn)
    return found


def note_on_curves(case, drawn):
    """What the curves are, and one sentence on their result."""
    if not drawn["curves"]:
        return "No run of this case writes histories."
    runs = drawn["runs"]
    text = f"Lines: run {runs[0]}"
    text += f"; dashed: run {runs[1]} where it differs" if len(runs) > 1 and drawn["other"] else f" (run {runs[1]} looks the same)" if len(runs) > 1 else ""
    text += "; circles: measured" if drawn["measured"] else ""
    text += "; rings: expected values" if drawn["expected"] else ""
    text += "; dotted: tolerance" if drawn["tolerance"] else ""
    histories = [record for record in case.records if record.get("columns")]
    if histories:
        worst = max(histories, key=lambda record: record["difference"] if isinstance(record["difference"], (int, float)) else 0)
        column = max(worst["columns"], key=lambda c: c["scaled"] if isinstance(c["scaled"], (int, float)) else 0)
        text += (f". Largest difference from the measured histories: {words.small(worst['difference'])} of the column's largest value, "
                 f"in {column['column']} at time {words.number(column['time'], 6)} (criterion {worst['id']}, tolerance {words.small(worst['tolerance'])})")
    if drawn["optimized"] is not None:
        text += f". Largest difference of the optimized implementation from the reference: {words.small(drawn['optimized'])}"
    return text + "."


def case_family_figures(groups, store):
    for group in groups:
        points = [(case.name, [(r["kind"], tally.share(r)) for r in case.records if tally.share(r) is not None]) for case in group["cases"]]
        points = [row for row in points if row[1]]
        shares = [part for _, row in points for _, part in row]
        if not shares:
            group["figure"], group["note"] = "", ""
            continue
        key = digest(pictures.CODE, repr(points))
        group["figure"] = store.get(f"family-{group['id']}", key, lambda g=group, p=points: pictures.draw_case_family(p, g["id"]))
        over = sum(part > 1 for part in shares)
        worst = max(((part, name) for name, row in points for _, part in row))
        group["note"] = (f"{words.plural(len(shares), 'criterion', 'criteria')} of {words.plural(len(points), 'case')}: "
                         + ("all hold" if not over else f"{over} FAILED (right of 1)")
                         + f"; the closest one, in {worst[1]}, uses {words.percent(worst[0], 1)} of its tolerance.")


def grouped(cases):
    """The four case families, then the other cases."""
    groups = [{"id": f"family-{name.replace(' ', '-')}", "title": title, "about": about, "cases": [c for c in cases if c.family == name]}
              for name, title, about in CASE_FAMILIES]
    rest = [case for case in cases if case.family not in {name for name, *_ in CASE_FAMILIES}]
    return groups, rest


def not_there(readme):
    """The paragraphs of README.md under "What is not there", without the marks of Markdown; empty without them."""
    text = readme.read_text() if readme.is_file() else ""
    found = re.search(r"^## What is not there\n(.*?)(?=^## |\Z)", text, re.M | re.S)
    if not found:
        return []
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", found[1]).replace("`", "").replace("**", "")
    return [" ".join(paragraph.split()) for paragraph in plain.split("\n\n") if paragraph.strip()]


def machine(sources, runs):
    """The machine of the runs, as their results name it, and that of the report."""
    def values(name, rows):
        return sorted({str(row[name]) for row in rows if row.get(name)})

    rows = [(title, values(name, sources.records)) for title, name in (("version", "version"), ("commit", "commit"), ("compiler", "compiler"), ("processor", "cpu"))]
    rows += [(title, values(name, runs)) for title, name in (("flags", "flags"), ("build", "build_type"))]
    made = datetime.fromtimestamp(sources.options.results.stat().st_mtime, timezone.utc)
    rows.append(("results of", [made.strftime("%Y-%m-%d %H:%M UTC")]))
    rows.append(("report made on", [f"{platform.system()} {platform.machine()}, {words.plural(os.cpu_count() or 1, 'processor')}, Python {platform.python_version()}"]))
    return [(title, found) for title, found in rows if found]


def optimized_runs(cases):
    """run.json of each run of the optimized implementation."""
    found = (read_json(case.optimized_folder / run / "run.json") for case in cases for run in case.runs)
    return [run for run in found if run is not None]


def make(sources, store, options):
    cases = sources.cases
    drawn = draw_cases(cases, store, options)
    groups, rest = grouped(cases)
    case_family_figures(groups, store)
    runs = [run for case in cases for run in case.run_json.values()]
    fast_runs = optimized_runs(cases)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True, undefined=jinja2.StrictUndefined,
                                     trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(number=words.number, small=words.small, picture=words.picture, nanoseconds=words.nanoseconds)
    environment.globals.update(percent=words.percent, plural=words.plural, share=tally.share)
    failed = [record for record in sources.records if record["verdict"] == "failed"]
    rows = departures.table(options.type21, cases)
    speed = bench.section(sources.beside("bench.json"), store)
    text = environment.get_template("report.html.j2").render(
        records=sources.records, cases=cases, rest=rest, groups=groups, drawn=drawn, keys={case.name: pictures.key(case) for case in cases}, not_run=sources.not_run, failed=failed,
        skipped=sum(record["verdict"] not in ("ok", "failed") for record in sources.records),
        kinds=tally.by_kind(sources.records, {(case.name, name) for case in cases for name, criterion in case.criteria.items() if "balance" in criterion}), total=tally.over_runs(runs), fast=tally.over_runs(fast_runs) if fast_runs else None,
        nearest=tally.nearest(sources.records), mutation=tally.mutation(sources.beside("mutation.json")),
        notes={case.name: note_on_curves(case, drawn[case.name]) for case in cases},
        question_families=hard_cases.question_families(options.type21, options.cases / "decisions", store),
        atlas=hard_cases.atlas(options.type21, options.cases / "atlas", store),
        departures=rows, not_reproduced=[row for row in rows if not row["available"]], not_there=not_there(options.cases.parent / "README.md"), accuracy=accuracy.section(sources.beside("accuracy.json"), store),
        bench=speed, lockstep=lockstep.section(sources.beside("lockstep.json"), store),
        sliding=sliding.figure(sources.beside("stability.json"), store),
        trace=sources.beside("traceability.json"), machine=machine(sources, runs),
        style=Markup((HERE / "templates/style.css").read_text()),
        script=Markup((HERE / "templates/report.js").read_text()))
    store.forget_the_rest()
    part = options.out.with_suffix(".part")
    part.write_text(text)
    os.replace(part, options.out)
