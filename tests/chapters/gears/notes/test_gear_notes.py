"""What a note says of gears that fail, and how it prints sizes and readings: read as a student reads them."""

import math
import re
from functools import cache

import pytest
from notes import render

from tmm_report import solve
from tmm_report.loading import loads

FAILED = """
language: en
drive:
  speed: 3000 rpm
  stages:
    - {kind: spur, ratio: 2.5, module: 2 mm, teeth: [24, 60], shift: [0.3, 0.3],
       tip_shortening: false}
    - {kind: spur, ratio: -1, module: 10 mm, teeth: [10, 10], shift: [0, 0]}
"""
PLANETARY = """
language: en
drive:
  speed: 3000 rpm
  stages:
    - {kind: planetary, scheme: external-internal, ratio: 5, module: 2 mm, teeth: [14, 19, 17, 50], satellites: 3,
       input: wheel1, output: carrier, fixed: wheel3, rack: {ha*: 0.8, c*: 0.3}}
"""


@cache
def html(text: str) -> str:
    return render(solve(loads(text)), "html")["note.html"].decode()


def plain(markup: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", markup))


def section(heading: str, note: str) -> str:
    """What stands under the first heading of this name, to the next heading."""
    return re.split(r"<h\d", note.split(f"{heading}</h", 1)[1], maxsplit=1)[0]


@pytest.mark.exhaustive
def test_the_conditions_that_are_not_met_come_first_in_the_conclusions():
    said = plain(html(FAILED).rpartition("Conclusions</h")[2])
    places = [said.index(f"Not all conditions of the gear pair {name}") for name in ("1-2", "3-4")]
    assert max(places) < said.index("The ratio of the gear drive is")


@pytest.mark.exhaustive
def test_the_contact_of_an_undercut_pair_ends_where_its_involutes_do():
    """By the tip circles it would pass the end of the line of action, where the sliding has no bound."""
    note = plain(html(FAILED))
    assert note.count("By the tip circles alone, as if the involutes reached so far") == 2
    assert "such a pair must not be made" not in note
    assert re.search(r"the involute of wheel 3 begins at the radius of curvature 5\.0576 mm", note)


@pytest.mark.exhaustive
def test_what_a_point_outside_the_contour_lacks_is_in_modules():
    """The letter of the module is a symbol: an upright m would be metres."""
    note = section("Blocking contour", html(FAILED))
    (lack,) = re.findall(r"the active profile reaches (.*?) along the line", note)
    number, sign = re.fullmatch(r"<span[^>]*>([\d.]+)</span>·(<math.*</math>)", lack).groups()
    assert "<mi>m</mi>" in sign
    head, tip = math.sqrt(58.6**2 - (60 * math.cos(math.radians(20))) ** 2), 36 * math.sin(math.radians(20))
    start = 24 * math.sin(math.radians(20)) - 2 * 0.7 / math.sin(math.radians(20))
    assert float(number) == pytest.approx((start - (head - tip)) / 2, abs=6e-5)


@pytest.mark.exhaustive
def test_readings_have_as_many_decimals_as_their_differences_need():
    """At 10:1 a place is read to 0.001 mm of the wheels: both lengths are printed one digit finer."""
    note = html(FAILED)
    table = note[: note.index("Values read off the drawing of pair 3-4")]
    table = table[table.rindex("Values read off the drawing of pair 1-2") :].partition("</table>")[0]
    rows = [re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.DOTALL) for row in table.split("<tr>")[2:]]
    read = [[plain(cell).strip(" °") for cell in row[1:4]] for row in rows]
    assert len(read) >= 8
    for drawn, computed, difference in read:
        assert len(drawn.partition(".")[2]) == len(computed.partition(".")[2])
        a, b = float(drawn), float(computed)
        assert float(difference) == pytest.approx(200 * abs(a - b) / (a + b), abs=2.5e-3)


def test_sizes_of_one_row_have_the_same_decimals_where_their_digits_allow():
    (row,) = re.findall(r"<tr><td>base diameter</td>.*?</tr>", html(PLANETARY))
    assert re.findall(r"\d+\.\d+", plain(row)) == ["26.311", "35.708", "31.950", "93.969"]


def test_the_usual_form_of_the_condition_of_assembly_has_a_number_of_its_own():
    """396 by the teeth, 792 with eleven turns of the carrier: two numbers, two symbols."""
    note = plain(section("Conditions of the planetary stage", html(PLANETARY)))
    assert re.search(r" C = z 1[^|]*= 396 ", note) and re.search(r" C ′ = .*= 792 ", note)
