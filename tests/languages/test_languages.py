"""Every language of the table has all its pieces, and what is missing is named; a file and --lang say the same."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from catalogues import messages
from exhaustive import many
from notes import VARIANTS, program, render
from typer.testing import CliRunner

from tmm_report import languages, load, solve
from tmm_report.cli import app
from tmm_report.commands.whole import LIST
from tmm_report.i18n import DOMAINS, Translator
from tmm_report.languages import FALLBACK, LANGUAGES, SIGNS, Language, language, of_locale
from tmm_report.loading import schema
from tmm_report.problems import Message, ProblemError
from tmm_report.profiles import NAMES, shipped
from tmm_report.quantity.text import UNITS
from tmm_report.variant import new

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = ROOT / "templates"
KNOWN = ", ".join(LANGUAGES)
LEAST = 40  # terms of a glossary
FOREIGN = Language("eo", "Esperanto", "comma", babel="nonesuch")


@pytest.fixture(scope="module")
def tool():
    return messages()


def lacking(row: Language, tool: dict) -> list[str]:
    """Every piece of a language that is missing or wrong, in words."""
    pieces = [*of_table(row), *of_starting_variant(row)]
    pieces += of_profiles(row)
    return pieces if row.ids else [*pieces, *of_translations(row, tool)]


def of_table(row: Language) -> Iterator[str]:
    if row.decimal not in SIGNS:
        yield f"languages.py: decimal sign {row.decimal!r}"
    if not re.fullmatch("[a-z]{2,3}", row.code) or LANGUAGES.get(row.code) is not row:
        yield f"languages.py: code {row.code!r}"
    for name in (row.babel, row.beside):
        files = (f"{name}.ldf", f"babel-{name}.tex")
        if not any(
            subprocess.run([program("kpsewhich"), file], capture_output=True).stdout for file in files
        ):
            yield f"languages.py: babel has no language {name!r}"


def of_starting_variant(row: Language) -> Iterator[str]:
    kinds = (kind / f"{row.code}.yaml" for kind in sorted((TEMPLATES / "kinds").iterdir()))
    yield from (f"kinds/{file.parent.name}/{file.name}" for file in kinds if not file.is_file())
    file = TEMPLATES / "new" / f"{row.code}.yaml"
    if not file.is_file():
        yield f"new/{row.code}.yaml"
        return
    try:
        started = load(file)
        solve(started)
    except ProblemError as error:
        yield f"new/{row.code}.yaml: {error}"
    else:
        if started.language != row.code:
            yield f"new/{row.code}.yaml: language {started.language}"


def of_profiles(row: Language) -> Iterator[str]:
    """Words of the note that a shipped profile has in English and not in the language; a profile that is not there."""
    if row.profile not in NAMES:
        yield f"languages.py: profile {row.profile!r}"
    for name in NAMES:
        words = shipped(name).words
        lost = words[FALLBACK].keys() - words.get(row.code, {}).keys()
        yield from (f"profiles/{name}.yaml: no {word} in {row.code}" for word in sorted(lost))


def of_translations(row: Language, tool: dict) -> list[str]:
    return [*of_catalogue(row, tool), *of_glossary(row, tool)]


def of_catalogue(row: Language, tool: dict) -> Iterator[str]:
    for domain in DOMAINS if row.messages else ("note",):
        po = tool["po_file"](row.code, domain)
        files = (po, po.with_suffix(".mo"))
        yield from (f"locale/{row.code}: {file.name}" for file in files if not file.is_file())
        if po.is_file():
            catalogue = tool["merged"](row.code, domain)
            yield from (f"{po.name}: no translation of {text!r}" for text in tool["missing"](catalogue))
    words = tool["messages"](tool["merged"](row.code, "note"))
    known = {entry.id for entry in words if entry.context == "unit" and entry.string}
    yield from (f"note.po: no translation of the unit {unit}" for unit in UNITS if unit not in known)


def of_glossary(row: Language, tool: dict) -> Iterator[str]:
    terms = tool["glossary"](row.code)
    if len(terms) < LEAST:
        yield f"locale/{row.code}/glossary.yaml: {len(terms)} terms, {LEAST} wanted"
    yield from (f"glossary.yaml: {text}" for text in tool["misnamed"](tool["merged"](row.code), terms))


@pytest.mark.exhaustive
@pytest.mark.parametrize("row", LANGUAGES.values(), ids=LANGUAGES)
def test_a_language_has_all_its_pieces(row, tool):
    assert lacking(row, tool) == []


def test_files_of_languages_that_are_not_in_the_table():
    folders = {folder.name for folder in (TEMPLATES / "locale").iterdir()}
    assert folders == {row.code for row in LANGUAGES.values() if not row.ids}
    assert {file.stem for file in (TEMPLATES / "new").iterdir()} == set(LANGUAGES)


# ---------------------------------------------------------------- the list of what is missing can be long


def test_of_a_language_with_only_a_row_everything_is_missing(tool, monkeypatch):
    monkeypatch.setitem(LANGUAGES, "eo", FOREIGN)
    said = "\n".join(lacking(FOREIGN, tool))
    for piece in (
        "babel has no language 'nonesuch'",
        "new/eo.yaml",
        "locale/eo: note.po",
        "locale/eo: note.mo",
        "locale/eo: messages.po",
        "locale/eo: messages.mo",
        "kinds/cam/eo.yaml",
        "glossary.yaml: 0 terms",
        "profiles/gost.yaml: no figure in eo",
        "profiles/kz.yaml: no where in eo",
    ):
        assert piece in said, said


@pytest.fixture
def begun(tmp_path, monkeypatch, tool):
    """The Russian files copied; their catalogue of notes as a list of lines to change."""
    shutil.copytree(TEMPLATES / "locale", tmp_path / "locale")
    monkeypatch.setitem(tool["merged"].__globals__, "LOCALE", tmp_path / "locale")
    return tool, tmp_path / "locale" / "ru" / "LC_MESSAGES" / "note.po"


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("text", "other", "said"),
    [
        (
            'msgid "Contents of the note:"\nmsgstr "Содержание пояснительной записки:"',
            'msgid "Contents of the note:"\nmsgstr ""',
            "no translation of 'Contents of the note:'",
        ),
        ('msgid "mm"\nmsgstr "мм"', 'msgid "mm"\nmsgstr ""', "no translation of the unit mm"),
        ("сателлит", "спутник", "'planet gear' is not called сателлит|"),
        ("баланс мощностей", "равенство мощностей", "'power balance' is not called"),
    ],
)
def test_what_is_missing_in_a_catalogue_is_named(begun, text, other, said):
    tool, po = begun
    catalogue = po.read_text("utf-8")
    assert text in catalogue
    po.write_text(catalogue.replace(text, other), encoding="utf-8")
    assert any(said in piece for piece in of_translations(LANGUAGES["ru"], tool))


@pytest.mark.exhaustive
def test_a_term_that_no_text_has_is_named(begun):
    tool, po = begun
    file = po.parent.parent / "glossary.yaml"
    file.write_text(file.read_text("utf-8") + "flywheel governor: регулятор|\n", encoding="utf-8")
    assert "glossary.yaml: 'flywheel governor' is in no text" in of_glossary(LANGUAGES["ru"], tool)


# ---------------------------------------------------------------- a language is its row and its files

ADDED = """
import sys
from tmm_report.languages import LANGUAGES, Language
LANGUAGES["qaa"] = Language("qaa", "reserved", "comma", babel="ukrainian")
from tmm_report.cli import main
main()
"""


@pytest.mark.exhaustive
def test_a_row_and_files_make_a_language(tmp_path):
    """In a copy of the program: `new`, the key of the file, the note, messages and the schema know it."""
    for folder in ("tmm_report", "templates"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    templates = tmp_path / "templates"
    shutil.copytree(templates / "locale" / "ru", templates / "locale" / "qaa")
    started = (templates / "new" / "ru.yaml").read_text("utf-8").replace("language: ru ", "language: qaa ")
    (templates / "new" / "qaa.yaml").write_text(started, encoding="utf-8")
    for profile in (templates / "profiles").iterdir():
        text = profile.read_text("utf-8")
        words = re.search(r"^  ru:\n(?:    .*\n)+", text, re.M)[0].replace("  ru:", "  qaa:")
        profile.write_text(f"{text.rstrip()}\n{words}", encoding="utf-8")

    def run(*arguments: str) -> subprocess.CompletedProcess:
        command = [sys.executable, "-c", ADDED, *arguments]
        env = {"PYTHONPATH": str(tmp_path), "PATH": "", "LANG": "qaa_XX.UTF-8", "PYTHONUTF8": "1"}
        return subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, encoding="utf-8")

    assert run("new", "my.yaml", "--lang", "qaa").stdout == "записано: my.yaml, variant.schema.json\n"
    done = run("solve", "my.yaml", "--format", "html,tex")
    assert done.returncode == 0 and "записано: " in done.stdout, done.stderr
    note = (tmp_path / "my-note" / "note.html").read_text("utf-8")
    assert '<html lang="qaa">' in note and "Содержание" in note
    tex = (tmp_path / "my-note" / "note.tex").read_text("utf-8")
    assert r"\usepackage[english,main=ukrainian,shorthands=off]{babel}" in tex
    assert '"qaa"' in run("schema").stdout and "qaa" in run("solve", "--help").stdout
    refused = run("solve", "my.yaml", "--lang", "eo")
    assert (refused.returncode, refused.stderr) == (2, f"--lang: языка eo нет; известны: {KNOWN}, qaa\n")


# ---------------------------------------------------------------- the file and --lang say the same


def run(*arguments: object, **env: str):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C", **env})


@pytest.mark.parametrize("code", many(["eo", "../ru", "de", "RU", "russian", "r" * 100, "x\u202ey"], 2))
@pytest.mark.parametrize("locale", ["C", "ru_RU.UTF-8"])
def test_a_language_that_there_is_not(tmp_path, code, locale):
    text = (VARIANTS / "crank_rocker.yaml").read_text("utf-8").replace("language: ru", f"language: {code}")
    file = tmp_path / "my.yaml"
    file.write_text(text, encoding="utf-8")
    env = {"LANG": locale, "LC_ALL": locale}
    stated = run("solve", file, "-o", tmp_path / "out", **env)
    asked = [
        run("solve", VARIANTS / "crank_rocker.yaml", "-o", tmp_path / "out", "--lang", code, **env),
        run("assemblies", VARIANTS / "crank_rocker.yaml", "-o", tmp_path / "out", "--lang", code, **env),
        run("gallery", tmp_path, "-o", tmp_path / "out", "--lang", code, **env),
        run("new", tmp_path / "new.yaml", "--lang", code, **env),
    ]
    place, _, sentence = stated.output.partition(": language: ")
    assert re.fullmatch(rf"{re.escape(str(file))}:\d+:\d+", place)
    assert {done.output for done in asked} == {f"--lang: {sentence}"}
    assert sentence.count("\n") == 1 and KNOWN in sentence
    assert {done.exit_code for done in [stated, *asked]} == {2}
    assert not (tmp_path / "out").exists() and not (tmp_path / "new.yaml").exists()


def test_the_library_refuses_as_the_command_does(compressor):
    for refused in (
        lambda: language("eo"),
        lambda: render(compressor, "json", "eo"),
        lambda: new("eo"),
        lambda: Translator("eo").gettext("Contents"),
        lambda: Translator("eo").decimal,
    ):
        with pytest.raises(ProblemError, match=rf"^there is no language eo; known: {KNOWN}$"):
            refused()


@pytest.mark.exhaustive
@pytest.mark.parametrize("code", LANGUAGES)
def test_the_key_and_lang_give_the_same_note(tmp_path, code):
    text = (VARIANTS / "crank_rocker.yaml").read_text("utf-8")
    other = next(one for one in LANGUAGES if one != code)
    for name, stated in (("stated", code), ("asked", other)):
        (tmp_path / name).mkdir()
        file = tmp_path / name / "my.yaml"
        file.write_text(text.replace("language: ru", f"language: {stated}"), encoding="utf-8")
        asked = ("--lang", code) if name == "asked" else ()
        assert (
            run("solve", file, "-o", tmp_path / name / "out", "--format", "html,csv", *asked).exit_code == 0
        )
    stated, asked = (
        {file.name: file.read_bytes() for file in (tmp_path / name / "out").rglob("*.*") if file.name != LIST}
        for name in ("stated", "asked")
    )
    assert stated == asked


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("ru_RU.UTF-8", "ru"),
        ("ru", "ru"),
        ("Russian_Russia.1251", "ru"),
        ("en_GB", "en"),
        ("de_DE.UTF-8", "en"),
        ("run", "en"),
        ("C", "en"),
        ("", "en"),
    ],
)
def test_the_language_of_a_system(name, code):
    assert of_locale(name) == code


@pytest.mark.exhaustive
def test_help_and_schema_list_the_languages():
    assert schema()["properties"]["language"]["enum"] == [*LANGUAGES]
    for command in ("solve", "new", "gallery", "assemblies"):
        assert " or ".join(LANGUAGES) in " ".join(run(command, "--help").output.split())
    assert languages.DEFAULT in LANGUAGES and languages.FALLBACK in LANGUAGES


def test_no_other_place_lists_languages():
    """A code of a language in quotes, beside the table: in the program, its tools and its templates."""
    listed = re.compile(r"""["'](ru|en|russian|english)["']""")
    files = [*ROOT.glob("tmm_report/**/*.py"), *ROOT.glob("tools/*.py"), *ROOT.glob("templates/**/*.j2")]
    found = {
        f"{file.relative_to(ROOT)}: {line.strip()}"
        for file in files
        for line in file.read_text("utf-8").splitlines()
        if listed.search(line) and file.name != "languages.py" and "Translator(" not in line
    }
    assert found == set()
    assert len(files) > 100


def test_message_values_may_be_messages():
    inner = Message("there is no language %(code)s", {"code": "%s %%"})
    assert Message("error: %(what)s", {"what": inner}).render(str) == "error: there is no language %s %%"
