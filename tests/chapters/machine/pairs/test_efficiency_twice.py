"""Every formula of machines joined against the powers through the modules, and against mechanics/pairs."""

import math

import pytest
from notes import VARIANTS
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.efficiency.view import EfficiencyView
from tmm_report.i18n import Translator
from tmm_report.mechanics.pairs import efficiency_chains
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

TEXTS = (
    "{series: [{efficiency: 0.9}, {name: gears, efficiency: 0.8}, {efficiency: 0.95}]}",
    "{output: 1 kW, parallel: [{output_share: 0.6, efficiency: 0.8}, {output_share: 0.4, efficiency: 0.5}]}",
    "{input: 10 kW, series: [{efficiency: 0.92}, {parallel: [{share: 0.6, efficiency: 0.8}, "
    "{share: 0.4, series: [{efficiency: 0.9}, {efficiency: 0.7}]}]}]}",
    "{parallel: [{share: 0.5, efficiency: 0.8}, {share: 0.5, parallel: [{output_share: 0.3, efficiency: 0.9}, "
    "{output_share: 0.7, efficiency: 0.7}]}]}",
    "{output: 500, series: [{efficiency: 0.9}]}",
)


def found_of(text):
    return course.solve(loading.loads(f"language: en\nefficiency: {text}\n")).efficiency


@pytest.mark.parametrize("text", TEXTS)
def test_every_formula_agrees_with_the_second_way(text):
    _agrees(found_of(text))


def test_every_formula_of_a_ready_variant():
    _agrees(course.solve(loading.load(VARIANTS / "machine_train.yaml")).efficiency)


def _agrees(found):
    """What comes out is what goes in less what all modules lose."""
    into, out = found.whole.power
    lost = math.fsum(part.lost for part in found.modules)
    ways = {"eta_whole": (into - lost) / into, "psi_whole": lost / into, "P_in_whole": out + lost,
            "P_out_whole": into - lost}  # fmt: skip
    assert disagreements(found.s, ways) == []
    view = EfficiencyView(found, Page(Html(), Translator("en"), Numbering()))
    for part, formula in zip(found.groups, view.groups(), strict=True):
        assert formula.value == pytest.approx(_chained(part), rel=1e-12) and formula.ref.key.startswith("eta")
    slope = view.slope()
    if slope is not None:
        assert slope.value == pytest.approx(found.first.slope, rel=1e-12)


def _chained(part):
    etas, shares = [one.efficiency for one in part.parts], [one.node.share for one in part.parts]
    if part.node.kind == "series":
        return efficiency_chains.in_series(etas)
    by = efficiency_chains.by_input if part.node.by == "input" else efficiency_chains.by_output
    return by(shares, etas)
