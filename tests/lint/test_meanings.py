"""A letter stands for one thing in a chapter, and in one line of the list of symbols; every statement has its note."""

import pytest
from conftest import STATEMENTS
from exhaustive import many
from meanings import faults, listed
from notes import NAMES, STATED, note

EVERY = sorted({*STATED.values(), *(path.stem for path in STATEMENTS)})


@pytest.mark.parametrize("name", NAMES)
def test_a_letter_means_one_thing(name):
    found = list(faults(note(name, "html")["note.html"].decode()))
    assert not found, "\n".join(found)


@pytest.mark.parametrize("name", many(EVERY))
def test_a_letter_of_a_statement_means_one_thing(name):
    found = list(faults(note(name, "html")["note.html"].decode()))
    assert not found, "\n".join(found)


def line(letter: str, said: str) -> str:
    return f"<p><math>{letter}</math> – {said}</p>"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ([line("m", "module, mm (section 9.2); mass, kg (section 7)"), line("J", "moment")], 0),
        ([line("m", "mass, kg"), line("m", "module, mm")], 1),
        ([line("m", "module, mm (section 9.2); mass, kg (section 9.4)")], 1),
        ([line("J", "moment of inertia (section 2); moment of a force (section 3)")], 1),
        ([line("m", "mass of a belt (section 2.1); mass of a body (section 2.2)")], 0),
    ],
)
def test_what_is_told(lines, told):
    page = '<h1>2 Friction in single pairs</h1><div class="symbols">' + "".join(lines) + "</div>"
    assert len(listed(page)) == len(lines)
    assert len(list(faults(page))) == told
