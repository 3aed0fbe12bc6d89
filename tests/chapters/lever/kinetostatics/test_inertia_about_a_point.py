"""A moment of inertia stated about any point of a link."""

import pytest
from notes import note as note_of

from tmm_report import loading
from tmm_report.problems import ProblemError

TEXT = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2:
      points: {A: 0, B: 300 mm, S2: 100 mm}
      mass: 3 kg
      mass_centre: S2
      inertia: INERTIA
    3: {points: [B], mass: 1 kg, slides: x}
  driver: {link: 1, speed: 10 rad/s}
  assembly: {B: right}
loads: {}
"""


def rod(inertia):
    return loading.loads(TEXT.replace("INERTIA", inertia)).lever.mechanism.links["2"]


def mistakes(inertia, text=TEXT):
    with pytest.raises(ProblemError) as caught:
        loading.loads(text.replace("INERTIA", inertia))
    return caught.value.problems


@pytest.mark.parametrize(("about", "away"), [("A", 0.1), ("B", 0.2), ("S2", 0.0)])
def test_it_is_brought_to_the_mass_centre_by_steiner(about, away):
    link = rod(f"{{value: 0.5 kg*m^2, about: {about}}}")
    assert link.inertia == pytest.approx(0.5 - 3 * away**2) and link.stated == (about, 0.5)


def test_about_the_mass_centre_it_is_what_it_is_alone():
    assert rod("0.04 kg*m^2").inertia == 0.04 and rod("0.04 kg*m^2").stated is None
    assert rod("{value: 0.07 kg*m^2, about: A}").inertia == pytest.approx(0.04)


def test_a_point_mass_has_none_about_its_centre():
    """Exactly m l²: rounding makes no mistake of it."""
    assert rod("{value: 0.03 kg*m^2, about: A}").inertia == pytest.approx(0, abs=1e-15)


def test_less_than_the_mass_alone_makes_is_refused():
    (problem,) = mistakes("{value: 0.02 kg*m^2, about: A}")
    assert problem.path[-2:] == ("inertia", "value")
    assert "0.03" in problem.wrong.render(str) and "negative" in problem.wrong.render(str)


def test_a_point_of_another_link_is_refused():
    (problem,) = mistakes("{value: 0.5 kg*m^2, about: O}")
    assert problem.path[-1] == "about" and "O" in problem.wrong.render(str)


def test_without_a_mass_centre_there_is_nothing_to_bring_it_to():
    text = TEXT.replace("      mass: 3 kg\n      mass_centre: S2\n", "")
    (problem,) = mistakes("{value: 0.5 kg*m^2, about: A}", text)
    assert problem.path[-1] == "about" and "mass centre" in problem.wrong.render(str)


@pytest.mark.parametrize(
    "inertia", ["{value: 0.5 kg*m^2}", "{about: A}", "[0.5, A]", "{value: 0.5 kg, about: A}"]
)
def test_what_is_neither_a_moment_nor_a_moment_about_a_point_is_refused(inertia):
    assert len(mistakes(inertia)) == 1


@pytest.mark.exhaustive
def test_the_note_writes_steiner_out_in_numbers():
    """J1 = J1,O − m1 l²: the press states it about its pivot."""
    note = note_of("press", "html", "en")["note.html"].decode()
    assert 'data-q="J_about" data-k="0" data-t="masses"' in note and "Steiner" in note
    assert "Steiner" not in note_of("compressor", "html", "en")["note.html"].decode()
