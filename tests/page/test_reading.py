"""The readers of the page themselves: what they must see, and what they must not let through."""

from __future__ import annotations

import math

import pytest
from note import read
from printed import number, unit
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans

RESULTS = {
    "values": [{"key": "H_3", "value": 1.0507, "unit": "rad", "symbol": "ψ_3"}],
    "tables": {
        "outputs_table": {
            "columns": [
                {"key": "position", "unit": "", "values": [0, 1]},
                {"key": "psi_3", "unit": "rad", "symbol": "ψ_3", "values": [0.0, -0.11409]},
            ]
        },
        "comparison_2": {
            "columns": [
                {"key": "key", "unit": "", "values": ["v_A", "w_1"]},
                {"key": "unit", "unit": "", "values": ["m/s", "rad/s"]},
                {"key": "graph", "unit": "", "values": [1.131, -2.5]},
            ]
        },
    },
}
TABLE = """<main><div class="table whole" id="table1"><p class="caption">T</p><div class="wide"><table>
<thead><tr><th>Position</th>
<th><math><msub><mi>{symbol}</mi><mrow><mn>3</mn></mrow></msub></math>, {unit}</th></tr></thead>
<tbody><tr><td data-q="position" data-k="1" data-t="outputs_table">{position}</td>
<td data-q="psi_3" data-k="1" data-t="outputs_table" data-u="deg">{value}</td></tr></tbody>
</table></div></div></main>"""


def cells(symbol="ψ", unit="°", position="1", value="−6,537") -> list[str]:
    text = TABLE.format(symbol=symbol, unit=unit, position=position, value=value)
    return list(wrong_cells(read(text), RESULTS))


def test_a_right_cell_passes():
    assert not cells()


@pytest.mark.parametrize(
    "change",
    [{"symbol": "ω"}, {"unit": "рад"}, {"unit": "м"}, {"unit": "°/с"}, {"position": "2"}, {"value": "6,537"},
     {"value": "−6,538"}, {"value": "−0,11409"}, {"value": "—"}, {"value": "0"}],
)  # fmt: skip
def test_a_wrong_cell_is_told(change):
    assert len(cells(**change)) == 1


def formula(
    value: str, unit: str = "°", mark: str = 'data-q="H_3" data-u="deg"', letter: str = "ψ"
) -> list[str]:
    shown = (
        f"<main><p><math><msub><mi>{letter}</mi><mrow><mn>3</mn></mrow></msub><mo>=</mo>"
        f"<mn {mark}>{value}</mn><mtext>{unit}</mtext></math></p></main>"
    )
    note = read(shown)
    return [*wrong_formulas(note, RESULTS), *unmarked(note)]


def test_numbers_of_formulas():
    assert not formula("60,201")
    for wrong in (
        formula("60,202"), formula("60,201", "рад"), formula("1,0507"), formula("60,201", mark=""),
        formula("60,201", letter="φ"), formula("60,201", mark='data-q="H_4"'),
    ):  # fmt: skip
        assert len(wrong) == 1


@pytest.mark.parametrize(
    ("text", "count"), [("2,5</span> rad/s", 0), ("2,5</span> m/s", 1), ("−2,5</span> rad/s", 1)]
)
def test_numbers_in_running_text(text, count):
    mark = 'data-q="w_1" data-t="comparison_2" data-by="graph" data-abs="1"'
    assert len(list(wrong_spans(read(f"<main><p>is <span {mark}>{text}.</p></main>"), RESULTS))) == count


@pytest.mark.parametrize(
    ("text", "value", "half"),
    [("−41,888", -41.888, 0.0005), ("1,350·10⁻⁵", 1.35e-5, 5e-9), ("1.2·10⁶", 1.2e6, 5e4), ("0", 0.0, 0.5),
     ("123460", 123460.0, 5.0), ("180", 180.0, 0.5)],
)  # fmt: skip
def test_printed_numbers(text, value, half):
    assert number(text) is not None
    assert number(text)[:2] == pytest.approx((value, half))


def test_what_is_no_number():
    assert math.isnan(number("—").value)
    assert number("S2") is None and number("0–1") is None and number("x = 2") is None


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("м/с", "m/s"),
        ("(рад/с)/мм", "(rad/s)/mm"),
        ("Н·м", "N·m"),
        ("кг·м²", "kg·m²"),
        ("об/мин", "rpm"),
        ("°", "deg"),
    ],
)
def test_units_in_both_languages(one, other):
    assert (
        unit(one).factor == pytest.approx(unit(other).factor) and unit(one).dimension == unit(other).dimension
    )
    assert unit("guide") is None
