"""What a click tells against what `explain` tells of the same number, and in a browser."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from conftest import read, solved
from exhaustive import many
from test_living_data import data, page
from test_living_page import opened, run

from tmm_report.commands.explain.derivation import Derivation
from tmm_report.commands.explain.listen import listen
from tmm_report.commands.explain.target import Target
from tmm_report.commands.explain.text import lines
from tmm_report.commands.explain.way import Ways
from tmm_report.i18n import Translator
from tmm_report.note import parts
from tmm_report.quantity.formula import Formula
from tmm_report.report.heard import Heard
from tmm_report.report.plain import text

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


def test_a_number_of_a_row_is_called_as_the_row_calls_it():
    """Teeth of each wheel of a table by its own index."""
    told = data("hoist_drive")["told"]
    for table, wheels in (("drive_speeds", "12345"), ("stage1_wheels", "12")):
        said = [told["texts"][n].partition(" – ")[0] for n in told["meanings"][f"{table}.z"]]
        assert [one for one in said if one[2:] in wheels] == [f"z_{wheel}" for wheel in wheels]


CLICKED = """
(async () => {
  const cell = document.querySelector('main td[data-q="%s"][data-k="%d"][data-t="%s"]');
  cell.click();
  while (!document.querySelector('dialog.told')) await new Promise(done => setTimeout(done, 20));
  const box = document.querySelector('dialog.told');
  const found = {worked: box.querySelector('.worked')?.textContent, all: box.textContent,
    numbers: [...box.querySelectorAll('li')].map(x => [x.textContent, x.querySelector('b')?.textContent]),
    places: [...box.querySelectorAll('.formula a')].map(x => x.textContent),
    formulas: [...box.querySelectorAll('.formula .math')].map(x => x.textContent),
    where: box.querySelector('.where').textContent};
  box.close();
  box.remove();
  return found;
})()
"""


def of_another_position() -> str:
    """A number that starts with numbers of its row, which the page has."""
    return next(
        one
        for one, of in data("compressor")["told"]["starts"].items()
        if one.startswith("flywheel_table.")
        and sum(isinstance(s, str) for s in of) > 1
        and 'data-q="{1}" data-k="4" data-t="{0}"'.format(*one.split(".")) in page("compressor")
    )


@cache
def clicked() -> dict[str, Any]:
    """Everything that is clicked, in one visit."""
    with opened(page("compressor")) as talk:
        table, key = of_another_position().split(".")
        return {
            "row": run(talk, CLICKED % (key, 4, table)),
            "force": run(talk, CLICKED % ("R_24", 7, "force_comparison_7")),
            "wheel": run(talk, CLICKED % ("s_a", 1, "stage2_wheels")),
            "plan": run(talk, CLICKED % ("v_D", 7, "comparison_7")),
            "mass": run(talk, CLICKED % ("m", 2, "masses")),
            "defined": run(talk, "[...defining.keys()]"),
            "components": run(
                talk, "defining.delete('v_D'), definedBy('v_D', '7', 'rates_table').map(f => result(f).q)"
            ),
            "shown": run(
                talk, "[...new Set([...document.querySelectorAll('main [data-q]')].map(x => x.dataset.q))]"
            ),
        }


def test_a_click_on_another_position_starts_with_the_numbers_of_that_position():
    """What is worked out is of the position of the note, and is said to be; the numbers are those of the row."""
    told, position, name = data("compressor")["told"], 4, of_another_position()
    found = clicked()["row"]
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


def test_a_vector_of_a_comparison_is_told_by_the_plan_and_by_its_components():
    """v_D of a note that works out one formula of each kind: what is left out stands among those that are printed,
    behind the equation of the plan."""
    found, force = clicked()["plan"], clicked()["force"]
    assert "vDx = " in found["worked"] and found["where"].endswith("rates_table.v_D")
    said = found["formulas"]
    assert len(found["places"]) > 5 and said[-1].startswith("vD = pd·μv = ")
    assert said.index(next(one for one in said if one.startswith("v\u203eB"))) < [
        one[:3] for one in said
    ].index("vB ")
    assert len(force["places"]) > 3  # the equations of the force polygon are among them


def test_a_number_of_one_table_is_not_told_by_the_formula_of_another():
    """The mass of a link is given; that of a point into which links are substituted has a formula and the same key."""
    assert any(marks[-1][0] == "m" for *_, marks, _ in data("compressor")["told"]["left"])
    assert clicked()["mass"]["formulas"] == []


def test_a_vector_without_a_formula_stands_upon_those_of_its_components():
    assert clicked()["components"] == ["v_D_x", "v_D_y"]


def test_a_click_tells_formulas_that_the_note_leaves_out():
    """The thickness of the tips of a wheel, of which the note works out the other's: with all that leads to it, as
    `explain` has it."""
    told, whole = data("compressor")["told"], {text(one.item, Translator("ru")) for one in heard().formulas}
    left = {told["texts"][said]: marks for said, _, marks, _ in told["left"]}
    assert left.keys() <= whole
    line = next(said for said, marks in left.items() if marks[-1] == ["s_a", 1, "stage2_wheels"])
    shown = clicked()["wheel"]["formulas"]
    assert clicked()["wheel"]["all"].lstrip("×").startswith("sa5 – ")  # as the note calls that of its row
    assert line.replace("_", "").replace("^", "") in shown
    for key in ("d_a", "alpha_a", "d_b"):  # those of the same wheel, in front of it
        lead = next(said for said, marks in left.items() if marks[-1] == [key, 1, "stage2_wheels"])
        assert lead.replace("_", "").replace("^", "") in shown[:-1], key


def test_a_click_knows_the_formulas_of_the_whole_note():
    """Whatever formula `explain` has for a number of the page: of another position it is that of the first."""
    keys = {
        s.item.ref.key for s in heard().formulas if isinstance(s.item, Formula) and s.item.ref is not None
    }
    assert keys & set(clicked()["shown"]) <= set(clicked()["defined"])


@cache
def heard() -> Heard:
    results = solved("compressor")
    return listen(lambda page: list(parts(results, page)), results.variant.title, Translator("ru"))
