"""Titles of pictures: browsers show them as they get them, so they hold no markup."""

from __future__ import annotations

import html
import re

import pytest
from notes import note

NAMED = (
    "engine_balance", "drum_motor", "hoist_drive", "governor_porter", "rotor", "jack_and_belt", "machine_train",
    "crank_rocker", "punch_press", "locomotive_diesel",
)  # fmt: skip


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", NAMED)
def test_a_title_is_plain_text(name, language):
    (text,) = (file.decode() for file in note(name, "html", language).values())
    titles = re.findall(r"<svg[^>]*><title>(.*?)</title>", text, re.DOTALL)
    assert all(title.strip() for title in titles) and len(titles) == text.count("<figure ")
    for title in map(html.unescape, titles):
        assert not re.search(r"<|>|&\w*;|&#", title) and "data-q" not in title


def test_heads_of_tables_say_what_they_head():
    (text,) = (file.decode() for file in note("crank_rocker", "html", "en").values())
    heads = re.findall(r"<th\b[^>]*>", text)
    assert heads and set(heads) == {'<th scope="col">'}


def test_the_scale_of_a_polygon_is_read_in_its_title():
    (text,) = (file.decode() for file in note("engine_balance", "html", "en").values())
    assert re.search(r"<title>Cranks of order 1 and the sum of the forces, μF=0\.025 kg·m/mm</title>", text)
