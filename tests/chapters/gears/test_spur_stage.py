"""The spur stage: choice of teeth and shifts, conditions, mistakes."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.chapters.gears.spur.quantities import book, tables, values
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.chapters.gears.spur.solve.sizes import choose_teeth
from tmm_report.chapters.gears.spur.steps import stage
from tmm_report.mechanics.gears.limits.blocking_contour import Blocking
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.trains import Train, speeds
from tmm_report.problems import ProblemError

GUIDE = spur.Given(ratio=-2.0, module=6e-3, centre_distance=0.13, wheels=("4", "5"))
FREE = replace(GUIDE, centre_distance=None, teeth=(14, 28))
CASES = {
    "guide": GUIDE,
    "speeding up": replace(GUIDE, ratio=-0.5),
    "limit": replace(GUIDE, shift="limit"),
    "equal sliding": replace(GUIDE, shift="equal sliding"),
    "backlash": replace(GUIDE, shift=(0.1765, 0.3)),
    "from shifts": replace(FREE, shift=(0.5, 0.4)),
    "full tips": replace(FREE, shift=(0.5, 0.4), tip_shortening=False),
    "helical": replace(GUIDE, helix=math.radians(15), width=0.04),
    "low teeth": replace(GUIDE, rack=Rack(math.radians(20), 0.8, 0.3)),
    "internal": spur.Given(3.0, 5e-3, 0.1, wheels=("1", "2"), shift="limit"),
    "internal, ring drives": spur.Given(1 / 3, 5e-3, None, (60, 20), shift=(0.5, 0.3)),
    "internal, helical": spur.Given(3.0, 4e-3, 0.09, helix=0.2),
}
every_case = pytest.mark.parametrize("given_", CASES.values(), ids=CASES)


# ---------------------------------------------------------------- teeth and shifts


@given(
    st.floats(0.06, 0.6),
    st.sampled_from([2e-3, 3e-3, 5e-3]),
    st.floats(1.0, 6.0),
    st.booleans(),
    st.booleans(),
)
def test_chosen_teeth(distance, module, ratio, faster, internal):
    """The sum is at most 2 under its bound, never above it, and the ratio as near as whole teeth allow."""
    u = ratio + 0.5 if internal else -ratio
    stage = spur.Given(1 / u if faster else u, module, distance)
    chosen = choose_teeth(stage)
    small, large = sorted(chosen.z)
    total = large - small if internal else large + small
    assert -1e-6 <= chosen.choice.bound - total <= 2 + 1e-6
    assert small == math.floor(chosen.choice.share * (1 + 1e-9))
    if total + 1 <= chosen.choice.bound - 1e-6 and chosen.choice.bound - total < 2 - 1:
        assert abs(large - abs(u) * small) <= 0.5 + 1e-9  # nothing forced it away from the ratio


@every_case
def test_shifts_fill_the_distance(given_):
    found = spur.solve(given_)
    if isinstance(given_.shift, str):
        assert found.pair.backlash == pytest.approx(0, abs=1e-12)
    else:
        assert found.pair.backlash >= -1e-9


def test_the_smaller_wheel_takes_its_least_shift():
    assert spur.solve(CASES["speeding up"]).pair.x2 == pytest.approx(3 / 17)
    found = spur.solve(CASES["limit"])
    assert found.pair.x1 == pytest.approx(found.pair.x_min[0])
    assert found.conditions[0].margin == pytest.approx(0) and found.conditions[0].met


def test_equal_sliding():
    root = spur.solve(CASES["equal sliding"]).pair.root_sliding
    assert root[0] == pytest.approx(root[1])


def test_shifts_written_with_three_decimals_fill_the_distance():
    found = spur.solve(replace(GUIDE, shift=(0.176, 0.563)))
    assert found.pair.x1 == 0.176
    assert found.pair.x1 + found.pair.x2 == pytest.approx(0.73897910, abs=1e-8)


def test_distance_from_shifts():
    pair = spur.solve(GUIDE).pair
    back = spur.solve(replace(FREE, shift=(float(pair.x1), float(pair.x2))))
    assert back.pair.a_w == pytest.approx(0.13, abs=1e-12)


# ---------------------------------------------------------------- what the drive needs


@every_case
def test_members_and_meshes(given_):
    found = spur.solve(given_)
    speed = speeds(Train(found.members, found.meshes), {found.input: 100.0})
    assert 100.0 / speed[found.output] == pytest.approx(found.ratio)
    one, two = found.members
    way = -1 if given_.internal else 1
    assert abs(one.radius + way * two.radius) == pytest.approx(two.distance)
    assert [m.kind for m in found.members].count("ring") == int(given_.internal)


# ---------------------------------------------------------------- conditions


def test_points_of_the_line_of_action():
    found = spur.solve(GUIDE)
    at = found.path.points
    assert list(at) == ["A", "C", "P", "D", "B"]
    assert list(at.values()) == sorted(at.values())
    assert at["B"] - at["C"] == pytest.approx(found.pair.p_b) == pytest.approx(at["D"] - at["A"])


@pytest.mark.exhaustive
def test_margins_change_sign_at_their_limits():
    """The undercut and the pointing fail just beyond the shift at which their margin is zero."""
    z = 20
    least = float(spur.solve(replace(FREE, teeth=(z, 30), ratio=-1.5, shift=(0.0, 0.0))).pair.x_min[0])
    for shift, met in ((least + 1e-3, True), (least - 1e-3, False)):
        found = spur.solve(replace(FREE, teeth=(z, 30), ratio=-1.5, shift=(shift, 0.3)))
        (undercut,) = [c for c in found.conditions if c.key == "undercut" and c.wheel == "4"]
        assert undercut.met == met
        assert undercut.margin == pytest.approx(shift - least)
    for shift, met in ((0.5, True), (1.2, False)):
        found = spur.solve(replace(FREE, shift=(shift, 0.0)))
        (pointing,) = [c for c in found.conditions if c.key == "pointing" and c.wheel == "4"]
        assert pointing.met == met == (float(found.pair.s_a[0]) >= 0.3 * 6e-3)


def test_an_involute_that_an_undercut_has_eaten_begins_later():
    """Deep undercut reaches the active profile, and the interference condition tells it."""
    found = spur.solve(replace(FREE, teeth=(10, 40), ratio=-4.0, shift=(-0.2, 0.5)))
    start, lower = found.starts[0], float(found.pair.rho_m[0])
    assert start > 1e-3 and found.pair.rho_l[0] < 0
    assert {c.key for c in found.failed if c.wheel == "4"} >= {"undercut"}
    (interference,) = [c for c in found.conditions if c.key == "interference" and c.wheel == "4"]
    assert interference.met == (lower >= start)


# ---------------------------------------------------------------- mistakes


MISTAKES = [
    ({"centre_distance": None}, (), "state centre_distance: 130 mm or teeth: [14, 28]"),
    ({"teeth": (14, 28), "centre_distance": 0.115}, ("centre_distance",), "more than 118.41 mm"),
    ({"teeth": (14, 28), "centre_distance": 0.15}, ("centre_distance",), "from 122.22 to 135 mm"),
    ({"centre_distance": 0.03}, ("centre_distance",), "from 54 mm or a module up to 3.33 mm"),
    ({"teeth": (5, 10)}, ("teeth",), "6 teeth or more"),
    ({"teeth": (14, 50)}, ("teeth",), "write ratio: -3.5714"),
    ({"ratio": 1.0}, ("ratio",), "must differ from 1"),
    ({"ratio": 2.0, "teeth": (30, 30)}, ("teeth",), "more teeth than the pinion"),
    ({"rack": Rack(ha=0.0)}, ("rack", "ha*"), "greater than zero"),
    ({"rack": Rack(ha=2.0, c=0.5)}, ("rack",), "less than 2.1579"),
    ({"shift": (0.5, 0.5)}, ("shift",), "x1 + x2 = 0.73898, or a centre distance of 131.27 mm"),
    ({"centre_distance": None, "teeth": (14, 28), "shift": (-5.0, 0.3)}, ("shift",), "a greater sum"),
    (
        {
            "ratio": 2.0,
            "teeth": (15, 30),
            "centre_distance": None,
            "shift": (0.0, 0.0),
            "tip_shortening": False,
        },
        ("shift",),
        "0.096 or more, or more teeth",
    ),
    (
        {"ratio": 1.3, "teeth": (24, 31), "centre_distance": None, "shift": (1.5, 1.5)},
        ("shift",),
        "a lesser shift of the ring",
    ),
    (
        {
            "ratio": -0.24,
            "teeth": (25, 6),
            "centre_distance": None,
            "shift": (2.96, 1.53),
            "rack": Rack(math.radians(10), 1.5, 0.1),
        },
        ("shift",),
        "shifts between −0.5 and 1.5",
    ),
    ({"ratio": 2.0, "teeth": (20, 40), "centre_distance": 0.05}, ("centre_distance",), "more than 56.39 mm"),
]


@pytest.mark.parametrize("changes, path, right", MISTAKES, ids=[str(n) for n in range(len(MISTAKES))])
def test_mistakes_say_what_would_work(changes, path, right):
    with pytest.raises(ProblemError) as caught:
        spur.solve(replace(GUIDE, **changes))
    (problem,) = caught.value.problems
    assert problem.path == path
    assert right in problem.text()


def test_a_sum_of_shifts_that_is_rounding_is_written_as_zero():
    """At the distance of unshifted wheels the shifts must make up 0, found as −8·10⁻¹⁶."""
    with pytest.raises(ProblemError) as caught:
        spur.solve(replace(GUIDE, teeth=(14, 28), centre_distance=0.126, shift=(0.5, 0.5)))
    assert "x1 + x2 = 0, or" in caught.value.problems[0].text()


@pytest.mark.exhaustive
def test_what_the_messages_offer_works():
    for changes in (
        {"teeth": (14, 28), "centre_distance": 0.135},
        {"teeth": (14, 28), "centre_distance": 0.12222},
        {"centre_distance": 0.054},
        {"centre_distance": 0.03, "module": 3.33e-3},
        {"shift": (0.5, 0.5), "centre_distance": 0.13127, "teeth": (14, 28)},
        {"rack": Rack(ha=1.85, c=0.3)},
    ):
        assert spur.solve(replace(GUIDE, **changes)).pair.eps > 0


# ---------------------------------------------------------------- results.json


@every_case
def test_tables(given_):
    found = spur.solve(given_)
    for table in tables(found, "stage1"):
        assert table.name.startswith("stage1_")
        assert len({len(column.values) for column in table.columns}) == 1, table.name
    numbers = {value.key: value.value for value in values(found, "stage1")}
    assert numbers["stage1_eps"] == pytest.approx(float(found.pair.eps))
    assert all(math.isfinite(number) for number in numbers.values())
    of = book(found, "stage1").tables
    readings, contour = of["stage1_readings"], of["stage1_contour"]
    seen = found.mesh.seen("N1") and found.mesh.seen("N2")
    assert readings["key"].values[:2] == (["N1N2", "AB"] if seen else ["AB", "AC"])
    assert max(readings["delta"].values) < 5
    step = contour["step"].values
    assert step[0] == 0 and not step[2] < step[1] - 1e-9  # nan: none
    assert contour[f"x_{given_.wheels[0]}"].values[0] == float(found.pair.x1)
    assert ("stage1_lacks" in of) == (not found.contour.feasible)


def test_the_numbers_of_the_results_are_found_in_solving(monkeypatch):
    """What the tables and formulas show stands in what was found, once it was asked for: nothing is sought again when
    they are written."""
    found = spur.solve(CASES["helical"])
    contour = found.contour
    assert found.proof.clearance > 0 and (contour.lacks, contour.nearest, contour.same_distance)

    def sought(*_, **__):
        raise AssertionError("sought while writing")

    for name in ("lacks", "nearest", "nearest_at_distance", "region", "lines"):
        monkeypatch.setattr(Blocking, name, sought)
    monkeypatch.setattr(Mesh, "on_working_circle", sought)
    assert len(book(found, "stage1").tables) >= 6
    assert stage(found, "stage1").s.formula("line").value > 0


def test_rows_of_different_units_are_printed_in_their_own():
    of = book(spur.solve(GUIDE), "stage1").tables
    conditions, readings = of["stage1_conditions"], of["stage1_readings"]
    assert [conditions["unit"].values[row] for row in (1, 2, 4)] == ["", "m", ""]
    assert conditions["limit"].number(2, "mm") == pytest.approx(1.8)
    assert readings["graph"].number(5, "deg") == pytest.approx(34.5, abs=0.1)
    assert (readings.ref("graph", 5, "rad").unit, readings.ref("graph", 5, "deg").unit) == ("", "deg")
