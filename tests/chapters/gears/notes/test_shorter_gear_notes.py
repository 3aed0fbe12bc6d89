"""Chapters of gears of the usual depth and short ones: what stands together, and what stands elsewhere."""

import re
from dataclasses import replace
from functools import cache

import pytest
from conftest import solved
from note import Note, Table, read

from tmm_report import render
from tmm_report.chapters.title.given import Note as Stated

FURTHER = {"x_min", "height", "alpha_a", "s_b", "rho_p", "root_sliding", "tip_sliding"}


@cache
def note(name: str, depth: str, **stated: tuple[str, ...]) -> Note:
    results = solved(name)
    given = replace(results.variant, note=Stated(depth=depth, **stated))
    return read(render(replace(results, variant=given), "html", "en")["note.html"].decode())


def table(page: Note, caption: str) -> Table:
    return next(one for one in page.tables if caption in one.caption)


def explained(page: Note) -> list[str]:
    """The lines of the explanations under formulas."""
    items = (node for node in page.root.iter("span") if node.get("class") == "item")
    return [re.sub(r"\s+", " ", "".join(node.itertext())).strip(" .;") for node in items]


@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "winch_drive"])
def test_external_loads_stand_in_the_rows_of_their_members(name):
    loads, found = solved(name).drive.loads, {}
    rows = table(note(name, "course"), "Speeds of all the members of the drive, external torques").rows
    for member, *cells in rows:
        of = {cell.mark.key: cell.printed for cell in cells if cell.mark and cell.mark.table == "drive_loads"}
        if of:
            found[member.text] = of
    assert list(found) == [row[0].text for row in rows if row[0].text in loads.torque]
    assert found.keys() == loads.torque.keys()
    for member, of in found.items():
        assert of["T"].value == pytest.approx(float(loads.torque[member]), abs=2 * of["T"].half)
        assert of["N"].value == pytest.approx(float(loads.power[member]), abs=2 * of["N"].half)


def test_what_the_table_of_a_pair_is_without_stands_where_it_is_told_to():
    """Short without it; at course in the one table; in the appendix by itself, and no row twice."""

    def keys(page: Note, caption: str) -> list[str]:
        rows = table(page, caption).rows
        return [next(cell.mark.key for cell in row if cell.mark) for row in rows]

    sizes = "imensions of the wheels of pair 4-5"
    whole = keys(note("compressor", "course"), sizes)
    short = keys(note("compressor", "short"), sizes)
    assert set(whole) - set(short) == FURTHER
    moved = note("compressor", "course", appendix=("spur.further",))
    assert keys(moved, "Dimensions of the wheels of pair 4-5") == short
    assert sorted(short + keys(moved, "Further dimensions of the wheels")) == sorted(whole)


def test_a_pair_that_keeps_the_rule_alone_is_told_to_once():
    """Wheel 4 is undercut by a hair, which the rule allows: the text says by how much, and that all else holds."""
    short, usual = (" ".join(note("compressor", depth).words) for depth in ("short", "course"))
    assert "All the other conditions of a sound pair are met." in short
    assert not [one for one in note("compressor", "short").tables if "Conditions of pair" in one.caption]
    assert len(table(note("compressor", "course"), "Conditions of pair 4-5").rows) == 9
    for text in (short, usual):
        assert text.count("0.0047 less than the exact limit") == 1
        assert "Not all the conditions are met:" not in text


def test_letters_are_explained_once_in_the_unit_of_their_formulas():
    """Given lengths stand in mm with what they are; of formulas in metres the explanations say metres."""
    page = note("winch_drive", "short")
    lines = explained(page)
    belt = lines[lines.index(next(one for one in lines if "diameter of the driven pulley" in one)) :]
    assert belt[0] == "where d2 — diameter of the driven pulley, m"
    assert not [one for one in belt if one.endswith(", mm")]
    assert "diameter of the driving pulley" not in " ".join(lines)
    assert [text for text in page.words if "Given: diameter of the driving pulley d_1=112 mm" in text]


def test_neighbours_of_one_meaning_are_explained_together():
    lines = explained(note("winch_drive", "short"))
    first = next(one for one in lines if "efficiency of the stage" in one)
    assert first.count(",") == 2  # η_12, η_34, η_56
