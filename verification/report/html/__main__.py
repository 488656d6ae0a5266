"""Makes the report, build/report/index.html, from the files that type21 wrote. Started by scripts/report."""

import argparse
import sys
import time
from pathlib import Path

import browser
import check_report
import report
from store import Store
from sources import Sources

ROOT = Path(__file__).resolve().parents[3]


def arguments():
    parser = argparse.ArgumentParser(
        prog="scripts/report",
        description="Make the report, one self-contained HTML file, from the results that scripts/verify left: criteria, "
        "curves, decisions, departures, costs, traceability. Pictures are drawn again only where their data changed.",
        epilog="exit codes: 0 the report is made (with --check or --screenshots: it is in order), 1 it cannot be made, 3 it is not in order",
    )
    add = parser.add_argument
    add("--results", type=Path, default=ROOT / "build/report/results.json", help="records of the criteria (type21 verify --json); default: build/report/results.json")
    add("--runs", type=Path, default=ROOT / "build/verify", help="folder of the runs (type21 verify --scratch); default: build/verify")
    add("--optimized", type=Path, default=ROOT / "build/verify-optimized", help="folder of the runs of the optimized implementation, drawn as well if it is there; default: build/verify-optimized")
    add("--cases", type=Path, default=ROOT / "cases", help="folder of the cases; default: cases")
    add("--type21", type=Path, default=ROOT / "build/release/type21", help="the program, which is asked for scenes, departures and decisions; default: build/release/type21")
    add("--out", type=Path, default=ROOT / "build/report/index.html", help="the file to make; default: build/report/index.html")
    add("--jobs", type=int, default=2, help="number of pictures drawn at a time; default: 2")
    add("--check", action="store_true", help="make nothing; check the report that is there: links, completeness, no nan, every number as in the results, every picture of the present files")
    add("--screenshots", type=Path, metavar="DIR", help="make nothing; let Chromium take pictures of the report at widths of 1366 and 390 pixels, and check that it fits")
    add("--pdf", type=Path, metavar="FILE", help="also let Chromium print the report to this PDF")
    return parser.parse_args()


def make(options):
    started = time.perf_counter()
    store = Store(options.out.parent / "cache")
    sources = Sources(options)
    report.make(sources, store, options)
    size = options.out.stat().st_size / 1e6
    print(f"report: {store.made} pictures and answers made, {store.kept} unchanged and taken from {store.folder.name}/; "
          f"{size:.1f} MB, {time.perf_counter() - started:.1f} s")


def main():
    options = arguments()
    if options.check:
        return check_report.main(options)
    if options.screenshots:
        return browser.look(options.out, options.screenshots)
    try:
        make(options)
        if options.pdf:
            browser.print_pdf(options.out, options.pdf)
    except (OSError, ValueError, RuntimeError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
