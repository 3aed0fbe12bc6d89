import math
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.i18n import Translator
from tmm_report.quantity import formula as f
from tmm_report.quantity.formula import PI, Formula, Inline, Term, Var, VectorEquation, agrees
from tmm_report.quantity.symbols import SHORT_WORDS, Symbol, math_symbol, segment
from tmm_report.quantity.text import round_significant

RU, EN = Translator("ru"), Translator("en")
POSITIONS = 3
pytestmark = pytest.mark.filterwarnings("ignore::RuntimeWarning")  # trees divide by zero: nan is printed


def xml(text):
    return ET.fromstring(f"<p>{text}</p>")


def visible(text):
    return "".join(xml(text).itertext())


def balanced(latex):
    plain = re.sub(r"\\[\\{}]", "", latex)
    depth = 0
    for sign in plain:
        depth += (sign == "{") - (sign == "}")
        assert depth >= 0
    return depth == 0 and latex.count("\\left") - latex.count("\\leftarrow") == latex.count("\\right")


numbers = st.floats(-1e5, 1e5).map(lambda x: x if abs(x) > 1e-3 else 0.0)
arrays = st.lists(numbers, min_size=POSITIONS, max_size=POSITIONS).map(np.array)
names = st.sampled_from(["v_B", "a_BA^n", "omega_2", "mu_v", "R_12^t", "F_I4", "M_bal", "vec:v_A", "l_AB'"])


@st.composite
def trees(draw, depth=3):
    """(expression, the same by numpy)."""
    kind = draw(
        st.sampled_from(
            ["var", "number", *(["+", "-", "*", "/", "^", "neg", "abs", "root", "sin"] * (depth > 0))]
        )
    )
    if kind == "var":
        value = draw(numbers | arrays)
        return Var(draw(names), value), value
    if kind == "number":
        value = draw(st.integers(-20, 20))
        return f.Number(value), float(value)
    left, x = draw(trees(depth=depth - 1))
    if kind in "+-*/":
        right, y = draw(trees(depth=depth - 1))
        both = {
            "+": lambda a, b: a + b,
            "-": lambda a, b: a - b,
            "*": lambda a, b: a * b,
            "/": lambda a, b: a / b,
        }[kind]
        return both(left, right), np.divide(x, y) if kind == "/" else both(x, y)
    return {
        "^": (left**2, np.square(x)),
        "neg": (-left, np.negative(x)),
        "abs": (abs(left), np.abs(x)),
        "root": (f.sqrt(abs(left)), np.sqrt(np.abs(x))),
        "sin": (f.sin(left), np.sin(x)),
    }[kind]


@pytest.mark.exhaustive
@given(trees(), st.integers(0, POSITIONS - 1), st.sampled_from([RU, EN]), st.booleans())
def test_any_tree_evaluates_as_numpy_and_prints_well_formed(tree, index, tr, hand):
    expression, expected = tree
    with np.errstate(all="ignore"):
        formula = Formula("a_BA^n", expression, "m/s²", index=index, hand=hand)
        # a whole number 0 has no sign, so neither has an infinity made with it
        finite = np.isfinite(expected)
        ours, theirs = np.where(finite, formula.value, 0.0), np.where(finite, expected, 0.0)
        np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-300)
        latex, mathml = formula.latex(tr), formula.mathml(tr)
    assert balanced(latex)
    text = visible(mathml)
    assert not re.search(r"\de[+-]?\d|[=(·][-−]0( ?=|\)|\\right|м|m|\\;)", f"{text}={latex}")
    assert not re.search(r">[+−·]</mo>(<mrow>)*<mo[^>]*>[+−]", mathml), (
        "a negative number after an operator stands in brackets"
    )


def test_the_printed_chain():
    formula = Formula("omega_1", 2 * PI / Var("T", 0.05, "s"), "rad/s")
    assert formula.latex(RU) == (
        r"\omega _{1}=\frac{2\pi }{T} =\frac{2\cdot 3{,}1416}{0{,}05} =125{,}66\;\text{рад}/\text{с}"
    )
    assert formula.latex(EN).endswith(r"\frac{2\cdot 3.1416}{0.05} =125.66\;\text{rad}/\text{s}")
    assert "<mn>125,66</mn>" in formula.mathml(RU)
    plan = Formula("v_B", Var("mu_v", 0.075) * Var(segment("pb"), 59.25, "mm"), "m/s")
    assert plan.latex(RU).startswith(r"v_{B}=\mu _{v}\cdot \overline{pb} =0{,}075\cdot 59{,}25 =4{,}4438\;")


