"""What the terminal shows: a short table, in colour where it is a terminal; quiet; help in the user's language."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from conftest import solved
from exhaustive import many
from notes import NAMES, VARIANTS
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands.solve import summary
from tmm_report.commands.talk import in_columns
from tmm_report.i18n import Translator
from tmm_report.interactive.brief import rows
from tmm_report.languages import SIGNS
from tmm_report.problems import Message
from tmm_report.quantity.text import Amount, Typed, equalities, printed
from tmm_report.results import tables, values
from tmm_report.terminal import Console

SHAPER = VARIANTS / "shaper.yaml"


def run(*arguments: object, **env: str):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C", **env})


def test_the_table_says_what_a_student_looks_for(tmp_path):
    done = run("solve", SHAPER, "-o", tmp_path, "--format", "json", "--lang", "en")
    assert re.search(r"^stroke of slider D +H_D +0\.396 +m$", done.output, re.M)
    assert re.search(r"^time ratio of the strokes of D +K_D +1\.6281$", done.output, re.M)
    assert re.search(r"^greatest velocity of D by size +V_D +2\.4568 m/s$", done.output, re.M)
    assert re.search(r"^greatest balancing moment by size M_bal 274\.56 N·m$", done.output, re.M)


def test_the_table_is_in_columns():
    made = in_columns(rows(solved("compressor"), Translator("ru")))
    assert len({tuple(map(len, row.cells)) for row in made}) == 1 and len(made) > 5
    assert [" ".join(row.cells).rstrip() for row in made] == made


@pytest.mark.parametrize(
    ("terminal", "env", "coloured"),
    [
        (True, {}, True),
        (True, {"NO_COLOR": "1"}, False),
        (True, {"TERM": "dumb"}, False),
        (False, {}, False),
    ],
)
def test_colour_is_for_a_terminal_that_wants_it(monkeypatch, capsys, terminal, env, coloured):
    for name in ("NO_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in env.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.stdout.isatty", lambda: terminal)
    painted: list[str] = []
    monkeypatch.setattr("tmm_report.terminal.typer.echo", lambda text, **_: painted.append(text))
    (row,) = in_columns([("stroke", "H_D", "0.396", "m")])
    Console("en").tell(row)
    assert ("\x1b[" in painted[0]) is coloured
    assert re.sub(r"\x1b\[[\d;]*m", "", painted[0]).rstrip() == "stroke H_D 0.396 m"


@pytest.mark.parametrize(
    "hostile", ["\x1b[2J", "\x1b]0;title\x07", "a\rb", "a\nb", "\u202etxt", "\x9b31m", "\x00"]
)
def test_a_hostile_name_breaks_out_of_no_cell(monkeypatch, hostile):
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("NO_COLOR", raising=False)
    shown: list[str] = []
    monkeypatch.setattr("tmm_report.terminal.typer.echo", lambda text, **_: shown.append(text))
    (row,) = in_columns([(hostile, hostile, hostile, hostile)])
    Console("en").tell(row)
    left = re.sub(r"\x1b\[(0|1|2|36)m", "", shown[0])
    assert left.isprintable() and "\N{REPLACEMENT CHARACTER}" in left


def test_quiet_says_only_what_is_wrong(tmp_path):
    done = run("solve", SHAPER, "-o", tmp_path / "a", "--format", "json", "--quiet")
    assert done.exit_code == 0 and done.output == "" and (tmp_path / "a" / "results.json").is_file()
    assert run("new", tmp_path / "n.yaml", "--quiet").output == ""
    (tmp_path / "bad.yaml").write_text("mechanism: {}\n", encoding="utf-8")
    done = run("solve", tmp_path / "bad.yaml", "-o", tmp_path / "b", "--quiet")
    assert done.exit_code == 2 and "bad.yaml" in done.output


def commands() -> list[str]:
    return [command.callback.__name__ for command in app.registered_commands]


def test_help_is_in_the_language_of_the_system():
    """All of it: what is left in Latin letters are names of commands, files, formats and programs."""
    russian = {"LANG": "ru_RU.UTF-8", "LC_ALL": ""}
    for arguments in (["--help"], *([name, "--help"] for name in commands())):
        text, english = run(*arguments, **russian).output, run(*arguments).output
        assert text.startswith("Вызов: ") and english.startswith("Usage: "), text
        assert "Показать эту справку и выйти." in text and "Show this message" in english
        told = [line for line in re.findall(r" {2,}(\S.*)$", text, re.M) if not line.startswith(("-", "<"))]
        foreign = [line for line in told if len(re.findall(r"\b[a-z]{3,} [a-z]{3,} [a-z]{3,}\b", line))]
        assert foreign == [], arguments
        assert not re.search(r"OPTIONS|COMMAND|<[a-z]", text), text
        assert not re.search("[а-я]", english)
    assert "Команды 'nope' нет" in run("nope", **russian).output


@pytest.mark.parametrize(
    ("words", "english", "russian"),
    [
        (["solv"], "Did you mean 'solve'?", "Команды 'solv' нет; может быть, 'solve'?"),
        (["solve", "--opn"], "No such option: --opn (Possible", "ключа --opn нет (может быть, --open"),
        (["solve"], "Missing argument 'variant'.", "не указано 'variant'."),
        (["solve", "a", "b"], "unexpected extra argument", "лишнее в команде: b"),
        (["solve", "a", "--lang"], "requires an argument", "ключ '--lang' требует значения."),
        (
            ["batch", "a", "-o", "b", "--jobs", "x"],
            "valid integer",
            "неверное значение '--jobs': нужно целое число",
        ),
    ],
)
def test_a_wrong_command_line_is_told_in_the_language_of_the_system(words, english, russian):
    """What typer itself says, whose words are found in it here: another version of it may word them otherwise."""
    known, told = run(*words), run(*words, LANG="ru_RU.UTF-8", LC_ALL="")
    assert known.exit_code == told.exit_code == 2
    assert "Error: " in known.output and english in known.output and not re.search("[а-я]", known.output)
    assert f"Ошибка: {russian}" in told.output
    assert ("Usage: " in known.output) == ("Справка: " in told.output) == ("Вызов: " in told.output)
    assert not re.search(r"Error|Try|Usage", told.output)


def test_help_loads_no_translations_for_who_solves():
    program = (
        "import sys; from tmm_report.cli import app\n"
        "try: app(['solve', '--help'], standalone_mode=False)\nfinally: print('tmm_report.i18n' in sys.modules)"
    )

    def loaded(language: str) -> str:
        env = os.environ | {"LANG": language, "LC_ALL": language}
        done = subprocess.run(
            [sys.executable, "-c", program], env=env, capture_output=True, text=True, check=True
        )
        return done.stdout.splitlines()[-1]

    assert (loaded("C"), loaded("ru_RU.UTF-8")) == ("False", "True")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_is_told_how_to_complete(shell):
    program = "import sys; sys.argv = ['tmm-report']; from tmm_report.cli import main; main()"
    env = os.environ | {"_TMM_REPORT_COMPLETE": f"source_{shell}"}
    done = subprocess.run([sys.executable, "-c", program], env=env, capture_output=True, text=True)
    assert f"complete_{shell}" in done.stdout and "tmm-report" in done.stdout


@pytest.mark.parametrize(
    ("words", "found"),
    [("tmm-report so", ["solve"]), ("tmm-report solve --wa", ["--watch"]), ("tmm-report zz", [])],
)
def test_words_are_completed(words, found):
    program = "import sys; sys.argv = ['tmm-report']; from tmm_report.cli import main; main()"
    asked = {
        "_TMM_REPORT_COMPLETE": "complete_bash",
        "COMP_WORDS": words,
        "COMP_CWORD": str(words.count(" ")),
    }
    done = subprocess.run(
        [sys.executable, "-c", program], env=os.environ | asked, capture_output=True, text=True
    )
    assert done.stdout.split() == found


FIRST_SOUGHT = {  # variant -> (letter, table or values, column or key, row, factor to the printed unit)
    "descent_brake": ("ω_h", "values", "governor_brake_held", 0, 1),
    "engine_balance": ("M_max", "engine_greatest", "after", 1, 1),
    "function_generator": ("a", "values", "synthesis_crank", 0, 1000),
    "jack_and_belt": ("T_1", "contacts_4", "T_1", 0, 1),
    "machine_train": ("η", "values", "eta_whole", 0, 1),
}


@pytest.mark.parametrize("name", FIRST_SOUGHT)
def test_what_is_looked_for_first_stands_in_the_results(name):
    """The other way: by the tables and values of results.json."""
    letter, where, key, row, factor = FIRST_SOUGHT[name]
    results = solved(name)
    if where == "values":
        right = next(value.value for value in values(results) if value.key == key)
    else:
        (table,) = (one for one in tables(results) if one.name == where)
        right = next(column.values[row] for column in table.columns if column.quantity.key == key)
    printed = [float(text) for _, symbol, text, _ in rows(results, Translator("en")) if symbol == letter]
    assert printed and printed[0] == pytest.approx(right * factor, rel=1e-4)


@pytest.mark.parametrize("name", many(NAMES, 8))
def test_every_ready_variant_says_something_first(name):
    found = rows(solved(name), Translator("ru"))
    assert 1 <= len(found) <= 20
    assert len({meaning for meaning, *_ in found}) == len(found)
    assert not [one for one in found if re.search(r"\b(pair|bal|max|min)\b", f"{one[0]} {one[1]}")]


SAID = [
    "compressor", "shaper_synthesis", "governor_spring", "hoist_differential", "valve_cam", "rotor",
    "forging_machine_wear",
]  # fmt: skip


def sentences(name: str, tr: Translator) -> list[str]:
    heard: list[str] = []

    class Hears:
        def tell(self, line):
            heard.append(str(line) if isinstance(line, str) else line.render(tr.gettext))

        warn = tell

    summary(solved(name), tr, Hears())
    return [line for line in heard if "→" not in line]  # the formula of the structure has no numbers


@pytest.mark.parametrize("name", SAID)
@pytest.mark.parametrize("sign", ["comma", "point"])
def test_sentences_have_the_numbers_of_their_language(name, sign):
    """The other way: the same numbers in the same order as in English, each read by its own sign."""
    number = re.compile(r"(?<![\w.,])[-−]?\d+(?:[.,]\d+)?(?!\w)")

    def read(lines: list[str], decimal: str) -> list[float]:
        found = [text for line in lines for text in number.findall(line)]
        other = {",": ".", ".": ","}[decimal]
        assert not [text for text in found if other in text or text.startswith("-")]
        return [float(text.replace(decimal, ".").replace("−", "-")) for text in found]

    russian = sentences(name, Translator("ru", sign))
    assert read(russian, SIGNS[sign]) == read(sentences(name, Translator("en")), ".")
    assert not re.search(r"\d (mm|m|N|kN|rad|rpm|N/mm|kg)\b", " ".join(russian))


def test_names_in_sentences_are_left_as_they_are():
    lengths = equalities({"a": Amount(1.5e-5, unit="mm"), "b": Amount(2)})
    said = Message("%(name)s: %(eta)s; %(x)s", {"name": "jig 2.5 mm", "eta": Amount(-0.5), "x": lengths})
    assert str(printed(said, Translator("ru"))) == "jig 2.5 mm: −0,5; a = 1,5·10⁻⁵ мм, b = 2"


def test_a_mistake_has_numbers_and_pieces_of_a_variant_in_the_units_of_its_language():
    cure = Message("%(x)s; %(y)s", {"x": Amount(131.28, 6, "mm"), "y": Typed("at: [40 deg, 0.5 mm], 8 m*g")})
    assert cure.render(Translator("ru").gettext) == "131,28 мм; at: [40 град, 0.5 мм], 8 м*г"
    assert str(cure) == "131.28 mm; at: [40 deg, 0.5 mm], 8 m*g"
    assert Message("%(x)s", {"x": Amount(19.5, unit="deg")}).render(Translator("kk").gettext) == "19,5°"


def test_letters_of_the_table_are_those_of_the_note():
    letters = {
        language: [row[1] for row in rows(solved("shaper"), Translator(language))]
        for language in ("ru", "en")
    }
    assert "M_ур" in letters["ru"] and "M_bal" in letters["en"]
