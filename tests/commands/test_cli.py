"""The command line as a user meets it: what it writes, prints and returns."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import subprocess
import sys
from pathlib import Path

import jsonschema
import pytest
from exhaustive import FEW, many
from notes import NAMES, VARIANTS, note
from typer.testing import CliRunner

import tmm_report
from tmm_report import __version__, commands
from tmm_report.cli import app
from tmm_report.commands.whole import LIST
from tmm_report.languages import LANGUAGES
from tmm_report.yamlread import read

COMPRESSOR = VARIANTS / "compressor.yaml"
PACKAGE = Path(tmm_report.__file__).parent
COMMANDS = [command.callback.__name__ for command in app.registered_commands]


def run(*arguments: object, **env: str):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C", **env})


def test_solve_writes_the_note_and_sums_up(tmp_path):
    done = run("solve", COMPRESSOR, "-o", tmp_path / "out", "--format", "html,tex,json,csv", "--lang", "en")
    assert done.exit_code == 0, done.output
    written = {
        path.relative_to(tmp_path / "out").as_posix()
        for path in (tmp_path / "out").rglob("*")
        if path.is_file()
    }
    assert {"note.html", "note.tex", "results.json", "tables/outputs_table.csv"} <= written
    assert not [name for name in written if name.endswith(".part")]
    assert "I(0,1) → II2(2,3) → II2(4,5)" in done.output
    assert re.search(r"graphical method: 0\.0\d+ %", done.output)
    assert re.search(r"lever [\d.]+·10⁻¹[⁰-⁹], power balance [\d.]+·10⁻¹[⁰-⁹]", done.output)
    assert str(tmp_path / "out" / "note.html") in done.output


@pytest.mark.exhaustive
def test_the_folder_is_named_after_the_variant(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("solve", COMPRESSOR, "--format", "json").exit_code == 0
    assert (tmp_path / "compressor-note" / "results.json").is_file()


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", many(["crank_rocker", "compressor"]))
def test_same_variant_same_bytes(name, tmp_path):
    """Rendered here and by the command in another process, which hashes texts in its own way."""
    command = [
        sys.executable,
        "-m",
        "tmm_report",
        "solve",
        str(VARIANTS / f"{name}.yaml"),
        "-o",
        str(tmp_path),
    ]
    subprocess.run(
        [*command, "--format", "html,tex,json,csv", "--depth", "full"], check=True, capture_output=True
    )
    one = {file: text for fmt in ("html", "tex", "json", "csv") for file, text in note(name, fmt).items()}
    two = {path.relative_to(tmp_path).as_posix(): path for path in tmp_path.rglob("*") if path.is_file()}
    del two[LIST]
    assert one.keys() == two.keys() and len(one) > 10
    assert [file for file in one if one[file] != two[file].read_bytes()] == []


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_results_are_strict_json_with_units_and_meanings(name):
    def refuse(constant: str):
        raise AssertionError(constant)

    document = json.loads(note(name, "json", "en")["results.json"], parse_constant=refuse)
    columns = [c for table in document["tables"].values() for c in table["columns"]]
    optional = {"symbol", "symbols"}  # of the column, of its rows
    assert all(c["meaning"] and set(c) - optional == {"key", "unit", "meaning", "values"} for c in columns)
    assert all(len(c["symbols"]) == len(c["values"]) for c in columns if "symbols" in c)
    for table in document["tables"].values():
        assert len({len(c["values"]) for c in table["columns"]}) == 1
        assert len({c["key"] for c in table["columns"]}) == len(table["columns"])


@pytest.mark.exhaustive
def test_csv_repeats_json(tmp_path):
    run("solve", COMPRESSOR, "-o", tmp_path, "--format", "json,csv")
    document = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    text = (tmp_path / "tables" / "rates_table.csv").read_bytes().decode("utf-8-sig")
    rows = list(csv.reader(io.StringIO(text), delimiter=";"))
    columns = document["tables"]["rates_table"]["columns"]
    assert rows[0][2] == "v_A, m/s" and len(rows) == 14
    for i, column in enumerate(columns):
        cells = [float(row[i].replace(",", ".")) for row in rows[1:]]
        assert all(math.isclose(a, b, abs_tol=0) for a, b in zip(cells, column["values"], strict=True))


def test_json_path_is_light():
    code = (
        "import sys; from tmm_report.cli import app\n"
        f"app(['solve', {str(COMPRESSOR)!r}, '--format', 'json', '-o', sys.argv[1]], standalone_mode=False)\n"
        "print(sorted({m.split('.')[0] for m in sys.modules} & {'matplotlib', 'scipy', 'jinja2', 'rich', 'PIL'}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "unused-note"], capture_output=True, text=True, cwd=_temporary()
    )
    assert done.stdout.splitlines()[-1] == "[]", done.stdout + done.stderr


def _temporary() -> str:
    import tempfile

    return tempfile.mkdtemp()


MISTAKES = """\
mechanism:
  frame: {O: [0, 0]}
  guides:
    x: {through: Q}
  links:
    1: {points: {O: 0, A: 100 kg}}
    2: {points: {A: 0, B: 300 mm}, mas: 1}
    3: {points: [B], slides: x}
  driver: {link: 1, speed: 1200 rpm, rotation: clockwise}
  assembly: {B: right}
