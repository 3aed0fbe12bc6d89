"""Numbers, gaps and heads as students write them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.intake.cells import header, is_blank, number


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("4.4437", 4.4437), ("4,4437", 4.4437), (" 12 ", 12), ("+0,5", 0.5), (".5", 0.5), (",5", 0.5), ("5,", 5),
        ("-3,5", -3.5), ("\u22123,5", -3.5), ("\u20133,5", -3.5), ("\u20143,5", -3.5), ("- 5", -5),
        ("\ufeff\u22125", -5),
        ("1 234,5", 1234.5), ("1\u2009234,5", 1234.5), ("1\xa0234\xa0567", 1234567), ("1\u202f234.5", 1234.5),
        ("1,5e3", 1500), ("1.5E+03", 1500), ("1,5е3", 1500), ("1,5Е-3", 0.0015), ("1,5·10³", 1500), ("1.5*10^3", 1500),
        ("1,5×10^-3", 0.0015), ("1,5 · 10⁻³", 0.0015), ("1,5х10^3", 1500), ("1,5·10^(−3)", 0.0015), ("'-5", -5),
        ("0", 0), ("007", 7),
    ],
)  # fmt: skip
def test_a_number_is_read_however_it_is_written(written, value):
    assert number(written) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    "written",
    [
        "", " ", "-", "+", ".", ",", "e5", "-e5", "nan", "NaN", ".nan", "inf", "-inf", "Infinity", "1e999",
        "1,5·10^999",
        "1" * 41, "1,234.5", "1.234.567", "12 34", "1 2345", "1_000", "0x1F", "12:30", "5 %", "4,4 м/с", "٣", "１２",
        "1,5·103", "1,5·10", "1e5·10^3", "--5", "1e", "1e5.5", "=1+1", "5-3", "True", "1 000 00", "н/д",
    ],
)  # fmt: skip
def test_what_is_no_number_is_nan(written):
    assert math.isnan(number(written))


@given(st.floats(allow_nan=False, allow_infinity=False), st.sampled_from([".", ","]))
def test_every_number_is_read_back_with_all_its_digits(value, sign):
    assert number(repr(value).replace(".", sign)) == value


@pytest.mark.exhaustive
@given(st.text(max_size=60))
def test_any_text_is_a_finite_number_or_none(text):
    assert not math.isinf(number(text))


@pytest.mark.parametrize(
    "text", ["", "  ", "-", "—", "–", "−", "н/д", "Н/Д", "n/a", "N/A", "нет", "Нет", "\xa0"]
)
def test_a_gap_is_seen(text):
    assert is_blank(text)
    assert math.isnan(number(text))


@pytest.mark.parametrize("text", ["0", "нету", "x", "--", "1", "-" * 1000])
def test_what_is_no_gap(text):
    assert not is_blank(text)


@pytest.mark.parametrize(
    ("head", "name", "unit"),
    [
        ("v_B, м/с", "v_B", "м/с"), ("v_B (m/s)", "v_B", "m/s"), ("S_B [мм]", "S_B", "мм"),
        ("ω2, рад/с", "ω2", "рад/с"),
        ("v_B", "v_B", ""), ("v_B, [м/с]", "v_B", "м/с"), ("  v_B ,  м/с ", "v_B", "м/с"), ("S_B,мм", "S_B", "мм"),
        ("", "", ""), ("\ufeffk", "k", ""), ("M_ур,\nН·м", "M_ур", "Н·м"), ("v_B (", "v_B (", ""), ("v_B,", "v_B", ""),
        ("(м)", "", "м"), ("k12_II2(2,3)", "k12_II2(2,3)", ""), ("k11_II2(2,3), м", "k11_II2(2,3)", "м"),
        ("v_B(м/с)", "v_B", "м/с"),
    ],
)  # fmt: skip
def test_a_head_is_a_name_and_a_unit(head, name, unit):
    assert header(head) == (name, unit)
