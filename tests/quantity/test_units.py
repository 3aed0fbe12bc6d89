"""Numbers with units, as students write them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.quantity import units

GOOD = [
    ("300 mm", "length", 0.3), ("300мм", "length", 0.3), ("7,5 см", "length", 0.075), ("−3 mm", "length", -0.003),
    (0.25, "length", 0.25), ("0.25", "length", 0.25), ("1e2 mm", "length", 0.1), ("1200 rpm", "speed", 40 * math.pi),
    ("1200 об/мин", "speed", 40 * math.pi), ("1200 об/хв", "speed", 40 * math.pi), ("5 рад/с", "speed", 5),
    ("5 1/s", "speed", 5), ("5 с⁻¹", "speed", 5), ("20 deg", "angle", math.pi / 9), ("20°", "angle", math.pi / 9),
    ("180 град", "angle", math.pi), ("0.0135 kg*m^2", "inertia", 0.0135), ("0,0135 кг·м²", "inertia", 0.0135),
    ("135 kg*cm^2", "inertia", 0.0135), ("1.2 MPa", "pressure", 1.2e6), ("3 N/mm^2", "pressure", 3e6),
    ("12 бар", "pressure", 1.2e6), ("9.81 m/s^2", "acceleration", 9.81), ("9,81 м/с2", "acceleration", 9.81),
    ("9.81 m*s^-2", "acceleration", 9.81), ("50 N*m", "moment", 50), ("50 Н м", "moment", 50),
    ("2 kN", "force", 2000), ("2 кН", "force", 2000), ("2 kg*m/s^2", "force", 2), ("5 %", "number", 0.05),
    ("50 ms", "time", 0.05), ("1.5 т", "mass", 1500), ("5 кгс", "force", 49.03325), ("5 kgf", "force", 49.03325),
    ("2 lb", "mass", 0.90718474), ("3 lbf", "force", 13.3446648457815), ("6 in", "length", 0.1524),
    ("2 ft", "length", 0.6096), ("2 Hz", "speed", 4 * math.pi), ("2 Гц", "speed", 4 * math.pi),
    ("100 psi", "pressure", 689475.7293168362),
    ("1 кгс/см²", "pressure", 98066.5), ("2 кгс·м", "moment", 19.6133), ("5 кн", "force", 5000),
    ("2 КВТ", "power", 2000), ("1,2 мпа", "pressure", 1.2e6), ("50 Н.м", "moment", 50), ("50 Нм", "moment", 50),
    ("50 Nm", "moment", 50), ("50 Н•м", "moment", 50), ("2 кНм", "moment", 2000), ("50 N-m", "moment", 50),
    ("1200 об./мин", "speed", 40 * math.pi), ("1200 об/мин.", "speed", 40 * math.pi), ("3 м/сек", "velocity", 3),
    ("1200 1/мин", "speed", 40 * math.pi), ("1200 мин⁻¹", "speed", 40 * math.pi), ("5 с-1", "speed", 5),
    ("1200 r/min", "speed", 40 * math.pi), ("0.05 сек", "time", 0.05),
    ("1/5", "number", 0.2), ("1 / 4,5", "number", 1 / 4.5), ("-0.3/2", "number", -0.15),
    ("3 turns", "angle", 6 * math.pi), ("1,5 оборота", "angle", 3 * math.pi), ("2 rev", "angle", 4 * math.pi),
    ("2/3", "number", 2 / 3), (" −1 / 80 ", "number", -0.0125), ("7/2", "angle", 3.5),
    ("36 kg * (150 mm)^2", "inertia", 0.81), ("36 кг·(15 см)²", "inertia", 0.81), ("2 t (1 m)**2", "inertia", 2000),
]  # fmt: skip

BAD = [
    ("1.5 kg", "length", "1.5 kg is a mass (kg); expected: a length (m)"),
    ("2 mm", "angle", "2 mm is a length (mm); expected: an angle (rad)"),
    ("3 kg*m", "length", "3 kg*m is in kg*m; expected: a length (m)"),
    ("20 rad", "number", "20 rad is an angle (rad); expected: a plain number (1)"),
    ("20 dB", "speed", "unknown unit dB; expected: an angular velocity (rad/s)"),
    ("1 m/s/s", "acceleration", "unknown unit m/s/s; expected: an acceleration (m/s^2)"),
    ("1/2/3", "number", "unknown unit /2/3; expected: a plain number (1)"),
    ("2/0", "number", "2/0: nothing can be divided by zero"),
    ("12:30", "time", "unknown unit :30; expected: a time (s)"),
    (".nan", "length", ".nan is not a number; expected: a length (m)"),
    ("inf", "length", "inf is not a number; expected: a length (m)"),
    ("1e999", "length", "1e999 is not a number; expected: a length (m)"),
    (math.nan, "length", "nan is not a number; expected: a length (m)"),
    (True, "length", "True is not a number; expected: a length (m)"),
    ("", "length", " is not a number; expected: a length (m)"),
    ([1], "length", "[…] is not a number; expected: a length (m)"),
    ("0x1F", "mass", "unknown unit x1F; expected: a mass (kg)"),
]


@pytest.mark.parametrize(("written", "dimension", "value"), GOOD)
def test_reads(written, dimension, value):
    assert units.parse(written, dimension) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("written", "dimension", "cure"),
    [
        ("1 200 rpm", "speed", "write 1200 rpm"),
        ("1 20 rpm", "speed", "for example, 1200 rpm"),
        ("1.2 x 10^3 kg", "mass", "write 1.2e3 kg"),
        ("1.2*10^3 rpm", "mass", "for example, 1.5 kg"),
        ("20 mm.", "length", "write 20 mm"),
        ("5 kn", "force", "write 5 kN"),
        ("1.2 Mpa/s", "force", "for example, 2 kN"),
        ("20 MM", "length", "write 20 mm"),
        ("20 mmm.", "length", "for example, 300 mm"),
    ],
)
def test_a_number_that_is_written_otherwise_is_told_as_it_is_read(written, dimension, cure):
    with pytest.raises(units.WrongValue) as caught:
        units.parse(written, dimension)
    assert str(caught.value.right) == cure


@pytest.mark.parametrize(("written", "dimension", "wrong"), BAD)
def test_refuses_naming_both_units(written, dimension, wrong):
    with pytest.raises(units.WrongValue) as caught:
        units.parse(written, dimension)
    assert str(caught.value.wrong) == wrong
    assert str(caught.value.right) == f"for example, {units.DIMENSIONS[dimension].example}"


@pytest.mark.parametrize(
    ("written", "dimension", "cure"),
    [
        ("50 kg", "force", "did you mean 50 kgf?"),
        ("1,5 кГ", "force", "did you mean 1.5 кгс?"),
        ("6 кг/см²", "pressure", "did you mean 6 кгс/см2?"),
        ("5 kg*m", "moment", "did you mean 5 kgf*m?"),
        ("3 kgf", "mass", "3 kgf is the weight of a mass of 3 kg"),
        ("2 kN", "mass", "2 kN is the weight of a mass of 203.943243 kg"),
        ("3 kgf", "length", "for example, 300 mm"),
        ("3 g", "force", "for example, 2 kN"),
    ],
)
def test_kilograms_of_force_and_of_mass_are_told_apart(written, dimension, cure):
    with pytest.raises(units.WrongValue) as caught:
        units.parse(written, dimension)
    assert str(caught.value.right) == cure


@pytest.mark.parametrize("dimension", units.DIMENSIONS)
def test_every_dimension_reads_its_own_example_and_unit(dimension):
    about = units.DIMENSIONS[dimension]
    assert units.parse(about.example, dimension) > 0
    if about.unit != "1":
        assert units.parse(f"1 {about.unit}", dimension) == 1


@given(st.floats(-1e9, 1e9), st.sampled_from(sorted(units.UNITS)))
def test_a_unit_scales_and_only_its_dimension_takes_it(number, unit):
    factor, exponents = units.UNITS[unit]
    for name, about in units.DIMENSIONS.items():
        if about.exponents == exponents:
            assert units.parse(f"{number!r} {unit}", name) == number * factor
        elif about.exponents[:3] != exponents[:3]:
            with pytest.raises(units.WrongValue):
                units.parse(f"{number!r} {unit}", name)


@given(
    st.text(max_size=80) | st.text("0123456789.,eE+-*/^ mkgNПаs°%", max_size=80),
    st.sampled_from(sorted(units.DIMENSIONS)),
)
def test_any_text_is_a_finite_number_or_a_wrong_value(text, dimension):
    try:
        assert math.isfinite(units.parse(text, dimension))
    except units.WrongValue as error:
        assert len(str(error)) < 220


# as students write them in cells, heads and rows of units
SPELLED = {
    ("m/s", 1.0): ("м/с", "м/сек", "м / с", "м·с⁻¹", "м*с^-1", "м/c", "(м/с)", "[м/с]", "m/sec"),
    ("m/s", 1e-3): ("мм/с", "мм/сек", "mm/s"),
    ("m/s²", 1.0): ("м/с²", "м/с2", "м/с^2", "м/с**2", "м/сек²", "м·с⁻²", "m/s/s", "m/s^2"),
    ("rad/s", 1.0): ("рад/с", "1/с", "с⁻¹", "с-1", "с^-1", "с^(-1)", "c⁻¹", "1/c", "рад/сек", "рад·с⁻¹", "s^-1"),
    ("rad/s", math.pi / 30): ("об/мин", "об./мин", "об/мин.", "rpm", "r/min", "мин⁻¹", "1/мин", "1/min"),
    ("rad/s²", 1.0): ("рад/с²", "1/с²", "1/с2", "с⁻²", "с^-2", "рад/с^2", "1/сек²"),
    ("N·m", 1.0): ("Н·м", "Н м", "Н.м", "Н. м", "Нм", "Н*м", "Н×м", "Н∙м", "Н•м", "Н-м", "Nm", "N m", "N.m", "Дж"),
    ("N", 1.0): ("Н", "н", "N"),
    ("N", 1e3): ("кН", "кн", "КН", "kN"),
    ("N", 9.80665): ("кгс", "kgf"),
    ("Pa", 98066.5): ("кгс/см²", "кгс/см2", "kgf/cm²"),
    ("kg·m²", 1.0): ("кг·м²", "кг м2", "кг*м^2", "кг.м²"),
}  # fmt: skip


@pytest.mark.parametrize(
    ("wanted", "spelled"), [(one, text) for one, texts in SPELLED.items() for text in texts]
)
def test_a_unit_is_known_in_any_usual_spelling(wanted, spelled):
    unit, factor = wanted
    assert units.between(spelled, unit) == pytest.approx(factor, rel=1e-15)
    assert units.is_unit(spelled)


@pytest.mark.parametrize("text", ["", "-", "положение", "v_B", "безразм.", "№", "м" * 50])
def test_a_word_is_no_unit(text):
    assert not units.is_unit(text)


@pytest.mark.parametrize(
    ("written", "wrong", "right"),
    [
        ("36 kg * (150 kg)^2", "150 kg is a mass (kg); expected: a length (m)", "for example, 300 mm"),
        ("36 mm * (150 mm)^2", "36 mm is a length (mm); expected: a mass (kg)", "for example, 1.5 kg"),
    ],
)
def test_of_a_product_the_part_that_is_wrong_is_told(written, wrong, right):
    with pytest.raises(units.WrongValue) as caught:
        units.parse(written, "inertia")
    assert (str(caught.value.wrong), str(caught.value.right)) == (wrong, right)
