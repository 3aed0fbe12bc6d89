"""How wide what the note prints is: the same whichever markup it is written in, by which tables are divided alike."""

from __future__ import annotations

import pytest

from tmm_report.i18n import Translator
from tmm_report.quantity.symbols import math_symbol, notation
from tmm_report.report.formats import tex_escape
from tmm_report.report.paper import measure

KEYS = (
    "M_pr,PD,1", "P_fr,O", "A_+", "S'_E", "S''_E", "psi''_3", "a_A3A^r", "omega_2", "l_OA", "J_II", "vec:v_BA",
    "R_12^t", "T_fr",
)  # fmt: skip
UNITS = (
    "N·m",
    "kg·m²",
    "kg·m²/rad",
    "m/s²",
    "°",
    "−12,5; −0,03",
    "angle ↺, of 5 ° → 7 ° ± 1",
    "10⁻³ m",
    "a × b ≤ c",
)


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("key", KEYS)
def test_a_symbol_is_as_wide_in_both_markups(key, language):
    tr, symbol = Translator(language), math_symbol(key)
    html, tex = measure.widest_word(symbol.mathml(tr)), measure.widest_word(f"${symbol.latex(tr)}$")
    assert html > 0.5 and tex == pytest.approx(html, abs=0.005)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_number_with_its_unit_is_as_wide_in_both(language):
    tr = Translator(language)
    made = []
    for form in ("mathml", "latex"):
        written = notation(form, tr)
        made.append(written.number(-0.25710, 4) + written.unit("m"))
    html, tex = measure.mathematics(f"<math>{made[0]}</math>"), measure.mathematics(f"${made[1]}$")
    assert tex == pytest.approx(html, abs=0.005)


@pytest.mark.parametrize("text", UNITS)
def test_text_with_signs_is_as_wide_in_both(text):
    written = tex_escape(text)
    assert "$" in written
    assert measure.whole(written) == pytest.approx(measure.whole(text), abs=0.005)
    assert measure.widest_word(written) == pytest.approx(measure.widest_word(text), abs=0.005)


def test_a_long_word_has_the_room_that_letters_of_tex_take_in_either_script():
    """Where TeX has no Times, its own letters are wider; short words and numbers find room in the margins of a cell."""
    for word in ("Quantity", "Величина"):
        assert measure.whole(word) == pytest.approx(measure.WORDS * measure.letters(word))
    for word in ("mm", "0.1765", "−0.0047"):
        assert measure.whole(word) == pytest.approx(measure.letters(word))


def test_a_path_of_keys_breaks_behind_its_dots_and_any_other_long_word_at_even_distances():
    told = measure.breakable("c: governor.spring.stiffness, N/m")
    assert told == ["c: governor.", "spring.", "stiffness, N/m"]
    assert measure.breakable("x" * 30) == ["x" * 12, "x" * 12, "x" * 6]
    assert [len(one) for one in measure.breakable("a." + "x" * 28)] == [12, 12, 6]
