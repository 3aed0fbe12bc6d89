"""What the norm control reads, against what was drawn and written: lines, lettering, steps of both formats."""

from __future__ import annotations

from xml.etree.ElementTree import fromstring

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from notes import note

from tmm_report.figures.drawing import Drawing, svg
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.primitives import Arc, Circle, Path, Text
from tmm_report.lint import page, source
from tmm_report.lint.lettered import lettering, lines
from tmm_report.lint.numbers import read
from tmm_report.report.paper.measure import letters


def drawn(*items):
    return fromstring(svg(Drawing(items)).replace(' xmlns="http://www.w3.org/2000/svg"', ""))


@given(st.floats(-3, 3), st.floats(0.4, 6), st.booleans(), st.floats(5, 50))
def test_an_arc_is_read_as_it_was_drawn(start, turn, clockwise, radius):
    """Every point that is read lies on the circle, between the ends, and they reach all along it."""
    end = start - turn if clockwise else start + turn
    arc = Arc(3 + 4j, radius, start, end)
    found = lines(drawn(arc))
    places = np.append(found[:, 0], found[-1, 1]) - arc.centre
    assert np.allclose(abs(places), radius, atol=0.01 * radius)
    along = np.unwrap(np.angle(places))
    assert along[-1] - along[0] == pytest.approx(end - start, abs=0.1)  # near a half turn
    assert abs(np.diff(along)).max() < 0.35


def test_lines_and_circles_are_read_but_pale_ones():
    across, ring = Path(((0j, 10 + 5j),)), Circle(20 + 0j, 2.0)
    pale = Path(((0j, 9j),), across.pen.__class__(0.2, "pale"))
    found = lines(drawn(across, ring, pale))
    assert len(found) == 1 + 24 and found[0].tolist() == [0j, 10 + 5j]
    assert np.allclose(abs(found[1:] - 20), 2.0)


@pytest.mark.parametrize("align", [-1, 0, 1])
def test_lettering_takes_what_its_letters_take(align):
    """Less than the estimate that drawings are made by, and as wide as the advances of the face."""
    text = Text(7 + 3j, ("Положение ", Symbol("v", "BA", "n"), " = 5"), 3.2, align)
    (found,) = lettering(drawn(text))
    left, low, right, high = found.box
    box = text.box
    assert box[0] - 0.01 <= left < right <= box[2] + 0.01 and box[1] - 0.1 <= low < high <= box[3] + 0.1
    assert (left + right) / 2 - 7 == pytest.approx(-align * (right - left) / 2, abs=0.01)
    plain = Text(0j, ("Масштаб",), 2.8)
    (found,) = lettering(drawn(plain))
    assert found.text == "Масштаб" and found.box[2] - found.box[0] == pytest.approx(2.8 * letters("Масштаб"))


@pytest.mark.parametrize(
    ("text", "value", "half"),
    [
        ("−0,050", -0.05, 5e-4),
        ("1.25·10⁻³", 1.25e-3, 5e-6),
        ("6,9·10^-14", 6.9e-14, 5e-16),
        ("20650", 20650, 0.5),
    ],
)
def test_numbers_are_read_with_their_last_place(text, value, half):
    found = read(text)
    assert found and found.value == pytest.approx(value) and found.half == pytest.approx(half)


@pytest.mark.parametrize("text", ["", "S2", "1,2,3", "10⁵", "٣,٣", "1·10⁹⁹⁹", "1 2", "—"])
def test_what_is_no_number(text):
    assert read(text) is None


@pytest.mark.parametrize("name", ["governor_spring", "eccentric"])
def test_both_formats_take_the_same_steps(name):
    """Each is read by a reader of its own."""
    of_page = page.read(note(name, "html", "ru")["note.html"].decode()).steps
    of_source = source.read(note(name, "tex", "ru")["note.tex"].decode()).steps
    numbered = ("figure", "table", "formula")

    def told(steps, stands):
        return [step.anchor for step in steps if step.anchor.startswith(numbered) and step.stands == stands]

    assert told(of_page, False) == told(of_source, False)
    assert sorted(told(of_page, True)) == sorted(told(of_source, True)) and len(told(of_page, True)) > 20


def test_a_range_refers_to_all_within_it():
    assert page.between("figure9", ("figure", 6), False) == (["figure7", "figure8"], ("", 0))
    assert page.between("table-appendix2.4", ("table-appendix2.", 1), True)[0] == [
        "table-appendix2.2",
        "table-appendix2.3",
    ]
    assert page.between("figure900000", ("figure", 1), False)[0] == []


def test_captions_of_every_profile_are_read_side_by_side_too():
    """A stop, either dash, the number before the word; figures of one row."""
    tex = (
        "\\begin{document}\n"
        "\\begin{NoteFigure}{figure1}{Рисунок 1. Схема}\n"
        "\\begin{NoteInRow}{82.5mm}{figure2.1}{2.1-сурет – План}\n"
        "\\begin{NoteInRow}{82.5mm}{figure2.2}{2.2-сурет --- План}\n"
        "\\hypertarget{table1}{}%\n\\begin{NoteTable}{Таблица 1. Массы}{|c|}\n"
    )
    steps = [(step.anchor, step.name) for step in source.read(tex).steps]
    assert steps == [
        ("figure1", "Рисунок 1"), ("figure2.1", "2.1-сурет"), ("figure2.2", "2.2-сурет"), ("table1", "Таблица 1")
    ]  # fmt: skip
