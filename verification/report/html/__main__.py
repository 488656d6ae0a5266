"""Makes the report, build/report/index.html, from the files that type21 wrote. Started by scripts/report."""

import argparse
import sys
import time
from pathlib import Path

import browser
import check_page
import page
from store import Store
from sources import Sources

ROOT = Path(__file__).resolve().parents[3]


def arguments():
    parser = argparse.ArgumentParser(
        prog="scripts/report",
        description="Make one self-contained page, build/report/index.html, from the results that scripts/verify left: checks, "
        "curves, decisions, departures, costs, traceability. Pictures are drawn again only where their data changed.",
        epilog="exit codes: 0 the page is there (and, with --check or --screenshots, is in order), 1 it cannot be made, 3 it is not in order",
    )
    add = parser.add_argument
    add("--results", type=Path, default=ROOT / "build/report/results.json", help="records of the checks (type21 verify --json)")
    add("--runs", type=Path, default=ROOT / "build/verify", help="folder of the runs (type21 verify --scratch)")
    add("--optimized", type=Path, default=ROOT / "build/verify-optimized", help="the same of --with optimized, drawn beside if there")
    add("--cases", type=Path, default=ROOT / "cases", help="folder of the cases")
    add("--type21", type=Path, default=ROOT / "build/release/type21", help="the program, asked for scenes, departures and decisions")
    add("--out", type=Path, default=ROOT / "build/report/index.html", help="the page")
    add("--jobs", type=int, default=2, help="pictures drawn at a time")
    add("--check", action="store_true", help="make nothing: check the page that is there (links, completeness, no nan)")
    add("--screenshots", type=Path, metavar="DIR", help="make nothing: pictures of the page by Chromium at 1366 and 390 pixels")
    add("--pdf", type=Path, metavar="FILE", help="print the page to a PDF by Chromium as well")
    return parser.parse_args()


def make(options):
    started = time.perf_counter()
    store = Store(options.out.parent / "cache")
    sources = Sources(options)
    page.make(sources, store, options)
    size = options.out.stat().st_size / 1e6
    print(f"report: {store.made} pictures and answers made, {store.kept} unchanged and taken from {store.folder.name}/; "
          f"{size:.1f} MB, {time.perf_counter() - started:.1f} s")


def main():
    options = arguments()
    if options.check:
        return check_page.main(options.out, options.results)
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