@pytest.mark.parametrize(
    ("expression", "symbols", "numbers_"),
    [
        (Var("a", 1.0) - Var("b", -2.0), "a -b", r"1 -\left(-2\right)"),
        (Var("a", 1.0) * Var("b", -2.0), r"a\cdot b", r"1\cdot \left(-2\right)"),
        (Var("a", -1.0) * Var("b", 2.0), r"a\cdot b", r"-1\cdot 2"),
        (Var("a", 1.0) * (Var("b", 2.0) + 3), r"a\cdot \left(b+3\right)", r"1\cdot \left(2+3\right)"),
        (Var("a", -3.0) ** 2, "a^{2}", r"\left(-3\right)^{2}"),
        (Var("a_B^n", 3.0) ** 2, r"\left(a_{B}^{n}\right)^{2}", "3^{2}"),
        (Var("s′", 3.0) ** 2, r"\left(s{}^{\prime}\right)^{2}", "3^{2}"),
        (
            (Var("a", 3.0) / Var("b", 4.0)) ** 2,
            r"\left(\frac{a}{b}\right)^{2}",
            r"\left(\frac{3}{4}\right)^{2}",
        ),
        (-(Var("a", 1.0) + Var("b", 2.0)), r"-\left(a+b\right)", r"-\left(1+2\right)"),
        (
            f.cos(Var("phi_2", math.pi / 6, "deg")),
            r"\operatorname{cos}\varphi _{2}",
            r"\operatorname{cos}30^{\circ}",
        ),
        (
            f.tan(Var("a", 1.0) / 2),
            r"\operatorname{tg}\left(\frac{a}{2}\right)",
            r"\operatorname{tg}\left(\frac{1}{2}\right)",
        ),
        (2 * Var("a", 3.0) ** 2, "2a^{2}", r"2\cdot 3^{2}"),
        (2 * Var("a", 1e-7, digits=2), "2a", r"2\cdot 1\cdot 10^{-7}"),
        (Var("a", 2e-5) ** 2, "a^{2}", r"\left(2\cdot 10^{-5}\right)^{2}"),
    ],
)
def test_brackets_and_dots(expression, symbols, numbers_):
    sides = Formula("x", expression, scale=0).latex(RU).split("=")
    assert [side.strip() for side in sides[1:3]] == [symbols, numbers_]


def test_sum_of_terms():
    assert sum([Var("a", 1.0), Var("b", 2.0)]).value == 3.0


def test_the_sample_position_is_printed_and_all_are_computed():
    omega = np.array([[0.0, -41.888, -36.79]])
    formula = Formula("a_BA^n", Var("omega_2", omega) ** 2 * Var("l_AB", 0.3), "m/s²", index=2)
    np.testing.assert_allclose(formula.value, omega**2 * 0.3)
    assert r"\left(-36{,}79\right)^{2}\cdot 0{,}3 =406{,}05\;" in formula.latex(RU)
    with pytest.raises(ValueError, match="one position"):
        Formula("a", Var("omega_2", omega)).latex(RU)


def test_noise_beside_large_values_prints_zero():
    formula = Formula("v_B", Var("v", np.array([-3e-7, 2000.0])) * 1, index=0)
    assert formula.latex(RU) == r"v_{B}=v\cdot 1 =0\cdot 1 =0"


@given(st.lists(st.floats(0.01, 1e4), min_size=2, max_size=2), st.integers(3, 6))
def test_by_hand_a_calculator_agrees(pair, digits):
    a, b = pair
    formula = Formula("x", Var("a", a) * Var("b", b), digits=digits, hand=True)
    assert formula.written == round_significant(
        round_significant(a, digits) * round_significant(b, digits), digits
    )
    assert formula.value == a * b


def test_by_hand_angles_are_rounded_in_degrees():
    formula = Formula("x", f.sin(Var("phi", math.radians(30.0001), "deg")), digits=3, hand=True)
    assert formula.written == 0.5
    angle = Formula("phi", f.arccos(Var("c", 0.5)), "deg", digits=3)
    assert angle.latex(RU).endswith(r"=60^{\circ}") and angle.written == pytest.approx(math.pi / 3)


def test_agreement_with_the_solver():
    formula = Formula("x", Var("a", np.array([1.0, math.nan, 1000.0])))
    assert agrees(formula, np.array([1.0, math.nan, 1000.0 + 1e-7]))
    assert not agrees(formula, np.array([1.0, math.nan, 1000.1]))
    assert not agrees(formula, np.array([1.0, 2.0, 1000.0]))
    assert not agrees(formula, np.array([-1.0, math.nan, 1000.0]))


