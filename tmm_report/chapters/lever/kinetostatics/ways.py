"""How the numbers of kinetostatics are found that the formulas of the note do not define, or only approach."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment
from tmm_report.chapters.lever.kinetostatics.quantities.equations import worked
from tmm_report.chapters.lever.kinetostatics.tie_ways import TIES
from tmm_report.mechanics.calculus.laws import TRAVEL
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Var, cos, sin, sqrt
from tmm_report.quantity.laws import written
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Known, Way, summed

GROUPS = N_(
    "Found analytically, group by group in the order opposite to that of assembly: the "
    "equations of equilibrium of its "
    "links with all loads, inertia among them, are solved together."
)
DRIVER = N_("Found analytically from the equilibrium of the driving link under the reactions found before.")
LOADS = N_("From the given masses and the accelerations: G = mg, F = −ma, M = −Jε.")
LAW = N_(
    "By the law of the load that the variant states, at the angle turned; straight lines "
    "between stated points."
)
INSTANT = N_("The instant that the variant asks for, by the angle turned or by the time.")
AT = N_("As at the positions of the table, at the instant that the variant asks for.")
POWER = N_(
    "The force by the velocity of its point along it, or the moment by the angular velocity of its link."
)
EXTREME = N_(
    "Over the whole cycle, between the positions of the table too; both sides of a jump are looked at."
)
SIDE = N_("Told where the quantity jumps at its extreme: the value just before or just after.")
WORK = N_(
    "The integral of the power over the cycle, exact on smooth pieces between the jumps of the "
    "loads and its zeros."
)
ZONES = N_("Zeros of the balancing moment over the cycle; between them the sense does not change.")
MISS = N_(
    "The difference of two ways to the balancing moment by the sum of the sizes of the terms, "
    "greatest of all positions."
)
STROKE = N_(
    "By the stroke's law as the variant states it; the displacement of the point tells where it "
    "begins and ends."
)
LINE = N_("Across the line of engagement of the gear, in the sense in which it is driven.")
TEETH = N_(
    "From the reaction in the mesh: moments about the axis of the wheel that is driven give its tangential part."
)
RAIL = N_("By the reaction of the guide of the axle across it: what it bears, the rail does.")
SLIP = N_("The friction of the rail by its normal force, the greatest of the positions.")
CLOSURE = N_("The least reaction of the cam along the normal, with the other sign.")
PARTING = N_("Where the reaction of the cam along the normal passes through zero: between them it is below.")
PRESS = N_("The reaction of the cam on its follower by the component along the common normal.")


def _weight(q: Known) -> Expr:
    return q("masses:{0}.m") * Var(Symbol("g"), abs(q.found.given.gravity), "m/s²")


def _inertia(q: Known) -> Expr:
    return q("masses:{0}.m") * q(f"rates_table.a_{q.own_text('masses:{0}.mass_centre')}")


def _inertia_part(axis: str):  # type: ignore[no-untyped-def]
    return lambda q: -q("masses:{0}.m") * q(f"rates_table.a_{q.own_text('masses:{0}.mass_centre')}_{axis}")


def _weight_part(axis: str):  # type: ignore[no-untyped-def]
    def part(q: Known) -> Expr:
        g = complex(q.found.given.gravity)
        return q("masses:{0}.m") * Var(Symbol("g", "", axis), g.real if axis == "x" else g.imag, "m/s²")

    return part


def _power(q: Known) -> Expr:
    """Of the load or loads by whose keys the power goes."""
    total: Expr | None = None
    for load in q.parts[0].split("+"):
        one = _power_of(q, load)
        total = one if total is None else total + one
    assert total is not None
    return total


def _power_of(q: Known, load: str) -> Expr:
    from tmm_report.chapters.lever.kinetostatics.quantities.positions import forces, moments

    given, links = q.found.given, q.found.kinematics.linkage.mechanism.links
    points = {of.key: one.at for of, one in zip(forces(given.forces), given.forces, strict=True)}
    turned = {of.key: one.on for of, one in zip(moments(given.moments), given.moments, strict=True)}
    for name, link in links.items():
        points |= {f"G_{name}": link.mass_centre, f"F_I{name}": link.mass_centre}
        turned[f"M_I{name}"] = name
    if load in turned:
        return q(f"loads_table.{load}") * q(f"rates_table.w_{turned[load]}")
    at = points[load]
    return q(f"loads_table.{load}_x") * q(f"rates_table.v_{at}_x") + q(f"loads_table.{load}_y") * q(
        f"rates_table.v_{at}_y"
    )


def _by_law(q: Known) -> Expr:
    """The law of a load at its place, with the sign that the load has there; raises KeyError where the load stands
    still and is nothing."""
    from tmm_report.chapters.lever.kinetostatics.quantities.positions import forces, moments
    from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading

    given, solved = q.found.given, q.found.diagram if q.fine else q.found.table
    loads: dict[str, Force | Moment] = {
        of.key: one for of, one in zip(forces(given.forces), given.forces, strict=True)
    }
    loads |= {of.key: one for of, one in zip(moments(given.moments), given.moments, strict=True)}
    load = loads[q.own]
    read = reading(load, q.found.kinematics, solved.motion, solved.turned)
    at, which = (np.broadcast_to(row, solved.turned.shape)[q.row] for row in (read.at, read.which))
    place = Var(Symbol("x"), float(at)) if load.law.of == TRAVEL else Var(Symbol("phi"), float(at), "rad")
    size, own = written(read.law, place, int(which)), float(q(q.own).number)
    if not math.isclose(abs(float(size.value)), abs(own), rel_tol=1e-9, abs_tol=1e-9):
        raise KeyError(q.own)
    return size if own * float(size.value) >= 0 else -size


def _omega(q: Known) -> Var:
    """Angular velocity of the driving link: one number, or that of the position."""
    kinematics = q.found.kinematics
    link = kinematics.linkage.mechanism.driver.link
    return q(f"rates_table.w_{link}") if kinematics.by_law else q("omega")


def _lever(q: Known) -> Expr:
    """−ΣN/ω₁: the powers of all loads, inertia among them."""
    solved = q.found.diagram if q.fine else q.found.table
    return -Var(Symbol("SigmaN"), float(np.sum(solved.powers, axis=0)[q.row]), "W") / _omega(q)


def _by_energy(q: Known) -> Expr:
    """(dT/dt − ΣN_ext)/ω₁."""
    from tmm_report.chapters.lever.kinetostatics.solve.powers import external_power

    solved = q.found.diagram if q.fine else q.found.table
    omega = _omega(q)
    power = float(np.asarray(external_power(q.found.given, solved.motion, solved.loading))[q.row])
    rate = float(solved.power[q.row]) * float(omega.number) + power
    return (Var(Symbol("T′"), rate, "W") - Var(Symbol("SigmaN", "ext"), power, "W")) / omega


def _angle(q: Known) -> Expr:
    from tmm_report.quantity.formula import Function

    def arctan2(ratio: object) -> float:
        x, y = q("R_{0}_x").number, q("R_{0}_y").number
        return math.atan2(y, x) % (2 * math.pi)

    return Function("arctan", q("R_{0}_y") / q("R_{0}_x"), arctan2)


def _offset(q: Known) -> Expr:
    solved = q.found.diagram if q.fine else q.found.table
    from tmm_report.chapters.lever.kinetostatics.quantities.positions import both

    one = next(r for r in solved.statics.reactions.values() if both(*r.pair.links) == q.parts[0])
    along = np.asarray(one.along).reshape(-1)
    beta = Var(Symbol("beta", one.pair.name), float(np.angle(along[q.row if along.size > 1 else 0])), "deg")
    return q("M_{0}") / (q("R_{0}_y") * cos(beta) - q("R_{0}_x") * sin(beta))


def _part(function):  # type: ignore[no-untyped-def]
    def part(q: Known) -> Expr:
        return q("R_{0}") * function(q("alpha_{0}"))

    return part


def _size(q: Known) -> Expr:
    return sqrt(q("R_{0}_x") ** 2 + q("R_{0}_y") ** 2)


def _along(q: Known, moment: str) -> Expr:
    """F = M dφ/ds, of a driving slider or cylinder."""
    return q(f"balancing_table.{moment}") * q("stroke_table.stroke_transfer")


def _mean(q: Known) -> Expr:
    return q("works:M_bal.work") / Var(Symbol("T", "c"), float(q.found.works.time), "s")


def _share(q: Known) -> Expr:
    works = q.found.works
    return abs(Var(Symbol("SigmaA"), float(works.whole), "J")) / Var(
        Symbol("A", "max"), float(works.size), "J"
    )


WAYS = (
    *TIES,
    Way(
        "loads_given.* force_extremes.key force_extremes.unit works.load *.sense strokes.stroke strokes.load",
        NAME,
    ),
    Way("loads_at.phi reactions_at.phi balancing_at.phi", INSTANT, of="t"),
    Way("loads_at.t reactions_at.t balancing_at.t", INSTANT, of="phi"),
    Way("loads_at.* reactions_at.* balancing_at.*", AT, of="phi t"),
    Way("stated_table.position", COUNTED),
    Way("stated_table.*", LAW, of="phi", by=_by_law),
    Way("loads_table.G_*_x", by=_weight_part("x")),
    Way("loads_table.G_*_y", by=_weight_part("y")),
    Way("loads_table.G_*", LOADS, by=_weight),
    Way("loads_table.F_I*_x", by=_inertia_part("x")),
    Way("loads_table.F_I*_y", by=_inertia_part("y")),
    Way("loads_table.F_I*", LOADS, by=_inertia),
    Way("loads_table.F_I*_x loads_table.F_I*_y", LOADS, of="masses:{0}.m"),
    Way("loads_table.F_I*", LOADS, of="masses:{0}.m"),
    Way("loads_table.M_I*", LOADS, by=lambda q: -q("masses:{0}.J") * q("rates_table.e_{0}")),
    Way("loads_table.P_*_x", LAW, of="stated_table.P_{0} phi"),
    Way("loads_table.P_*_y", LAW, of="stated_table.P_{0} phi"),
    Way("loads_table.P_*", LAW, of="stated_table.P_{0} P_{0}_x P_{0}_y", by=_by_law),
    Way("loads_table.M_*", LAW, of="stated_table.M_{0} phi", by=_by_law),
    Way("powers_table.N_sum", by=summed("N_", but="N_sum")),
    Way("powers_table.N_*", POWER, of="phi", by=_power),
    Way("reactions_table.R_*_x reactions_table.R_*_y", GROUPS, worked=worked, beside=True),
    Way("reactions_table.R_*_x", GROUPS, by=_part(cos), beside=True),
    Way("reactions_table.R_*_y", GROUPS, by=_part(sin), beside=True),
    Way("reactions_table.R_*", GROUPS, worked=worked, by=_size, beside=True),
    Way("reactions_table.alpha_*", GROUPS, worked=worked, by=_angle, beside=True),
    Way("reactions_table.x_*", GROUPS, worked=worked, by=_offset, beside=True),
    Way("reactions_table.M_*", GROUPS, worked=worked, beside=True, of="R_{0}"),
    Way("balancing_table.M_bal", DRIVER, worked=worked, beside=True, of="M_lever"),
    Way("balancing_table.M_lever", N_("From the balance of Zhukovsky's lever."), by=_lever),
    Way(
        "balancing_table.M_power",
        N_("From the power balance: dT/dt is a difference of the kinetic energies."),
        by=_by_energy,
    ),
    Way("balancing_table.lever_disagreement", MISS, of="M_bal M_lever"),
    Way("balancing_table.power_disagreement", MISS, of="M_bal M_power"),
    Way("lever_disagreement power_disagreement", MISS, of="M_bal_max"),
    Way("force_extremes.*_side", SIDE, of="key"),
    Way("force_extremes.*", EXTREME, of="key least_at greatest_at"),
    Way("works.work", by=lambda q: q("driving") + q("resisting")),
    Way("works.*", WORK, of="load"),
    Way("moment_senses.*", ZONES, enough=True),
    Way("P_bal_mean", N_("The work of the balancing moment by the time of the cycle."), by=_mean),
    Way("works_sum", by=_share),
    Way("M_bal_min M_bal_max F_bal_min F_bal_max", EXTREME, of="omega law_time"),
    Way("drive_at.phi", INSTANT, of="t"),
    Way("drive_at.t", INSTANT, of="phi"),
    Way("drive_at.*", AT, of="phi t"),
    Way("drive_table.F_stroke", by=lambda q: _along(q, "M_bal")),
    Way("drive_table.F_lever", by=lambda q: _along(q, "M_lever")),
    Way("drive_table.F_power", by=lambda q: _along(q, "M_power")),
    Way("F_stroke_min F_stroke_max", EXTREME, of="law_time"),
    Way("strokes.*", STROKE, of="load stroke"),
    Way("gear_table.alpha_F_bal", LINE, of="alpha_w_gear phi"),
    Way("r_w_gear alpha_w_gear", STATED),
    Way("mesh_table.F_t_*", TEETH, of="phi F_n_{0} reactions_table.R_*"),
    Way("mesh_table.F_n_*", TEETH, of="F_t_{0} alpha_w_{0}"),
    Way("mesh_table.M_z_*", TEETH, of="phi mesh_table.F_t_*"),
    Way("alpha_w_*", STATED),
    Way("rolling_table.F_t_*", TEETH, of="phi M_z_*"),
    Way("rolling_table.N_*", RAIL, of="phi reactions_table.R_*"),
    Way("rolling_table.f_*", by=lambda q: q("F_t_{0}") / q("N_{0}")),
    Way("rolling_table.M_z_*", TEETH, of="phi F_t_*"),
    Way("f_max_*", SLIP, of="omega"),
    Way("cam_press_table.*", PRESS, of="phi reactions_table.R_*"),
    Way("cam_press_max_* cam_press_min_*", EXTREME, of="omega"),
    Way("cam_closure_*", CLOSURE, of="cam_press_min_{0}"),
    Way("cam_parting_*.*", PARTING, of="cam_press_min_{0}"),
)
