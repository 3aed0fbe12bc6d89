"""What a click tells against what `explain` tells of the same number, and in a browser."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from conftest import read, solved
from exhaustive import many
from test_living_data import data, page
from test_living_page import opened, run

from tmm_report.commands.explain.derivation import Derivation
from tmm_report.commands.explain.target import Target
from tmm_report.commands.explain.text import lines
from tmm_report.commands.explain.way import Ways
from tmm_report.i18n import Translator
from tmm_report.report.heard import Heard

SOME = [
    "compressor",
    "hoist_drive",
    "cam_press",
    "press_flywheel",
    "valve_cam",
    "engine_balance",
    "scotch_yoke",
]


def explained(name: str, variant: str) -> tuple[list[str], list[str]] | None:
    """What `explain` works out of a number at the position that the note writes out, and with what it starts; None of
    a column whose rows have ways of their own."""
    results, tr = solved(variant), Translator(read(variant).language)
    ways = Ways.of(results)
    table, _, key = name.rpartition(".")
    if not table:
        value = ways.book.values[key]
        asked = Target(value.quantity, value=float(value.value))
    else:
        of = ways.book.tables[table]
        asked = Target(of[key].quantity, of)
        if "position" in of:
            at = [int(k) for k in of["position"].values]
            sample = results.lever.sample if results.lever is not None else 0
            asked = Target(of[key].quantity, of, sample if sample in at else at[0])
        elif len(of) > 1:
            return None
    said = [one.strip() for one in lines(asked, Heard(), Derivation([], []), ways.told(asked), True, tr)]
    said = said[: said.index(tr.gettext("Value in the results:"))]
    starts = tr.gettext("It starts with:")
    ends = said.index(starts) if starts in said else len(said)
    return said[3:ends] if ways.told(asked).way.text else said[2:ends], said[ends + 1 :]


@pytest.mark.parametrize("name", many(SOME, 2))
def test_a_click_tells_what_explain_works_out(name):
    """Line by line, of every number of the page that has a way with numbers."""
    told = data(name)["told"]
    checked = starting = 0
    for one in {*told["worked"], *told["starts"]}:
        if (wanted := explained(one, name)) is None:
            continue
        worked, starts = wanted
        assert set(worked) <= {told["texts"][n] for n in told["worked"].get(one, ())}, one
        checked += len(worked)
        starting += len(starts)
        if len(starts) and not any("…" in line for line in starts):
            assert len(told["starts"][one]) >= len({s for s in starts if not s.startswith("position")}) - 1, (
                one
            )
    assert checked + starting > 2


def test_a_variant_that_states_little_tells_little():
    """A number that is given has its sentence, and nothing that it starts with."""
    told = data("compressor")["told"]
    given = Translator(read("compressor").language).gettext(
        "Given: the variant states it, or leaves the usual value."
    )
    stated = [name for name, n in told["ways"].items() if told["texts"][n] == given]
    assert stated and not any(name in told["worked"] for name in stated)


CLICKED = """
(async () => {
  const cell = document.querySelector('main td[data-q="%s"][data-k="%d"][data-t="%s"]');
  cell.click();
  while (!document.querySelector('dialog.told')) await new Promise(done => setTimeout(done, 20));
  const box = document.querySelector('dialog.told');
  const found = {worked: box.querySelector('.worked')?.textContent, all: box.textContent,
    numbers: [...box.querySelectorAll('li')].map(x => [x.textContent, x.querySelector('b')?.textContent]),
    places: [...box.querySelectorAll('.formula a')].map(x => x.textContent),
    where: box.querySelector('.where').textContent};
  box.close();
  return found;
})()
"""


def test_a_click_on_another_position_starts_with_the_numbers_of_that_position():
    """What is worked out is of the position of the note, and is said to be; the numbers are those of the row."""
    told, position = data("compressor")["told"], 4
    name = next(
        one
        for one, of in told["starts"].items()
        if one.startswith("flywheel_table.")
        and sum(isinstance(s, str) for s in of) > 1
        and 'data-q="{1}" data-k="4" data-t="{0}"'.format(*one.split(".")) in page("compressor")
    )
    table, key = name.split(".")
    with opened(page("compressor")) as talk:
        found: dict[str, Any] = run(talk, CLICKED % (key, position, table))
    assert found["where"].endswith(name)
    columns = {c["key"]: c for of in data("compressor")["cycle"]["columns"].values() for c in of}
    numbered = data("compressor")["cycle"]["numbered"]
    wanted = [
        columns[s.split(".")[1]]
        for s in told["starts"][name]
        if isinstance(s, str) and s.split(".")[1] in columns
    ]
    shown = [value for _, value in found["numbers"] if value]
    assert wanted
    for column in wanted:
        value = column["values"][numbered[position]]
        near = [
            x
            for x in shown
            if x.endswith(column["unit"]) and np.isclose(read_number(x), value, rtol=1e-4, atol=1e-9)
        ]
        assert near, (column["key"], value, shown)


def read_number(text: str) -> float:
    return float(text.split(" ")[0].replace("\u2212", "-").replace(",", ".").replace("\xa0", "") or "nan")


def test_a_vector_stands_upon_the_formulas_of_its_components():
    """v_B of a comparison has no formula of its own in a short note: it is told by those of v_B^x and v_B^y."""
    with opened(page("compressor")) as talk:
        found = run(talk, CLICKED % ("v_B", 7, "comparison_7"))
        force = run(talk, CLICKED % ("R_24", 7, "force_comparison_7"))
    assert (
        "vBx = " in found["worked"]
        and found["where"].endswith("rates_table.v_B")
        and len(found["places"]) > 5
    )
    assert len(force["places"]) > 3  # the equations of the force polygon are among them
