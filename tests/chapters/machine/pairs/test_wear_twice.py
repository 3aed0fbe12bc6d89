"""Every formula of the wear against the arrays of the program, and every definition printed in symbols against its
tables."""

import numpy as np
import pytest
from notes import VARIANTS
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.wear import equations, quantities
from tmm_report.chapters.machine.wear.view import GuideView
from tmm_report.i18n import Translator
from tmm_report.mechanics.pairs import wear
from tmm_report.report.diagrams import letter
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

PUMP = VARIANTS.joinpath("slider_crank_offset.yaml").read_text(encoding="utf-8").split("\nbalancing:")[0]
FORGED = VARIANTS.joinpath("forging_machine_wear.yaml").read_text(encoding="utf-8")
GUIDE = "wear:\n  guides:\n    - {guide: x, length: 90 mm, width: 40 mm, cycles: 1e6, coefficient: 1e-15}\n"
PIVOT = "wear:\n  pivots:\n    - {pivot: A, journal: 1, diameter: 4 cm, width: 3 cm, cycles: 1e6, coefficient: 1e-15}\n"
TEXTS = {
    "forged": FORGED,
    "coarse": FORGED.replace("parts: 100", "parts: 37").replace("wear:\n", "wear:\n  positions: 96\n", 1),
    "straight": f"{PUMP}\n{GUIDE}",
    "skewed": f"{PUMP}\n{GUIDE.replace('90 mm', '90 mm, middle: 12 mm, limit: 0.5 mm, density: 7800')}",
    "pivot": f"{PUMP}\n{PIVOT}",
    "uniform": f"{PUMP}\n{PIVOT.replace('4 cm', '4 cm, law: uniform, arc: 70 deg, limit: 0.2 mm, density: 7800')}",
}


@pytest.fixture(params=TEXTS, scope="module")
def found(request):
    return course.solve(loading.loads(TEXTS[request.param])).wear


def test_every_formula_agrees_with_the_second_way(found):
    told = [disagreements(one.s, _of_guide(one)) for one in found.guides]
    told += [disagreements(one.s, _of_pivot(one)) for one in found.pivots]
    assert told == [[]] * len(told)


def _of_guide(one):
    given, worst = one.given, one.worst_guide
    length = np.ptp(one.grid.x)
    ways = {
        "length": length, "step": length / given.parts, "ratio": given.length / (length / given.parts),
        "time": given.cycles * one.period / 3600, "rate": 1e6 * float(one.worn(np.array(3600.0))),
        "mass": (given.density or 0.0) * sum(one.volume(face) for face in one.surfaces),
    }  # fmt: skip
    if given.running_in is not None:
        ways["rate"] = 1e6 * one.rate * 3600
    if one.even:  # of an even wear as deep as the greatest
        ways["uneven"] = worst.greatest * np.count_nonzero(worst.depth) / worst.depth.sum()
    if one.life is not None:
        assert float(one.worn(np.array(one.life))) == pytest.approx(given.limit, rel=1e-9)
        ways |= {"life": one.life / 3600, "life_cycles": one.life / one.period}
    return ways


def _of_pivot(one):
    given = one.given
    ways = {"spread": wear.spread(given.arc / 2, given.law)}
    return ways if given.limit is None else ways | {"life_cycles": one.life}


def test_formulas_of_rows_give_what_the_tables_say(found):
    for one in found.guides:
        tables = _tables(quantities.guide_tables(one))
        surfaces, profile = tables["surfaces"], tables["profile"]
        formulas = [
            equations.couple(one, tables["cycle"]), equations.deepest(one, surfaces, profile),
            *equations.coefficients(one, surfaces), *equations.volumes(one, surfaces),
        ]  # fmt: skip
        assert len(formulas) == (6 if one.skewed else 5)
        _stand(formulas, tables)
    for one in found.pivots:
        tables = _tables(quantities.pivot_tables(one))
        members = tables["members"]
        _stand([*equations.depths(one, members), *equations.pivot_volumes(one, members)], tables)


def _tables(tables):
    return {table.name.rsplit("_", 1)[1]: table for table in tables}


def _stand(formulas, tables):
    for formula in formulas:
        ref = formula.ref
        number = tables[ref.table.rsplit("_", 1)[1]][ref.key].number(ref.row, ref.unit)
        assert formula.value == pytest.approx(number, rel=1e-9, abs=1e-9), ref


# --- definitions


def test_places_are_those_of_the_table(found):
    for one in found.guides:
        covered, begin, under = (definition.expression.value for definition in equations.places(one))
        cycle = _tables(quantities.guide_tables(one))["cycle"]
        assert one.grid.covered == round(covered)
        most = one.given.parts + 2 - one.grid.covered  # at the end of the stroke it is held on the guide
        assert np.array_equal(np.minimum(np.rint(begin[:, 0]), most), cycle["start"].numbers())
        assert np.array_equal(under, one.grid.under + 1)


