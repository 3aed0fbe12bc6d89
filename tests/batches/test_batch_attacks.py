"""Hostile texts as names of students and titles of a whole year: of `batch` and of `grade` every page, table, workbook
and line of the terminal shows them as text."""

from __future__ import annotations

import csv
import io
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
from notes import VARIANTS, static
from openpyxl import load_workbook
from payloads import PAYLOADS
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.intake.writing import csv_bytes

PAYLOADS = {
    **PAYLOADS,
    "command": "+cmd|' /C calc'!A0",
    "sum": '@SUM(1+1)*cmd|"/C calc"!A0',
    "minus": '-2+3+cmd|"/C calc"!A0',
    "break out": 'a",=1+1,"',
    "break out of semicolons": "a;=1+1;-2",
    "wide": "＝1+1",
    "no-break space": "\u00a0=1+1",
    "markup": "[/red][link=http://evil]x[/link]",
    "comment": "--><script>alert(1)</script><!--",
    "style": "</style><script>alert(1)</script>",
    "title": "</title><script>alert(1)</script>",
    "address": "javascript:alert(1)",
    "lines of a log": "Ivanov 100 %  OK",
    "entity": "&lt;script&gt;&#x202e;",
    "long": "ж" * 200,
    "marks": "Z" + "\u0316\u0301" * 14,
    "excel's escape": "_x003D_1+1 _x0009_",
    "byte mark": "\ufeff=1+1",
}
UNSEEN = {  # what no terminal may be told
    "terminal": "\x1b[2J\x1b]0;owned\x07",
    "bidi": "\u202egnp.exe\u2066",
    "line ends": "a\nOK: done\r\n=1+1",
    "tab": "\t=1+1",
    "separators": "a\u2028=1\u2029",
    "zero": "a\u200b\u2060b\u00ad",
}
EVERY = {**PAYLOADS, **UNSEEN}
pytestmark = pytest.mark.exhaustive  # of one variant: test_attacks.py
TAGS = {"script", "img", "foreignobject", "iframe", "object", "embed"}
RUBRIC = "positions: [7]\ntables: {rates_table: {columns: [v_B]}}\n"


def variant(text: str) -> str:
    """The compressor's motion in Russian with the text for everything that names its student."""
    given = (VARIANTS / "compressor.yaml").read_text("utf-8")
    given = given[: given.index("\nloads:")]
    title = given[given.index("title:") : given.index("\nlanguage:")]
    named = "\n".join(f"  {key}: {json.dumps(text)}" for key in ("student", "group", "variant", "topic"))
    return given.replace(title, f"title:\n{named}\n") + "\npositions: {table: 12}\n"


def ids() -> dict[str, str]:
    return {f"s{number:02}": text for number, text in enumerate(EVERY.values())}


@pytest.fixture(scope="module")
def year(tmp_path_factory) -> tuple[Path, str]:
    """The folder of a year, and all that `batch` and `grade` said of it."""
    folder = tmp_path_factory.mktemp("year")
    for name in ("variants", "answers"):
        (folder / name).mkdir()
    for id, text in ids().items():
        (folder / "variants" / f"{id}.yaml").write_text(variant(text), "utf-8", newline="")
        sheet = [["position", "v_B", text[:150], "v_D"], [7, 4.444, text[:150], text[:150]]]
        (folder / "answers" / f"{id}.csv").write_bytes(csv_bytes(sheet, "."))
    rows = [[id, text[:190], f"{text[:100]}@x", text[:150], text[:150]] for id, text in ids().items()]
    (folder / "roster.csv").write_bytes(
        csv_bytes([["id", "name", "email", "canvas_login", "section"], *rows], ".")
    )
    (folder / "rubric.yaml").write_text(RUBRIC, "utf-8")
    return folder, said(folder)


def said(folder: Path) -> str:
    places = [
        str(folder / name) for name in ("variants", "out", "answers", "marks", "rubric.yaml", "roster.csv")
    ]
    variants, out, answers, marks, rubric, roster = places
    batch = ["batch", variants, "-o", out, "--format", "html,csv,json", "--jobs", "1"]
    grade = [
        "grade",
        variants,
        answers,
        "-o",
        marks,
        "--rubric",
        rubric,
        "--roster",
        roster,
        "--lang",
        "en",
        "--jobs",
        "1",
    ]
    done = [CliRunner().invoke(app, command) for command in (batch, grade)]
    for one in done:
        assert one.exception is None or isinstance(one.exception, SystemExit), one.output
    return "".join(one.output for one in done)


AUTHOR = re.compile('<meta name="author" content="[^"<>]*">')  # a name that nothing runs or opens


class Tags(HTMLParser):
    """The elements of a page and what of their attributes could be run."""

    def __init__(self, page: str):
        super().__init__()
        self.found: set[str] = set()
        self.running: set[str] = set()
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.add(tag)
        if AUTHOR.fullmatch(self.get_starttag_text() or ""):
            return
        for key, value in attrs:
            if key.startswith("on") or (value or "").strip().lower().startswith(("javascript:", "data:")):
                self.running.add(f"{tag} {key}={value}")


