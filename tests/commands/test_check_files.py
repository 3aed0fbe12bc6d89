"""Files around `check`: hostile stored results, the outcome for CI services, the examples for them."""

from __future__ import annotations

import inspect
import json
import os
import re
import shlex
import shutil
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from told import Told

from tmm_report.commands.check import junit, stored
from tmm_report.commands.check.run import run
from tmm_report.problems import ProblemError

ROOT = Path(__file__).parents[2]
SAMPLES = Path(__file__).parents[1] / "samples"


def check(folder, to=None):
    """Whether nothing differs."""
    return run(folder, update=False, junit=to, language="en", talk=Told())


@pytest.fixture
def folder(tmp_path):
    """A sample to be spoiled."""
    for suffix in (".yaml", stored.SUFFIX):
        shutil.copy(SAMPLES / f"eccentric{suffix}", tmp_path)
    return tmp_path


# ---------------------------------------------------------------- hostile files


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{",
        b"[1]",
        b"\xff\xfe{}",
        b'{"format": 2}',
        b'{"format": 1, "values": {"a": NaN}}',
        b'{"format": 1, "values": {"a": 1e999}}',
        b'{"format": 1, "values": {"a": ' + b"9" * 5000 + b"}}",
        b'{"format": 1, "values": [1]}',
        b'{"format": 1, "values": {"a": {"b": 1}}}',
        b'{"format": 1, "tables": {"t": [1]}}',
        b'{"format": 1, "tables": {"t": {"c": 1}}}',
        b'{"format": 1, "structure": "x"}',
        b'{"format": 1, "structure": [1]}',
        b'{"format": 1, "structure": [' + b'"| a |", "z", ' * 200_000 + b'"z"]}',
        b'{"format": 1, "language": "xx"}',
        b'{"format": 1, "values": {"a": 1, "a": 2}}',
        b'{"format": 1, "tables": {"' + b"x" * 10_000 + b'\\u202e": 1}}',
        b'{"format": 1, "language": []}',
        b'{"format": 1, "tolerance": {"relative": -1}}',
        b'{"format": 1, "tolerance": {"relative": "1"}}',
        b'{"format": 1, "tolerance": {"values.a": {"up": 1}}}',
        b'{"format": 1, "values": ' + b"[" * 100_000,
        b'{"format": 1, "a": "' + b"x" * 6_000_000 + b'"}',
    ],
)
def test_a_stored_file_that_is_none_is_a_mistake_with_its_place(content, folder):
    (folder / f"eccentric{stored.SUFFIX}").write_bytes(content)
    with pytest.raises(ProblemError) as caught:
        check(folder)
    text = caught.value.problems[0].text()
    assert "eccentric.expected.json" in text and len(text) < 600


def test_a_link_in_place_of_a_stored_file_is_not_followed(folder):
    path = folder / f"eccentric{stored.SUFFIX}"
    path.rename(folder / "elsewhere.json")
    try:
        os.symlink(folder / "elsewhere.json", path)
    except OSError:
        pytest.skip("no links here")
    with pytest.raises(ProblemError, match=r"eccentric\.expected\.json"):
        check(folder)


@pytest.mark.exhaustive
@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.integers() | st.text(),
        lambda x: st.lists(x) | st.dictionaries(st.text(), x),
    )
)
def test_any_json_is_read_or_refused(tmp_path_factory, value):
    path = tmp_path_factory.mktemp("any") / "one.expected.json"
    document = {"format": 1, "values": value, "tables": value, "tolerance": value, "structure": value}
    path.write_text(json.dumps(document), "utf-8")
    try:
        stored.read(path)
    except ProblemError as error:
        assert "one.expected.json" in str(error)


# ---------------------------------------------------------------- CI services


@pytest.mark.exhaustive
def test_the_outcome_for_a_service_has_a_case_a_sample_and_kind(folder, tmp_path):
    (folder / f"eccentric{stored.SUFFIX}").unlink()
    first, second = tmp_path / "out" / "one.xml", tmp_path / "out" / "two.xml"
    check(folder, to=first)
    check(folder, to=second)
    assert first.read_bytes() == second.read_bytes()
    root = ElementTree.parse(first).getroot()
    assert root.tag == "testsuites" and root.get("tests") == "2" and root.get("failures") == "1"
    cases = {case.get("name"): case for case in root.iter("testcase")}
    assert list(cases) == ["eccentric: numbers", "eccentric: structure"]
    failure = cases["eccentric: numbers"].find("failure")
    assert failure is not None and failure.get("message") == "no stored result; --update stores it"


@given(st.text(), st.lists(st.text(min_size=1), max_size=3), st.lists(st.text(min_size=1), max_size=3))
def test_any_text_makes_a_file_that_can_be_read(name, failed, broken):
    root = ElementTree.fromstring(junit.xml([junit.Case(name, "numbers", failed, broken)]))
    (case,) = root.iter("testcase")
    assert (case.find("failure") is not None) == bool(failed)
    assert (case.find("error") is not None) == bool(broken)


def commands(node):
    """Every command line of a configuration."""
    if isinstance(node, dict):
        for value in node.values():
            yield from commands(value)
    elif isinstance(node, list):
        for value in node:
            yield from commands(value)
    elif isinstance(node, str):
        yield from (line for line in node.splitlines() if line.startswith("tmm-report "))


@pytest.mark.parametrize("name", ["github-actions.yml", "gitlab-ci.yml"])
def test_the_examples_install_the_package_from_a_wheel_or_the_index(name):
    """The repository that they are copied to holds samples, perhaps a wheel, and not the program."""
    text = (ROOT / "docs" / "ci" / name).read_text("utf-8")
    package = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["name"]
    installs = re.findall(r"pip install (.*)", text)
    assert installs == [f"--find-links wheels {package}"]


@pytest.mark.parametrize("name", ["github-actions.yml", "gitlab-ci.yml"])
def test_the_examples_for_services_are_yaml_and_call_real_options(name):
    document = yaml.safe_load((ROOT / "docs" / "ci" / name).read_text("utf-8"))
    (line,) = commands(document)
    program, command, place, *options = shlex.split(line)
    known = {f"--{'lang' if name == 'language' else name}" for name in inspect.signature(run).parameters}
    assert (program, command, place) == ("tmm-report", "check", "samples/")
    assert {word for word in options if word.startswith("--")} <= known
    assert "--junit" in options and options[options.index("--junit") + 1] in json.dumps(
        document["samples" if "samples" in document else "jobs"]
    )
