"""Compiled templates are kept for the user alone, and their cache is never in the way."""

import os
import sys
from pathlib import Path

import pytest
from jinja2 import DictLoader, Environment

from tmm_report.report.bytecode import bytecode_cache, user_folder

posix = pytest.mark.skipif(not hasattr(os, "geteuid"), reason="owners and modes of POSIX")


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A cache folder of the user's own."""
    monkeypatch.setenv("LOCALAPPDATA" if sys.platform == "win32" else "XDG_CACHE_HOME", str(tmp_path / "own"))
    return tmp_path / "own"


def said(cache, text="{{ 6 * x }}"):
    return Environment(loader=DictLoader({"a": text}), bytecode_cache=cache).get_template("a").render(x=7)


def test_templates_are_compiled_once(home, monkeypatch):
    assert said(bytecode_cache("o")) == "42"
    assert [path.parts[-3] for path in home.rglob("*.cache")] == ["tmm-report"]
    monkeypatch.setattr(Environment, "compile", None)  # compiling again would fail
    assert said(bytecode_cache("o")) == "42"


def test_other_options_and_another_text_are_compiled_anew(home):
    assert said(bytecode_cache("o")) == "42" and said(bytecode_cache("o"), "{{ x }}") == "7"
    assert Path(bytecode_cache("o").directory) != Path(bytecode_cache("p").directory)


@posix
@pytest.mark.parametrize("mode", [0o777, 0o770, 0o1777, 0o720])
def test_folder_that_others_write_to_is_not_read(home, mode):
    folder = Path(bytecode_cache("o").directory)
    folder.chmod(mode)
    assert bytecode_cache("o") is None


@posix
@pytest.mark.parametrize(("mode", "kept"), [(0o777, False), (0o770, False), (0o1777, True), (0o755, True)])
def test_folder_above_it_lets_nobody_put_another_in_its_place(home, mode, kept):
    assert bytecode_cache("o") is not None
    home.chmod(mode)
    assert (bytecode_cache("o") is not None) == kept


@posix
def test_folder_of_another_user_is_not_read(home, monkeypatch):
    assert bytecode_cache("o") is not None
    monkeypatch.setattr(os, "geteuid", lambda: 12345)
    assert bytecode_cache("o") is None


@posix
def test_link_is_judged_by_where_it_leads(home, tmp_path, monkeypatch):
    open_to_all = tmp_path / "open"
    open_to_all.mkdir()
    open_to_all.chmod(0o777)
    home.symlink_to(open_to_all)
    assert bytecode_cache("o") is None


def test_where_nothing_can_be_written_nothing_is_kept(home):
    home.write_text("a file where the folder should be")
    assert bytecode_cache("o") is None


def test_spoiled_file_and_a_folder_that_went_are_nobodys_trouble(home):
    cache = bytecode_cache("o")
    assert said(cache) == "42"
    for path in home.rglob("*.cache"):
        path.write_bytes(path.read_bytes()[:30])
    assert said(cache) == "42"
    for path in home.rglob("*.cache"):
        path.unlink()
    Path(cache.directory).rmdir()
    assert said(cache) == "42"


def test_folder_is_the_users_and_not_the_projects(monkeypatch):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.delenv("LOCALAPPDATA", raising=False)
    assert user_folder().is_relative_to(Path.home())
    monkeypatch.setenv("XDG_CACHE_HOME", "cache")  # not absolute: to be ignored
    assert user_folder().is_absolute()