def test_mean_pressures_over_the_path_are_those_of_the_faces(found):
    for one in found.guides:
        central, turning = (definition.expression.value for definition in equations.pressures(one))
        for face, pressed in (("lower", one.force > 0), ("upper", one.force < 0)):
            surface = one.surface("guide", face)
            for n, (line, where) in enumerate(((central, pressed), (turning, one.couple > 0))):
                path = one.path * where
                mean = np.sum(line * path) / max(path.sum(), 1e-300)
                assert surface.pressure[n] == pytest.approx(1e6 * mean, rel=1e-9, abs=1e-6)


def test_shares_of_the_points_of_a_half_make_up_its_force(found):
    for one in found.guides:
        place, share = (definition.expression.value for definition in equations.shares(one))
        sole = _tables(quantities.guide_tables(one))["sole"]
        assert np.allclose(place, sole["xi"].numbers("mm")[one.grid.xi > 0], rtol=1e-9, atol=1e-9)
        whole = one.couple.max()
        assert np.allclose(
            share, whole * wear.share(one.grid)[one.grid.xi > 0], rtol=1e-9, atol=1e-12 * whole
        )
        assert share.sum() == pytest.approx(whole, rel=1e-9)


def test_sums_and_wear_of_the_point_worn_most_are_those_of_its_row(found):
    for one in found.guides:
        profile = _tables(quantities.guide_tables(one))["profile"]
        worst = one.worst_guide
        keys = [(f"{key}_{worst.face}", "") for key in ("work_force", "work_couple")]
        for (key, unit), definition in zip(
            [*keys, (f"u_{worst.face}", "µm")], equations.sums(one), strict=True
        ):
            number = profile[key].number(worst.worst, unit)
            assert definition.expression.value == pytest.approx(number, rel=1e-9, abs=1e-9), key


def test_running_in_and_steady_wear_are_the_diagram(found):
    for one in found.guides:
        if one.given.running_in is not None:
            table = _tables(quantities.guide_tables(one))["stages"]
            line = equations.stages(one, table).expression.value
            assert np.allclose(line, table["u"].numbers("µm"), rtol=1e-9, atol=1e-9)


def test_sum_and_wear_of_the_sector_worn_most_are_those_of_its_row(found):
    for one in found.pivots:
        sectors = _tables(quantities.pivot_tables(one))["sectors"]
        name, row = one.worst.name, one.worst.worst
        path, depth = (definition.expression.value for definition in equations.sectors(one))
        assert path == pytest.approx(sectors[f"path_{name}"].number(row), rel=1e-9)
        assert depth == pytest.approx(sectors[f"u_{name}"].number(row, "µm"), rel=1e-9)


def test_axes_of_the_charts_say_what_the_curves_show(found):
    """Letter and unit of every axis, and the numbers drawn in that unit: once an axis was in mm for µm."""
    for one in found.guides:
        view = GuideView(one, Page(Html(), Translator("en"), Numbering()))
        tables = _tables(quantities.guide_tables(one))
        faces = {
            side: [("u_" + face, "u", "µm") for face in ("lower", "upper")] for side in ("profile", "sole")
        }
        for graph, name, along, curves in (
            (view.guide_graph, "profile", ("x", "mm"), faces["profile"]),
            (view.slider_graph, "sole", ("xi", "mm"), faces["sole"]),
            (
                view.settled_graph,
                "cycle",
                ("phi", "deg"),
                [("shift", "delta", "µm"), ("tilt", "theta", "deg")],
            ),
            (view.stage_graph, "stages", ("t", "h"), [("u", "u", "µm")]),
        ):
            columns = tables[name]
            letters = [(letter(columns[key].symbol(), view.page.tr)[0], unit) for key, _, unit in curves]
            assert [(label[0], _unit(label)) for label in graph.ylabels] == letters
            assert [columns[key].symbol().base for key, _, _ in curves] == [base for _, base, _ in curves]
            assert (graph.xlabel[0], _unit(graph.xlabel)) == (letter(along[0], view.page.tr)[0], along[1])
            x, count = columns[along[0]].numbers(along[1]), len(columns)
            assert np.allclose(graph.x[:count], x)
            for panel, (key, _, unit) in enumerate(curves):
                line, *_ = (curve for curve in graph.curves if curve.panel == panel)
                assert np.allclose(line.values[:count], columns[key].numbers(unit), equal_nan=True)


def _unit(label):
    return str(label[-1]).removeprefix(", ").replace("°", "deg")