loads:
  forces:
    - {at: Z, direction: left, constant: 5}
"""


def test_all_mistakes_at_once(tmp_path):
    path = tmp_path / "bad.yaml"
    path.write_text(MISTAKES, encoding="utf-8")
    done = run("solve", path, "-o", tmp_path / "out")
    lines = done.output.strip().splitlines()
    assert done.exit_code == 2 and not (tmp_path / "out").exists()
    places = [re.match(rf"{re.escape(str(path))}:(\d+):(\d+): (\S+):", line) for line in lines]
    assert all(places) and [int(m[1]) for m in places] == [4, 6, 7, 13]  # type: ignore[index]
    assert "did you mean mass?" in done.output and "kg" in lines[1] and "mm" in lines[1]


@pytest.mark.parametrize(
    "change, at, sentence",
    [
        (
            {"  assembly: {B: right, D: left}\n": "  assembly: {B: right}\n"},
            "  assembly:",
            "II2\\(4,5\\).*two ways",
        ),
        ({"    5: {points: [D], slides: x,": "    5: {points: [D],"}, "  links:", "W = .* = 3.*must be 1"),
        (
            {"v_A: 12.566, v_B: 0,": "v_Q: 12.566, v_B: 0,"},
            "  6: {v_Q",
            "called v_Q; the nearest: .*v_A",
        ),
    ],
)
def test_mistakes_found_in_solving_have_their_line(tmp_path, change, at, sentence):
    text = COMPRESSOR.read_text(encoding="utf-8")
    for old, new in change.items():
        assert text.count(old) == 1
        text = text.replace(old, new)
    path = tmp_path / "changed.yaml"
    path.write_text(text, encoding="utf-8")
    done = run("solve", path, "-o", tmp_path / "out", "--lang", "en")
    assert done.exit_code == 2 and not (tmp_path / "out").exists()
    found = re.match(rf"{re.escape(str(path))}:(\d+):\d+: (.*)", done.output)
    assert found, done.output
    assert re.search(sentence, found[2]), done.output
    line = next(i for i, row in enumerate(text.splitlines(), 1) if row.startswith(at))
    assert int(found[1]) == line, done.output


def test_a_broken_driver_does_not_hide_a_missing_link(tmp_path):
    path = tmp_path / "bad.yaml"
    text = MISTAKES.replace("{link: 1, speed: 1200 rpm,", "{link: 9, period: -1 s,")
    path.write_text(text, encoding="utf-8")
    output = run("solve", path).output
    assert "mechanism.driver.link: there is no link 9" in output
    assert "mechanism.driver.period: -1 s is negative" in output


def test_missing_file_and_bad_options(tmp_path):
    assert run("solve", tmp_path / "none.yaml").exit_code == 2
    assert run("solve", tmp_path).exit_code == 2
    done = run("solve", COMPRESSOR, "--format", "odt", "-o", tmp_path / "out")
    assert done.exit_code == 2 and "html, tex, json, csv" in done.output
    assert run("solve", COMPRESSOR, "--lang", "de").exit_code == 2
    assert not (tmp_path / "out").exists()


@pytest.mark.exhaustive
def test_output_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("mine")
    done = run("solve", COMPRESSOR, "-o", tmp_path / "file", "--format", "json")
    assert done.exit_code == 2 and (tmp_path / "file").read_text() == "mine"
    assert "Traceback" not in done.output


@pytest.mark.exhaustive
def test_what_is_in_the_folder_stays(tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    run("solve", COMPRESSOR, "-o", tmp_path, "--format", "json")
    run("solve", COMPRESSOR, "-o", tmp_path, "--format", "json")
    assert (tmp_path / "mine.txt").read_text() == "mine"
    assert sorted(path.name for path in tmp_path.iterdir()) == [LIST, "mine.txt", "results.json"]


def test_messages_in_the_users_language(tmp_path):
    path = tmp_path / "bad.yaml"
    path.write_text(MISTAKES, encoding="utf-8")
    english, russian = run("solve", path), run("solve", path, LANG="ru_RU.UTF-8", LC_ALL="")
    assert re.search("[а-я]{4}", russian.output) and not re.search("[а-я]{4}", english.output)
    assert not re.search(r": [a-z]+ [a-z]+ [a-z]+", russian.output), russian.output


@pytest.mark.exhaustive
@pytest.mark.parametrize("names", many([FEW, NAMES]))
def test_schema_accepts_the_variants_and_refuses_unknown_keys(names):
    done = run("schema")
    schema = json.loads(done.output)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for name in names:
        data = read(VARIANTS / f"{name}.yaml").data
        assert list(validator.iter_errors(data)) == []
        assert list(validator.iter_errors({**data, "surplus": 1}))


@pytest.mark.exhaustive
@pytest.mark.parametrize("language", LANGUAGES)
def test_new_variant_solves(tmp_path, language):
    path = tmp_path / "my.yaml"
    assert run("new", path, "--lang", language).exit_code == 0
    assert run("new", path).exit_code == 2  # never overwritten
    done = run("solve", path, "-o", tmp_path / "out", "--format", "html,json")
    assert done.exit_code == 0, done.output
    assert f'lang="{language}"' in (tmp_path / "out" / "note.html").read_text(encoding="utf-8")


@pytest.mark.exhaustive
def test_every_command_and_option_has_help():
    assert run("--version").output.strip() == f"tmm-report {__version__}"
    top = run("--help").output
    for command in COMMANDS:
        assert re.search(rf"{command}\s+\w+", top)
        text = run(command, "--help").output
        for option in re.findall(r"^\s+(--[\w-]+|-o)", text, re.M):
            assert re.search(rf"{option}\b.*\s{{2,}}\S+", text), (command, option)


@pytest.mark.exhaustive
def test_open_shows_the_note(tmp_path, monkeypatch):
    shown = []
    monkeypatch.setattr("webbrowser.open", shown.append)
    assert (
        run(
            "solve", VARIANTS / "crank_rocker.yaml", "-o", tmp_path / "out", "--format", "json", "--open"
        ).exit_code
        == 0
    )
    assert shown == [(tmp_path / "out" / "note.html").resolve().as_uri()]
    assert (Path(tmp_path) / "out" / "note.html").is_file()


# ---------------------------------------------------------------- the rooms


class Heard:
    """A command's talk, collected."""

    def __init__(self):
        self.languages, self.stages, self.told, self.warned = [], [], [], []

    def speak(self, language):
        self.languages.append(language)

    def stage(self, doing):
        self.stages.append(str(doing))

    def tell(self, line):
        self.told.append(str(line))

    def warn(self, line):
        self.warned.append(str(line))


