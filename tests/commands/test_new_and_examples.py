"""What a first hour begins with: a starting variant of a kind, a ready one to change, the list of them."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from exhaustive import many
from notes import NAMES, VARIANTS
from typer.testing import CliRunner

from tmm_report import solve
from tmm_report.cli import app
from tmm_report.commands import schema
from tmm_report.commands.examples import KINDS, Example
from tmm_report.commands.new import FIRST, SCHEMA
from tmm_report.languages import LANGUAGES
from tmm_report.loading import load
from tmm_report.resources import data_root
from tmm_report.yamlread import read

TEXT = cache(schema.text)


@pytest.fixture(autouse=True)
def one_schema(monkeypatch):
    """The schema beside every variant is the same, and takes a third of a second to make."""
    monkeypatch.setattr(schema, "text", TEXT)


def run(*arguments: object, **env: str):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C", **env})


def listed(*arguments: object, **env: str) -> dict[str, str]:
    """Name -> what it is about, as the list has them."""
    done = run("examples", *arguments, **env)
    assert done.exit_code == 0, done.output
    return dict(re.split(r"  +", line, maxsplit=1) for line in done.output.splitlines())


def stated(name: str, folder: Path = VARIANTS) -> dict:
    return yaml.safe_load((folder / f"{name}.yaml").read_text("utf-8"))


def in_one(value: Any, code: str) -> Any:
    """Data with each text by languages in one of them."""
    if isinstance(value, dict):
        return (
            value[code]
            if [*value] == [*LANGUAGES]
            else {key: in_one(one, code) for key, one in value.items()}
        )
    return [in_one(one, code) for one in value] if isinstance(value, list) else value


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_ready_variant_has_its_line(language):
    found = listed("--lang", language)
    assert list(found) == sorted(file.stem for file in VARIANTS.glob("*.yaml"))
    for name, line in found.items():
        topic = stated(name)["title"]["topic"]
        said = topic if isinstance(topic, dict) else {language: topic}
        assert line == said.get(language, next(iter(said.values())))


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_is_told_by_the_blocks(kind):
    """The other way: the block is looked for in the data as PyYAML reads them."""
    blocks = {
        "lever": ["mechanism"],
        "cam": ["cam"],
        "drive": ["drive", "train", "eccentric"],
        "flywheel": ["flywheel"],
    }

    def is_one(name: str) -> bool:
        data = stated(name)
        cams = kind == "cam" and "cams" in data.get("mechanism", {})
        return cams or any(block in data for block in blocks[kind])

    found = set(listed("--kind", kind))
    assert found == {name for name in NAMES if is_one(name)} and 1 < len(found) < len(NAMES)


def test_a_block_is_a_kind_and_what_is_neither_is_told():
    assert set(listed("--kind", "governor")) == {name for name in NAMES if "governor" in stated(name)}
    assert set(listed("shaper", "rotor", "--kind", "lever")) == {"shaper"}
    done = run("examples", "--kind", "levr")
    assert done.exit_code == 2 and "unknown levr" in done.output and "flywheel" in done.output


RUSSIAN = {"рычаг": "lever", "Рычажный": "lever", "кулачок": "cam", "привод": "drive", "Маховик": "flywheel"}


@pytest.mark.parametrize("word", [*RUSSIAN, "регулятор"])
def test_a_kind_is_taken_in_russian(word, tmp_path):
    kind = RUSSIAN.get(word, "governor")
    assert listed("--kind", word) == listed("--kind", kind) != {}
    if kind in KINDS:
        run("new", tmp_path / "a.yaml", "--kind", word, "--lang", "ru")
        run("new", tmp_path / "b.yaml", "--kind", kind, "--lang", "ru")
        assert (tmp_path / "a.yaml").read_text("utf-8") == (tmp_path / "b.yaml").read_text("utf-8")


@pytest.mark.parametrize("name", ["../compressor", "shapr", "x\x1b[2J", "", "/etc/passwd"])
@pytest.mark.parametrize("command", [["examples"], ["new", "my.yaml", "--like"]])
def test_only_ready_variants_have_names(command, name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = run(*command, name)
    assert done.exit_code == 2 and "there is no ready variant" in done.output
    assert "\x1b" not in done.output and not list(tmp_path.iterdir())
    near = {"shapr": "did you mean shaper?", "../compressor": "did you mean compressor?"}
    cure = near.get(name, "tmm-report examples lists them")
    assert done.output.rstrip().endswith(cure)


def test_the_page_of_schemes_fetches_and_runs_nothing(tmp_path):
    done = run("examples", "shaper", "valve_cam", "-o", tmp_path / "page.html", "--lang", "ru")
    assert done.exit_code == 0, done.output
    text = (tmp_path / "page.html").read_text("utf-8")
    assert text.count("<svg") == 2 and "Кулачковый механизм привода клапана" in text
    assert "default-src 'none'" in text and "<script" not in text and "tmm-report new --like shaper" in text


def test_open_draws_the_scheme(tmp_path, monkeypatch):
    shown: list[str] = []
    monkeypatch.setattr("webbrowser.open", shown.append)
    monkeypatch.setattr("tempfile.mkdtemp", lambda prefix: str(tmp_path))
    assert run("examples", "rotor", "--open").exit_code == 0
    assert shown == [(tmp_path / "examples.html").as_uri()]
    assert "<svg" in (tmp_path / "examples.html").read_text("utf-8")


@pytest.mark.parametrize("name", many(["shaper", *NAMES], 2))
def test_a_copy_is_the_ready_variant_in_one_language_behind_a_line_for_the_editor(name, tmp_path):
    place = tmp_path / "my.yaml"
    assert run("new", "--like", name, "-o", place).exit_code == 0
    original = stated(name)
    text = place.read_text("utf-8")
    assert text.startswith(FIRST) and yaml.safe_load(text) == in_one(original, original["language"])
    assert re.findall("#.*", text)[1:] == re.findall("#.*", (VARIANTS / f"{name}.yaml").read_text("utf-8"))
    schema = json.loads((tmp_path / SCHEMA).read_text("utf-8"))
    as_read = read(place).data
    assert f"# yaml-language-server: $schema={SCHEMA}\n" == FIRST
    assert list(jsonschema.Draft202012Validator(schema).iter_errors(as_read)) == []
    assert list(jsonschema.Draft202012Validator(schema).iter_errors({**as_read, "surplus": 1}))


def test_a_copy_has_the_name_of_its_original_and_the_language_that_is_asked_for(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("new", "--like", "shaper", "--lang", "uk").exit_code == 0
    original = stated("shaper")
    assert stated("shaper", tmp_path) == in_one(original, "uk") | {"language": "uk"}
    assert run("new", "--like", "shaper").exit_code == 2  # never overwritten
    assert run("new", "a.yaml", "-o", "b.yaml").exit_code == 2
    assert run("new", "--like", "shaper", "--kind", "cam").exit_code == 2
    assert {path.name for path in tmp_path.iterdir()} == {"shaper.yaml", SCHEMA}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", KINDS)
def test_a_starting_variant_of_each_kind_is_solved(kind, language, tmp_path):
    place = tmp_path / "my.yaml"
    done = run("new", place, "--kind", kind, "--lang", language)
    assert done.exit_code == 0, done.output
    text = place.read_text("utf-8")
    data = yaml.safe_load(text)
    assert text.startswith(FIRST) and Example(place, "", tuple(data)).is_a(kind)
    variant = load(place)
    assert variant.language == language and variant.doubts == ()
    results = solve(variant)
    assert (results.lever if kind == "lever" else getattr(results, kind)) is not None
    schema = json.loads((tmp_path / SCHEMA).read_text("utf-8"))
    assert list(jsonschema.Draft202012Validator(schema).iter_errors(read(place).data)) == []


def test_every_kind_has_a_start_in_every_language():
    folders = {file.parent.name for file in (data_root() / "templates" / "kinds").rglob("*.yaml")}
    assert {*folders, next(iter(KINDS))} == set(KINDS)
    for folder in folders:
        assert {file.stem for file in (data_root() / "templates" / "kinds" / folder).iterdir()} == set(
            LANGUAGES
        )


def test_a_kind_that_there_is_not(tmp_path):
    done = run("new", tmp_path / "my.yaml", "--kind", "gear\x1b[0m")
    assert done.exit_code == 2 and "lever, cam, drive, flywheel" in done.output and "\x1b" not in done.output
    assert not list(tmp_path.iterdir())


def test_another_schema_beside_it_is_left(tmp_path):
    (tmp_path / SCHEMA).write_text('{"mine": 1}', encoding="utf-8")
    done = run("new", tmp_path / "my.yaml")
    assert done.exit_code == 0 and "is not a schema of this program" in done.output
    assert (tmp_path / SCHEMA).read_text("utf-8") == '{"mine": 1}'
    (tmp_path / SCHEMA).write_text(run("schema").output[:200], encoding="utf-8")
    assert run("new", tmp_path / "other.yaml").exit_code == 0  # an older one of ours is renewed
    assert json.loads((tmp_path / SCHEMA).read_text("utf-8"))["title"] == "Variant"


def test_a_schema_is_not_written_through_a_link(tmp_path):
    (tmp_path / "mine").write_text(
        '{\n  "$schema": "https://json-schema.org/draft/2020-12/schema"', encoding="utf-8"
    )
    (tmp_path / SCHEMA).symlink_to(tmp_path / "mine")
    assert run("new", tmp_path / "my.yaml").exit_code == 0
    assert (tmp_path / "mine").stat().st_size < 100 and (tmp_path / SCHEMA).is_symlink()


def test_the_schema_goes_into_a_file(tmp_path):
    assert run("schema", "-o", tmp_path / "s.json").exit_code == 0
    assert (tmp_path / "s.json").read_text("utf-8") == run("schema").output
    assert run("schema", "-o", tmp_path / "none" / "s.json").exit_code in (0, 2)


def test_values_in_russian_words_are_those_in_english(tmp_path):
    """What a student writes in his own language is the same number and the same sense."""
    text = (VARIANTS / "shaper.yaml").read_text("utf-8")
    words = {
        "rotation: counter-clockwise": "rotation: против часовой стрелки",
        "rotation: clockwise": "rotation: по часовой стрелке",
        "direction: against motion": "direction: против движения",
        "extreme: right": "extreme: правое",
        "extreme: left": "extreme: левое",
    }
    changed = text
    for word, twin in words.items():
        changed = changed.replace(word, twin)
    assert changed != text and "часовой стрелк" in changed
    (tmp_path / "my.yaml").write_text(changed, encoding="utf-8")
    one, two = solve(load(VARIANTS / "shaper.yaml")), solve(load(tmp_path / "my.yaml"))
    assert (one.lever.kinetostatics.table.balancing == two.lever.kinetostatics.table.balancing).all()