@pytest.mark.parametrize(
    ("key", "latex"),
    [
        ("v_B", "v_{B}"),
        ("a_BA^n", "a_{BA}^{n}"),
        ("a_BA_n", "a_{BA}^{n}"),
        ("omega_2", r"\omega _{2}"),
        ("M_bal", r"M_{\text{ур}}"),
        ("M_Кривошип", r"M_{\text{Кривошип}}"),
        ("vec:R_12^t", r"\overline{R}_{12}^{t}"),
        ("v_B'", r"v_{B{}^{\prime}}"),
        ("DeltaT", r"\Delta T"),
    ],
)
def test_keys_of_symbols(key, latex):
    assert math_symbol(key).latex(RU) == latex
    assert ET.fromstring(math_symbol(key).mathml(RU)).tag == "math"


def test_a_key_needs_a_base():
    with pytest.raises(ValueError, match="key"):
        math_symbol("_B")


@pytest.mark.parametrize(
    "name", ["<script>", "&amp;", '"x"', "\\input{x}", "}", "$", "%", "a\0b", "日本", "_^~#", "B''"]
)
def test_names_from_users_are_escaped(name):
    term = Term(Symbol("v", sub=name), 2, note=name)
    printables = [
        Symbol("v", sub=name, sup=name, bar=True),
        Symbol(name),
        segment(name),
        VectorEquation([[term], []]),
        Formula(Symbol(name), Var(Symbol("v", name), 1.0), name),
    ]
    for printable in printables:
        mathml, latex = printable.mathml(RU), printable.latex(RU)
        assert {element.tag for element in xml(mathml).iter()} <= TAGS
        assert balanced(latex)
        assert "\\input" not in latex and latex.isprintable() and not re.search(r"(?<!\\)[$%#&]", latex)


TAGS = set(
    re.findall(r"\w+", "p wbr math mrow mi mn mo mtext mspace msub msup msubsup mover munder mfrac msqrt")
)


def test_vector_equation():
    equation = VectorEquation(
        [[Term("v_B", 1, "∥ OB")], [Term("v_A", 2, "⟂ OA"), Term("v_CD", negative=True)], []]
    )
    assert equation.latex(RU) == (
        r"\underset{\parallel OB}{\underline{\overline{v}_{B}}}"
        r" =\underset{\perp OA}{\underline{\underline{\overline{v}_{A}}}} -\overline{v}_{CD} =0"
    )
    text = equation.mathml(RU)
    assert visible(text).replace("‾", "") == "vB∥OB=vA⟂OA−vCD=0"
    assert text.count("border-bottom:0.2em double") == 1 and text.count("border-bottom:0.06em solid") == 1


def test_inline():
    assert Inline("v_B", 4.4438, "m/s").latex(EN) == r"v_{B}=4.4438\;\text{m}/\text{s}"
    assert visible(Inline("phi", -0.5, "deg").mathml(RU)) == "φ=−28,648°"


# --- indices ---


@pytest.mark.parametrize(
    ("key", "written"),
    [
        ("d_ai", "d_{ai}"),  # letters side by side, each italic
        ("rho_pi", "\\rho _{pi}"),  # the point p of wheel i, not the number
        ("epsilon_alpha", "\\varepsilon _{\\alpha }"),
        ("M_fr", "M_{\\text{тр}}"),  # a word, upright and translated
        ("omega_max", "\\omega _{\\text{max}}"),
        ("pi", "\\pi "),
    ],
)
def test_an_index_is_letters_or_a_word(key, written):
    assert math_symbol(key).latex(RU) == written


def test_every_short_word_of_an_index_is_known_as_one():
    declared = {
        word
        for path in (Path(__file__).parents[2] / "tmm_report").rglob("*.py")
        for word in re.findall(r'NP_\("index", "([a-z]{2})"\)', path.read_text("utf-8"))
    }
    assert declared == SHORT_WORDS


def test_a_zero_is_not_divided_in_print():
    formula = Formula("omega_2", Var("v_BA", 0.0, "m/s") / Var("l_AB", 0.09, "m"), "rad/s")
    assert "0{,}09" not in formula.latex(RU) and formula.latex(RU).endswith("=0\\;\\text{рад}/\\text{с}")
    whole = Formula("omega_2", Var("v_BA", 0.9, "m/s") / Var("l_AB", 0.09, "m"), "rad/s")
    assert "0{,}09" in whole.latex(RU)
