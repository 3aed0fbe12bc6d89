import math
from decimal import ROUND_HALF_UP, Decimal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.quantity.paper import rounded
from tmm_report.quantity.text import column, number, round_significant, split, unit_text

sizes = st.floats(1e-12, 1e12).flatmap(lambda size: st.sampled_from([size, -size]))


@pytest.mark.parametrize(
    ("x", "options", "text"),
    [
        (9.4245, {}, "9,4245"),
        (9.4245, {"digits": 4}, "9,425"),
        (2.675, {"digits": 3}, "2,68"),
        (1.005, {"places": 2}, "1,01"),
        (0.1 + 0.2, {}, "0,3"),
        (0.3, {"keep_zeros": True}, "0,30000"),
        (12, {}, "12"),
        (12, {"keep_zeros": True, "digits": 2}, "12"),
        (-41.8879, {"decimal": "."}, "−41.888"),
        (9.99996, {}, "10"),
        (999999.9, {}, "1·10⁶"),
        (123456.0, {}, "123456"),
        (20646.5, {"digits": 4}, "20647"),
        (999999.4, {"digits": 2}, "999999"),
        (1234567.0, {"digits": 4}, "1,235·10⁶"),
        (0.0001, {}, "0,0001"),
        (0.0135, {}, "0,0135"),
        (-1.35e-5, {}, "−1,35·10⁻⁵"),
        (2.5e7, {"digits": 2}, "2,5·10⁷"),
        (1.8e-16, {}, "0"),
        (-1.8e-16, {}, "0"),
        (-0.0, {}, "0"),
        (1e-12, {"scale": 0}, "1·10⁻¹²"),
        (1e-6, {"scale": 2000}, "0"),
        (-0.004, {"places": 2, "keep_zeros": True}, "0,00"),
        (math.nan, {}, "—"),
        (-math.inf, {}, "−∞"),
    ],
)
def test_number(x, options, text):
    assert number(x, **options) == text


@given(sizes, st.integers(2, 9))
def test_a_printed_number_is_the_value_to_its_digits(x, digits):
    text = number(x, digits, scale=0)
    mantissa, _, power = text.replace("−", "-").replace(",", ".").partition("·10")
    exponent = int(power.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")) or 0)
    read = float(f"{mantissa}e{exponent}")
    assert "e" not in text and text != "-0"
    step = 10.0 ** (math.floor(math.log10(abs(x))) - digits + 1)
    step = min(step, 1.0) if abs(x) < 1e6 else step  # all digits before the point are printed
    assert abs(read - x) <= 0.5 * step * (1 + 1e-9) + abs(x) * 2e-12
    assert read == round_significant(x, digits)


@given(st.integers(1, 10**6), st.integers(-8, 8), st.integers(2, 6))
def test_rounding_is_half_up_on_the_decimal_digits(whole, power, digits):
    written = Decimal(whole).scaleb(power)
    place = written.adjusted() - digits + 1
    step = Decimal((0, (1,), min(place, 0) if written < 10**6 else place))
    expected = float(written.quantize(step, ROUND_HALF_UP))
    assert round_significant(float(written), digits) == expected
    assert round_significant(np.array([float(written), -float(written)]), digits).tolist() == [
        expected,
        -expected,
    ]


def test_arrays_keep_what_is_not_a_size():
    rounded = round_significant(np.array([[0.0, math.nan], [math.inf, 9.4245]]), 4)
    np.testing.assert_array_equal(rounded, [[0.0, math.nan], [math.inf, 9.425]])


def test_a_column_has_one_number_of_decimals():
    assert column([0, 8.1227, -12.7774, 1e-15, math.nan, 0.00001]) == ["0", "8,123", "−12,777", "0", "—", "0"]
    assert column([2105.48, 5.0], decimal=".") == ["2105.5", "5.0"]
    assert column([9.99999, 1.0]) == ["10,000", "1,000"]
    assert column([1e-5, 0]) == ["1·10⁻⁵", "0"]
    assert column([]) == []


def test_split_gives_parts_to_typeset():
    assert split(-1.35e-5) == (True, "1.35", -5)


@pytest.mark.parametrize(
    ("unit", "ru", "en"),
    [
        ("m/s", "м/с", "m/s"),
        ("kg*m^2", "кг·м²", "kg·m²"),
        ("N·m", "Н·м", "N·m"),
        ("rad/s²", "рад/с²", "rad/s²"),
        ("(m/s)/mm", "(м/с)/мм", "(m/s)/mm"),
        ("W", "Вт", "W"),
        ("rpm", "об/мин", "rpm"),
        ("deg", "°", "°"),
        ("%", "%", "%"),
        ("", "", ""),
    ],
)
def test_units_are_printed_in_the_language(unit, ru, en):
    assert (unit_text(unit, "ru"), unit_text(unit, "en")) == (ru, en)


def as_text(x: float, digits: int) -> float:
    """Rounding through the number's text: what rounding by arithmetic must equal to the last bit."""
    size = abs(x) * (1 + 1e-12)
    if 10 ** (digits - 1) <= size < 1e6:
        return math.copysign(float(Decimal(size).quantize(Decimal(1), ROUND_HALF_UP)), x)
    return float(f"{x * (1 + 1e-12):.{digits - 1}e}")


@given(st.floats(allow_nan=False, allow_infinity=False).filter(lambda x: abs(x) < 1e300), st.integers(1, 15))
def test_rounding_by_arithmetic_is_rounding_by_text(x, digits):
    assert round_significant(x, digits) == as_text(x, digits)


@given(st.integers(1, 10**7), st.integers(-12, 6), st.integers(1, 12), st.sampled_from([-1, 0, 1]))
def test_rounding_of_short_decimals_halves_and_their_neighbours(whole, power, digits, step):
    """Decimals such as 2.675, powers of ten, and the doubles beside them."""
    x = float(f"{whole}5e{power}") if digits % 2 else float(f"{whole}e{power}")
    x = math.nextafter(x, math.inf * step) if step else x
    assert round_significant(x, digits) == as_text(x, digits)


@pytest.mark.parametrize("power", range(-15, 16))
@pytest.mark.parametrize("digits", [1, 2, 5, 7, 12])
def test_rounding_beside_powers_of_ten(power, digits):
    ten = float(f"1e{power}")
    for x in (ten, math.nextafter(ten, 0), ten * (1 - 1e-13), ten * (1 - 1e-11), 9.5 * ten, 9.9999995 * ten):
        assert round_significant(x, digits) == as_text(x, digits)
        assert round_significant(-x, digits) == -as_text(x, digits)


@given(st.complex_numbers(max_magnitude=1e6, allow_nan=False), st.sampled_from([0.01, 0.1, 0.25, 1.0]))
def test_a_reading_is_the_same_alone_and_in_an_array(x, step):
    assert rounded(x, step) == rounded(np.array([x]), step)[0]
    assert rounded(x.real, step) == rounded(np.array([x.real]), step)[0]
