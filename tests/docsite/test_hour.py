"""The first hour word for word: what the page says that the program answers, it answers."""

from __future__ import annotations

import pytest
from hour import Hour
from notes import VARIANTS
from pages_of_docs import PAGES, blocks

from tmm_report import load, render, solve, sweep

HOURS = {"docs/hour.md": "C", "docs/ru/hour.md": "ru_RU.UTF-8"}


def test_an_hour_has_a_mistake_its_cure_a_watch_and_a_sweep():
    for page in HOURS:
        text = PAGES[page]
        assert "new my.yaml --like" in text and "--watch" in text and "sweep(" in text
        assert (text.count("```diff") == 3 and "unknown key" in text) or "неизвестный ключ" in text


@pytest.mark.exhaustive
@pytest.mark.parametrize(("page", "lang"), HOURS.items())
def test_the_program_answers_as_the_page_says(page, lang, tmp_path):
    for kind, told, said in Hour(tmp_path, lang).followed(PAGES[page]):
        assert said == told, kind


def test_the_page_of_python_runs(tmp_path, monkeypatch):
    """Its blocks one behind the other, in a folder with a variant."""
    pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    text = (VARIANTS / "compressor.yaml").read_text("utf-8").replace("period: 0.05 s", "speed: 1200 rpm")
    (tmp_path / "my.yaml").write_text(text, encoding="utf-8")
    names = {"load": load, "solve": solve, "render": render, "sweep": sweep}
    for text in blocks("docs/python.md", "python"):
        exec(compile(text, "docs/python.md", "exec"), names)
    assert names["s"]["M_bal_max"].shape == (4,) and names["r"]["H_B"].to("mm") == pytest.approx(200)