@pytest.mark.exhaustive
def test_a_command_talks_and_prints_nothing(tmp_path, capsys):
    from tmm_report.commands import solve

    heard = Heard()
    assert solve.run(COMPRESSOR, tmp_path / "out", "json,csv", None, heard)
    assert heard.languages == ["ru"] and heard.stages == ["writing json", "writing csv"]
    assert heard.told[0] == "I(0,1) → II2(2,3) → II2(4,5)" and heard.warned == []
    assert heard.told[-1] == f"written: {tmp_path / 'out' / 'results.json'}, {tmp_path / 'out' / 'tables'}"
    assert capsys.readouterr() == ("", "")


def test_every_command_has_a_room():
    assert COMMANDS
    rooms = PACKAGE / "commands"
    assert [
        n for n in COMMANDS if not (rooms / f"{n}.py").is_file() and not (rooms / n / "run.py").is_file()
    ] == []
    assert commands.__doc__


@pytest.mark.exhaustive
def test_only_the_command_line_prints_and_exits():
    spoken = re.compile(r"\bprint\(|typer|\bsys\.(exit|stdout|stderr)|SystemExit")
    found = {
        f"{file.relative_to(PACKAGE)}: {line.strip()}"
        for file in PACKAGE.rglob("*.py")
        for line in file.read_text("utf-8").splitlines()
        if spoken.search(line) and file.name not in ("cli.py", "terminal.py")
    }
    assert found == set()