def test_every_work_is_solved_and_marked(year):
    folder, _ = year
    assert {path.name for path in (folder / "out").iterdir() if path.is_dir()} >= set(ids()) - refused(folder)
    with open(folder / "marks" / "marks.csv", encoding="utf-8-sig", newline="") as stream:
        rows = list(csv.reader(stream))
    assert len(rows) == len(EVERY) + 1


def refused(folder: Path) -> set[str]:
    """Those of whom YAML itself has no text: control characters."""
    return {id for id, text in ids().items() if text in UNSEEN.values()}


def test_nothing_in_a_page_can_be_run(year):
    pages = [*year[0].rglob("*.html")]
    assert len(pages) > 2 * len(PAYLOADS)
    for page in pages:
        text = page.read_text("utf-8")
        # what moves a note on the screen is the program's own: names end neither its script nor its data
        read = Tags(static(text) if page.name == "note.html" else text)
        assert not read.found & TAGS and not read.running, (page, read.running)


def test_no_cell_of_a_table_is_a_formula(year):
    sheets = [*year[0].rglob("*.csv")]
    for sheet in sheets:
        if sheet.parent.name in ("answers", year[0].name):
            continue
        text = sheet.read_text("utf-8-sig")
        for delimiter in ",;\t":
            for row in csv.reader(io.StringIO(text), delimiter=delimiter):
                for cell in row:
                    started = cell.lstrip('" \u00a0\ufeff')[:1]
                    number = re.fullmatch(r"[-+]?[0-9][0-9.,eE+-]*( %)?|[-+]", cell.strip("\"'"))
                    assert number or started not in tuple("=+-@\t＝＋－＠"), (sheet, cell)


def test_no_cell_of_a_workbook_is_a_formula_or_a_link(year):
    books = [*(year[0] / "marks").glob("*.xlsx")]
    assert books
    for book in books:
        for sheet in load_workbook(book):
            cells = [cell for row in sheet.iter_rows() for cell in row]
            assert not [cell.value for cell in cells if cell.data_type == "f" or cell.hyperlink]


def test_the_terminal_and_the_journal_are_told_no_signs_that_steer_them(year):
    folder, output = year
    steering = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
    assert not steering.search(output.replace("\r", "")) and not re.search("^OK: done", output, re.M)
    journal = (folder / "out" / "journal.jsonl").read_text("utf-8")
    assert not steering.search(journal)
    for line in journal.splitlines():
        json.loads(line)


def test_gradebooks_of_other_programs_stay_readable(year):
    for result in (year[0] / "marks" / "gradescope").rglob("results.json"):
        json.loads(result.read_text("utf-8"))
    for name in ("moodle.csv", "canvas.csv"):
        with open(year[0] / "marks" / name, encoding="utf-8-sig", newline="") as stream:
            widths = {len(row) for row in csv.reader(stream)}
        assert len(widths) == 1


TEMPLATES = {  # what a sandbox would not stop, too
    "runs": "PWNED {{ cycler.__init__.__globals__.os.system('touch PWNED') }}",
    "asks for memory": "PWNED {{ 'a' * 10**9 }}{{ '%1000000000d' % 1 }}",
    "asks for time": "PWNED {% for a in range(99999) %}{% for b in range(99999) %}{% endfor %}{% endfor %}",
    "includes": "PWNED {% include '../../etc/passwd' %}",
}


NAME = "{{ 7*7 }}{% include x %}.yaml"


def note_of(folder: Path) -> bytes:
    """The note that `batch` makes in a folder of the variant with a name that is a template."""
    folder.mkdir(exist_ok=True)
    (folder / NAME).write_text(variant("{{ 7*7 }}"), "utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        done = CliRunner().invoke(app, ["batch", NAME, "-o", "out", "--jobs", "1"])
    assert done.exit_code == 0, done.output
    (found,) = (folder / "out").rglob("note.html")
    return found.read_bytes()


@pytest.fixture(scope="module")
def fair(tmp_path_factory) -> bytes:
    return note_of(tmp_path_factory.mktemp("fair"))


@pytest.mark.parametrize("text", TEMPLATES.values(), ids=TEMPLATES)
def test_no_template_is_taken_from_outside(tmp_path, monkeypatch, text, fair):
    """Neither beside the variant or in the working folder, nor by the environment, nor by the name of a file."""
    root = Path(__file__).parents[2] / "templates"
    for template in root.rglob("*.j2"):
        for place in ("templates", "_data/templates", "tmm_report/_data/templates"):
            copy = tmp_path / "foul" / place / template.relative_to(root)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(text, "utf-8")
    for variable in ("TMM_TEMPLATES", "TMM_REPORT_TEMPLATES", "TEMPLATES", "JINJA_PATH", "TMM_REPORT_DATA"):
        monkeypatch.setenv(variable, str(tmp_path / "foul" / "templates"))
    foul = note_of(tmp_path / "foul")
    assert foul == fair and b"{{ 7*7 }}" in foul
    assert not [*tmp_path.rglob("PWNED*")]
