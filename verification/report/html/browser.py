"""The report as Chromium shows it: pictures at laptop and phone width, whether it fits, a PDF."""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from check_report import SECTIONS

WIDTHS = {"laptop": (1366, 900), "phone": (390, 844)}
SKIPPED = 77  # what ctest takes for a skipped test

# Run in the report: opens every sheet, and says how wide it is and what sticks out of it.
PROBE = """
<script>
addEventListener("load", () => {
  const answer = {};
  for (const open of [false, true]) {
    if (open) for (const sheet of document.querySelectorAll("details")) sheet.open = true;
    const wide = document.documentElement.scrollWidth;
    const out = [...document.querySelectorAll("main *")].filter(e => !e.closest(".scroll") && e.getBoundingClientRect().right > innerWidth + 1);
    const cut = [...document.querySelectorAll(".scroll")].filter(e => e.scrollWidth > e.clientWidth + 1);
    answer[open ? "open" : "closed"] = {scrollWidth: wide, innerWidth, cut: cut.slice(0, 5).map(e => e.textContent.trim().slice(0, 40)), sticking: out.slice(0, 5).map(e => e.tagName + "." + e.className + " " + e.textContent.slice(0, 40))};
  }
  answer.sections = NAMES.filter(name => document.getElementById(name)?.getBoundingClientRect().height > 20);
  answer.broken = [...document.images].filter(i => i.complete && !i.naturalWidth).map(i => i.alt);
  document.body.dataset.answer = JSON.stringify(answer);
});
</script>
"""


def find_chromium():
    return next((path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None)


def chromium(*words, timeout=240):
    with tempfile.TemporaryDirectory() as profile:
        command = [find_chromium(), "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
                   "--disable-background-networking", "--no-first-run", f"--user-data-dir={profile}", *words]
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout)
    if done.returncode != 0:
        raise RuntimeError(f"Chromium: exit code {done.returncode}: {done.stderr.strip()[-400:]}")
    return done.stdout


def framed(report, width, height, folder):
    """An HTML file that holds the report in a frame of this width: a window of Chromium cannot be as narrow as a phone."""
    probed = folder / "probed.html"
    names = f"<script>const NAMES = {json.dumps(SECTIONS)};</script>"
    probed.write_text(report.read_text().replace("<head>", "<head>" + names + PROBE, 1).replace('loading="lazy"', 'loading="eager"'))
    outer = folder / f"frame_{width}.html"
    outer.write_text(f"<!DOCTYPE html><body style='margin:0'><iframe id=f src='probed.html' width={width} height={height} style='border:0'></iframe>"
                     "<script>const copy = () => { const a = f.contentDocument?.body?.dataset.answer; "
                     "if (a) document.body.dataset.answer = a; else setTimeout(copy, 50); }; onload = copy;</script>")
    return outer


def judge(name, width, report, folder):
    """What is wrong at one width."""
    outer = framed(report, width, 900, folder)
    dom = chromium("--allow-file-access-from-files", "--virtual-time-budget=20000", f"--window-size={max(width, 600)},900", "--dump-dom", outer.as_uri())
    if 'data-answer="' not in dom:
        return [f"{name}: the report did not answer"]
    answer = json.loads(dom.split('data-answer="')[1].split('"')[0].replace("&quot;", '"').replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"))
    out = []
    for state in ("closed", "open"):
        seen = answer[state]
        if seen["innerWidth"] != width:
            out.append(f"{name}: shown at {seen['innerWidth']} pixels, not {width}")
        if seen["scrollWidth"] > seen["innerWidth"]:
            out.append(f"{name}, sheets {state}: {seen['scrollWidth']} pixels wide in {seen['innerWidth']}: {'; '.join(seen['sticking'])}")
        if name == "laptop" and seen["cut"]:  # a phone may scroll sideways, paper and a laptop may not have to
            out.append(f"{name}, sheets {state}: wider than the page: {'; '.join(seen['cut'])}")
    out += [f"{name}: the section '{section}' is missing or empty" for section in SECTIONS if section not in answer["sections"]]
    out += [f"{name}: the picture '{alt}' is not shown" for alt in answer["broken"]]
    return out


def look(report, out_folder):
    """Screenshots at both widths; 0: everything fits, 3: not, 77: there is no Chromium."""
    if find_chromium() is None:
        print("skipped: Chromium is not there (Debian: apt-get install chromium)")
        return SKIPPED
    if not report.is_file():
        print(f"error: {report} is missing: scripts/report makes it", file=sys.stderr)
        return 1
    out_folder.mkdir(parents=True, exist_ok=True)
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        for name, (width, height) in WIDTHS.items():
            complaints += judge(name, width, report, Path(folder))
            outer = framed(report, width, height, Path(folder))
            chromium("--allow-file-access-from-files", "--virtual-time-budget=8000", f"--window-size={width},{height}",
                     f"--screenshot={out_folder / f'{name}.png'}", outer.as_uri())
    for line in complaints:
        print(f"error: {line}", file=sys.stderr)
    print(f"report: {report.name} at {', '.join(f'{width} ({name})' for name, (width, _) in WIDTHS.items())} pixels: "
          f"{'it fits, with all sections' if not complaints else f'{len(complaints)} complaints'}; pictures in {out_folder}")
    return 3 if complaints else 0


def print_pdf(report, out):
    if find_chromium() is None:
        raise RuntimeError("a PDF needs Chromium (Debian: apt-get install chromium)")
    out.parent.mkdir(parents=True, exist_ok=True)
    # All sheets open: the report does that for the address #print.
    chromium("--virtual-time-budget=60000", "--no-pdf-header-footer", f"--print-to-pdf={out}", report.resolve().as_uri() + "#print", timeout=600)
    if not out.is_file():
        raise RuntimeError(f"{out} was not made")
    print(f"report: {out}, {out.stat().st_size / 1e6:.1f} MB")