def test_the_command_line_alone_loads_nothing_heavy():
    program = (
        "import sys, tmm_report.cli; print(*sorted(m for m in sys.modules if m.startswith('tmm_report')))"
    )
    done = subprocess.run([sys.executable, "-c", program + "\nassert 'numpy' not in sys.modules"],
                          capture_output=True, text=True, check=True)  # fmt: skip
    rooms = [
        "tmm_report",
        *(f"tmm_report.{name}" for name in ("cli", "languages", "problems", "records", "terminal")),
    ]
    assert done.stdout.split() == rooms


@pytest.mark.exhaustive
def test_a_file_loads_only_the_gear_rooms_that_it_has(tmp_path):
    program = (
        "import sys; from tmm_report.cli import main\n"
        "try: main()\nexcept SystemExit: pass\n"
        "print(*sorted(m.split('.')[-2] for m in sys.modules if m.startswith('tmm_report.chapters.')\n"
        "    and m.endswith('.block')), 'plugins', __import__('os').environ['PYDANTIC_DISABLE_PLUGINS'])"
    )
    file = VARIANTS / "hoist_drive.yaml"
    arguments = ["solve", str(file), "--format", "json", "-o", str(tmp_path)]
    done = subprocess.run(
        [sys.executable, "-c", program, *arguments], capture_output=True, text=True, check=True
    )
    loaded = done.stdout.splitlines()[-1].split()
    assert "drive" in loaded and "eccentric" not in loaded
    assert loaded[-1] in ("__all__", "1", "true")


def test_what_is_being_done_is_shown_on_a_terminal_and_wiped(monkeypatch, capsys):
    from tmm_report.problems import Message
    from tmm_report.terminal import Console

    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    console = Console("en")
    console.stage(Message("solving"))
    assert console._timer.is_alive() and capsys.readouterr().err == ""
    console._show()
    console.stage(Message("writing %(format)s", {"format": "html"}))
    console.tell("done\x1b[31m")
    assert not console._shown and console._timer is None
    shown = capsys.readouterr()
    assert [part.strip() for part in shown.err.split("\r")] == ["", "solving…", "writing html…", "", ""]
    assert shown.out == "done\N{REPLACEMENT CHARACTER}[31m\n"
