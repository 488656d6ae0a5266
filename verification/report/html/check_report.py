"""Whether a report is complete and says what the results say: links lead somewhere, nothing comes from outside, no number is nan,
every case has its sheet, every number of a sheet is that of its record, every picture was drawn from the files that are there."""

import json
import re
import sys
from html import unescape
from html.parser import HTMLParser
from urllib.parse import unquote
from xml.etree import ElementTree

import pictures
import words
from sources import Sources

SECTIONS = ("verdict", "families", "cases", "hard-cases", "departures", "accuracy", "speed", "lockstep", "traceability", "machine")
LOADS = {"img": "src", "script": "src", "link": "href", "iframe": "src", "object": "data", "source": "src", "video": "src", "audio": "src", "use": "href"}
VOID = {"meta", "img", "br", "hr", "input", "link", "source", "col"}


class ReportParser(HTMLParser):
    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.ids, self.links, self.complaints, self.open, self.words = [], [], [], [], []
        self.feed(text)
        self.close()
        if self.open:
            self.complaints.append(f"<{self.open[-1]}> is not closed")

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in values:
            self.ids.append(values["id"])
        if tag == "a":
            self.links.append(values.get("href") or "")
        source = values.get(LOADS.get(tag, ""), "")
        if source and not source.startswith("data:"):
            self.complaints.append(f"<{tag}> loads {source[:80]} from outside")
        if tag == "img":
            if not values.get("alt"):
                self.complaints.append(f"a picture near '{' '.join(self.words[-3:])}' has no alt text")
            try:
                ElementTree.fromstring(unquote(source.partition(",")[2]))
            except ElementTree.ParseError as error:
                self.complaints.append(f"the picture '{values.get('alt')}' is no SVG: {error}")
            if re.search(r"\b(nan|inf)\b", source, re.I):
                self.complaints.append(f"the picture '{values.get('alt')}' has a nan or inf")

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.complaints.append(f"</{tag}> at line {self.getpos()[0]} closes nothing")

    def handle_data(self, data):
        if self.open and self.open[-1] == "style" and re.search(r"@import|url\(\s*['\"]?(?!data:|#)", data):
            self.complaints.append("the style sheet loads something from outside")
        if self.open and self.open[-1] not in ("style", "script") and data.strip():
            self.words.append(data.strip())


def complaints_of(text, records):
    report = ReportParser(text)
    out = list(report.complaints)
    ids = set(report.ids)
    out += [f"the id '{name}' occurs twice" for name in sorted(ids) if report.ids.count(name) > 1]
    for link in report.links:
        if not link.startswith("#"):
            out.append(f"the link '{link}' leads outside")
        elif link[1:] not in ids:
            out.append(f"the link '{link}' leads nowhere")
    out += [f"the section '{name}' is missing" for name in SECTIONS if name not in ids]
    out += [f"the case '{name}' has no sheet" for name in sorted({record["case"] for record in records}) if f"case-{name}" not in ids]
    shown = set(report.words)
    for record in records:
        if record["id"] not in shown:
            out.append(f"the criterion '{record['id']}' of {record['case']} is not shown")
    for word in report.words:
        # Numbers that are none; a case or a test may have the letters in its name.
        if re.search(r"(?<![\w.])[-−+]?(nan|inf)(?![\w.])", word, re.I) or "Undefined" in word or "{{" in word:
            out.append(f"the text '{word[:80]}' has a nan or an unfilled place")
    return out


def sheets_of(text):
    """{case: HTML of its sheet}."""
    parts = re.split(r'<details class="sheet" id="case-([^"]+)"', text)
    return {name: re.split(r"</section>", part)[0] for name, part in zip(parts[1::2], parts[2::2])}


def cells_of(sheet):
    """{criterion: its cells as text} of the table of a sheet."""
    table = sheet.split('<table class="criteria">')[-1].split("</table>")[0]
    rows = [[unescape(re.sub(r"<[^>]*>", "", cell)).strip() for cell in re.findall(r"<td[^>]*>(.*?)</td>", row, re.S)] for row in re.findall(r"<tr>(.*?)</tr>", table, re.S)]
    return {row[0]: row[1:] for row in rows if len(row) == 9}


def shown_of(record):
    """What a sheet must show of a record: kind, run, expected, got, unit, difference, tolerance, verdict."""
    got = words.small if isinstance(record["expected"], str) or record["expected"] == 0 else words.number
    verdict = {"ok": "holds", "failed": "FAILED"}.get(record["verdict"], record["verdict"])
    return [record["kind"], record["run"], words.number(record["expected"]), got(record["got"]), record["unit"], words.small(record["difference"]),
            words.small(record["tolerance"]), verdict]


def disagreements(text, records, cases):
    """Sheets that show other numbers than the records, or pictures of other files than those that are there."""
    sheets = sheets_of(text)
    tables = {name: cells_of(sheet) for name, sheet in sheets.items()}
    out = []
    for record in records:
        shown, wanted = tables.get(record["case"], {}).get(record["id"]), shown_of(record)
        if shown is not None and [" ".join(cell.split()) for cell in shown] != [" ".join(str(cell).split()) for cell in wanted]:
            out.append(f"the criterion '{record['id']}' of {record['case']} shows {' | '.join(shown)}, and its record says {' | '.join(map(str, wanted))}")
    for case in cases:
        sheet = sheets.get(case.name, "")
        if f'data-of="{pictures.key(case)}"' not in sheet.split(">")[0]:
            out.append(f"the pictures of {case.name} were drawn from other files than those that are there")
        # Scene and histories; a deck that must be refused has neither, and its caption says so.
        if sheet.count("<img") < 2 and "is refused" not in sheet and "writes histories" not in sheet:
            out.append(f"a picture of {case.name} is missing")
    failed = sum(record["verdict"] == "failed" for record in records)
    held = sum(record["verdict"] == "ok" for record in records)
    headline = f"{words.number(failed)} of {words.plural(len(records), 'criterion', 'criteria')} failed" if failed else f"{words.plural(held + failed, 'criterion', 'criteria')}: all hold"
    if headline not in text:
        out.append(f"the headline is not '{headline}'")
    return out


def main(options):
    report, results = options.out, options.results
    if not report.is_file() or not results.is_file():
        print(f"error: {report if not report.is_file() else results} is missing", file=sys.stderr)
        return 1
    text, records = report.read_text(), json.loads(results.read_text())
    found = complaints_of(text, records) + disagreements(text, records, Sources(options).cases)
    for line in found[:40]:
        print(f"error: {report.name}: {line}", file=sys.stderr)
    print(f"report: {report}: {'in order' if not found else f'{len(found)} complaints'}")
    return 3 if found else 0
