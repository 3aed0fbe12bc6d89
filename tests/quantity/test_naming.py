"""Names of quantities as people write them."""

from __future__ import annotations

import pytest
from conftest import ALL_FILES, solved
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.i18n import Translator
from tmm_report.problems import Message, ProblemError
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.naming import LONGEST, fold, nearest, one, resolve
from tmm_report.quantity.symbols import Symbol
from tmm_report.results import tables, values


def quantities(name):
    """Every quantity of a ready variant, as often as it stands in the results."""
    found = solved(name)
    return [v.quantity for v in values(found)] + [c.quantity for t in tables(found) for c in t.columns]


def by_positions(name):
    """The quantities of the tables by positions, and the single values: what a student is asked for."""
    found = solved(name)
    columns = [c for t in tables(found) if "position" in t for c in t.columns if c.asked]
    return [c.quantity for c in columns], [v.quantity for v in values(found)]


@pytest.fixture(scope="module")
def compressor():
    return quantities("compressor")


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ("v_B", "v_B"),
        ("vB", "v_B"),
        ("v_{B}", "v_B"),
        (" v_B ", "v_B"),
        ("v_В", "v_B"),  # the point's name in Cyrillic
        ("V_B", "V_B"),  # of the slider, with its sign
        ("VB", "V_B"),
        ("R12", "R_12"),
        ("r_12", "R_12"),
        ("R₁₂", "R_12"),
        ("ω2", "w_2"),
        ("ω_2", "w_2"),
        ("ω₂", "w_2"),
        ("w_2", "w_2"),
        ("w2", "w_2"),
        ("omega_2", "w_2"),
        ("Omega2", "w_2"),
        ("ε4", "e_4"),
        ("epsilon_4", "e_4"),
        ("a_BA^n", "a_BA_n"),
        ("aBAn", "a_BA_n"),
        ("a_BAⁿ", "a_BA_n"),
        ("a_BA^τ", "a_BA_t"),
        ("M_bal", "M_bal"),
        ("M_ур", "M_bal"),
        ("М_ур", "M_bal"),  # М in Cyrillic
        ("Mур", "M_bal"),
        ("m_bal", "M_bal"),
        ("M_ур_max", "M_bal_max"),
        ("M_lever", "M_lever"),
        ("µ_l", "mu_l"),
        ("μl", "mu_l"),
        ("I_пр", "I_red"),
        ("H_B", "H_B"),
    ],
)
def test_a_quantity_is_found_by_every_way_to_write_it(text, key):
    columns, single = map(
        lambda one, other: [*one, *other], by_positions("compressor"), by_positions("piston_pump")
    )
    known = columns if resolve(text, columns) else single  # columns first: of ω2 there are extremes too
    assert [quantity.key for quantity in resolve(text, known)] == [key]
    assert one(text, known).key == key


@pytest.mark.parametrize("name", [file.stem for file in ALL_FILES])
def test_every_key_names_itself_and_nothing_else(name):
    known = quantities(name)
    for key in {quantity.key for quantity in known}:
        assert [quantity.key for quantity in resolve(key, known)] == [key]


@pytest.mark.exhaustive
@pytest.mark.parametrize("language", ["ru", "en"])
def test_a_symbol_finds_quantities_that_are_written_so_or_keyed_so(language):
    word = Translator(language).pgettext("index", "bal")
    columns, single = by_positions("compressor")
    known = [q for q in (*columns, *single) if q.symbol is not None]
    for quantity in known:
        found = resolve(str(quantity.symbol).replace("bal", word), known)
        assert found, quantity.key
        written = fold(str(quantity.symbol))
        assert all(written in (fold(str(q.symbol)), fold(q.key)) for q in found)


def of(*keys):
    return [Quantity(key, Symbol(*key.split("_")), "", Message("a quantity")) for key in keys]


def test_case_decides_only_where_there_is_a_choice():
    assert [q.key for q in resolve("vb", of("v_B"))] == ["v_B"]
    assert [q.key for q in resolve("vb", of("v_B", "V_B"))] == ["v_B", "V_B"]
    assert [q.key for q in resolve("VB", of("v_B", "V_B"))] == ["V_B"]


def test_what_may_mean_several_is_refused_with_all_of_them():
    with pytest.raises(ProblemError, match="vb may mean several quantities; write one of v_B, V_B"):
        one("vb", of("v_B", "V_B"))


def test_an_unknown_name_is_refused_with_the_nearest_and_the_list(compressor):
    with pytest.raises(ProblemError) as caught:
        one("v_BB", compressor, ("answers", "v_BB"))
    text = caught.value.problems[0].text()
    assert text.startswith("answers.v_BB: no quantity is called v_BB; the nearest: v_B")
    assert "results.json" in text


def test_what_is_like_nothing_is_refused_with_the_list_alone(compressor):
    with pytest.raises(ProblemError, match="no quantity is called %%%; every quantity stands"):
        one("%%%", compressor)


@pytest.mark.parametrize("text", ["", "   ", "_", "^", "\u202e", "\N{RIGHT-TO-LEFT MARK}v_Bx", "v" * 10**6])
def test_hostile_and_empty_names_mean_nothing(text, compressor):
    assert resolve(text, compressor) == []
    with pytest.raises(ProblemError) as caught:
        one(text, compressor)
    assert "\u202e" not in str(caught.value) and len(str(caught.value)) < 400


def test_the_nearest_names_are_keys_without_repeats(compressor):
    near = nearest("vD2", compressor)
    assert near and len(near) == len(set(near)) and set(near) <= {q.key for q in compressor}


@given(st.text(max_size=LONGEST))
def test_folding_a_folded_name_changes_nothing(text):
    once = fold(text)
    assert fold(once) == once


@given(st.text(max_size=2 * LONGEST))
def test_any_text_names_at_most_what_is_known(text):
    known = of("v_B", "V_B", "w_2", "R_12")
    found = resolve(text, known)
    assert all(quantity in known for quantity in found)
