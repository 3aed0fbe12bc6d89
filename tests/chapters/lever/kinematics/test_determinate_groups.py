"""Every group has as many equations of equilibrium as unknown reactions: 3n = 2p5 + p4."""

import re

import numpy as np
import pytest
from conftest import LEVERS, solved
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.lever.structure import quantities as q
from tmm_report.chapters.lever.structure.view import KNOWN


@pytest.mark.exhaustive
def test_equations_of_every_group_are_as_many_as_its_unknowns():
    for path in LEVERS:
        found = solved(path.stem).lever.structure
        table = next(table for table in q.tables(found) if table.name == "groups")
        n, p5, p4, equations, unknowns = (
            np.asarray(table[key].values)
            for key in ("links_count", "lower", "higher", "equations", "unknowns")
        )
        assert np.all(equations == 3 * n) and np.all(unknowns == 2 * p5 + p4)
        assert np.all(equations == unknowns), path.stem
        # of the whole: the groups and the driving link with its pair make up the mechanism
        assert n.sum() + 1 == found.moving_links
        assert p5.sum() + 1 == found.lower_pairs and p4.sum() == found.higher_pairs


@pytest.mark.exhaustive
def test_every_kind_of_pair_is_told():
    for path in LEVERS:
        assert {pair.kind for pair in solved(path.stem).lever.structure.pairs} <= KNOWN.keys()


CAM = """language: en
mechanism:
  frame: {O: [0, 0], G: [6 mm, 0]}
  guides: {y: {through: G, angle: 90 deg}}
  links:
    1: {points: {O: 0}}
    2: {points: {B: 0}, slides: y}
  driver: {link: 1, speed: 12 rad/s, zero: {angle: 20 deg}}
  cams:
    k:
      follower: 2
      roller: {at: B, radius: 8 mm}
      base: 40 mm
      lift: 20 mm
      phases: [{rise: 100 deg, law: sine}, {dwell: 30 deg}, {return: 120 deg, law: sine}, {dwell: 110 deg}]
positions: {table: 12}
"""
WHEEL = """language: en
mechanism:
  frame: {O1: [0, 0], O2: [150 mm, 0]}
  links:
    1: {points: {O1: 0, A: 60 mm}}
    2: {points: {O2: 0, B: 40 mm}}
  wheels:
    - {links: [1, 2], teeth: [40, 20], module: 5 mm, angles: [0, 30 deg]}
  driver: {link: 1, speed: 120 rpm, zero: {angle: 25 deg}}
positions: {table: 12}
"""


def page(variant: str) -> str:
    return render(course.solve(loading.loads(variant)), "html", "en")["note.html"].decode()


def test_the_unknowns_that_the_note_counts_are_those_of_its_pairs():
    """A group with a higher pair has one unknown more than its lower pairs leave: its numbers stand in a table."""
    table, told = "Equations and unknowns of the groups", "unknowns: it is statically determinate"
    text = page(CAM)
    assert table in text and told not in text
    text = render(solved("crank_rocker"), "html", "en")["note.html"].decode()
    assert told in text and table not in text


def test_plans_of_a_mechanism_without_groups_are_referred_to():
    text = page(WHEEL)
    figures = re.findall(r'<figure id="(\w+)"', text)
    assert len(figures) > 3 and {one for one in figures if f'href="#{one}"' not in text} == set()
