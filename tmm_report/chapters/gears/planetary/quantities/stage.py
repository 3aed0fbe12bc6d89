"""Every number of a planetary stage with its symbol, unit and meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Any

import numpy as np

from tmm_report.chapters.gears.planetary.quantities import search as listing
from tmm_report.chapters.gears.planetary.quantities.conditions import condition_columns
from tmm_report.chapters.gears.planetary.quantities.ring_limit import LEAST_RING, ring_values
from tmm_report.chapters.gears.planetary.quantities.schemes import schemes_table
from tmm_report.chapters.gears.planetary.solve.stage import Found, Given
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol, both, math_symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.gear_terms import HA
from tmm_report.quantity.terms.wheel_words import DIAMETERS, dimension, of_wheel

Array = Any
# key, symbol (None of what is never written as one), unit, meaning, number
Row = tuple[str, Symbol | None, str, Message, float]

WHEELS = N_("dimensions of the wheels of stage %(name)s")
MESHES = N_("meshes of stage %(name)s")
CONDITIONS = N_("conditions of stage %(name)s")
MOTIONS = N_("motions of stage %(name)s with each member held")

TEETH = Quantity("z", Symbol("z"), "", Message(N_("number of teeth")))
SHIFT = Quantity("x", Symbol("x"), "", Message(N_("shift coefficient")))
TRANSVERSE = Quantity("x", Symbol("x", "t"), "", Message(N_("shift coefficient in the transverse section")))
NORMAL = Quantity("x_n", Symbol("x", "n"), "", Message(N_("shift coefficient in the normal section")))
FULL_TIP = Quantity("d_a_full", Symbol("d", "a"), "m", Message(N_("tip diameter of teeth of full height")))
CROWN = Quantity("d_w", Symbol("d", "w"), "m", Message(N_("working diameter of the satellite in the mesh")))
START = Quantity(
    "rho_l",
    Symbol("rho", "l"),
    "m",
    Message(N_("radius of curvature of the satellite where its involute begins")),
)
CUT = Quantity(
    "d_a_cut",
    Symbol("d", "a", "′"),
    "m",
    Message(N_("tip diameter of the ring cut down clear of the satellite's fillets")),
)


def book(found: Found, prefix: str) -> Book:
    """All that is said in numbers of the stage."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the stage."""
    for rows in (_given(found.given), _ratio(found), _satellites(found), _assembly(found), _whole(found)):
        for key, symbol, unit, meaning, number in rows:
            yield Quantity(f"{prefix}_{key}", symbol, unit, meaning).value(float(number))
    yield from ring_values(found, prefix)


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    """Sizes, motions with each member held, the solutions; meshes, conditions, combinations that fail."""
    name = {"name": found.name}
    yield Table(f"{prefix}_wheels", Message(WHEELS, name), tuple(_wheels(found)))
    yield Table(f"{prefix}_motions", Message(MOTIONS, name), tuple(_motions(found)))
    yield from listing.tables(found, prefix)
    yield Table(f"{prefix}_rows", Message(MESHES, name), tuple(_rows(found)))
    yield Table(f"{prefix}_conditions", Message(CONDITIONS, name), tuple(condition_columns(found)))
    if found.choice is not None:
        yield schemes_table(found.choice, prefix, found.name)


def judged(found: Found, say: Callable[[str], str]) -> list[str]:
    """Every combination of teeth that was examined, a line each, with what became of it in words that `say` gives; many
    lines are joined in one text, for there may be half a million."""
    lines = listing.listing(listing.candidates(found), say)
    return ["\n".join(some) for some in iter(lambda: list(islice(lines, listing.AT_ONCE)), [])]


def ratio_symbol(given: Given, input: p.Member, output: p.Member) -> Symbol:
    """u_1H^(3): of the input to the output with the third member held."""
    return Symbol("u", *_between(given, input, output))


def _between(given: Given, input: p.Member, output: p.Member) -> tuple[str, str]:
    """Lower and upper index of what is said of a motion: 1H, (3)."""
    (held,) = set(p.MEMBERS) - {input, output}
    return both(given.member(input), given.member(output)), f"({given.member(held)})"


# --- single numbers


def _given(given: Given) -> Iterator[Row]:
    task, carrier = given.task, given.names[-1]
    wanted = N_("wanted ratio of the angular velocities of the input and the output")
    t = "t" if given.helix else ""  # of helical teeth what is counted with is that of the transverse section
    yield "u_wanted", Symbol("u"), "", Message(wanted), task.ratio
    allowed = Message(N_("allowed deviation of the ratio"))
    yield "tolerance", Symbol("Delta", "u"), "%", allowed, 100 * task.tolerance
    module = Message(N_("module"))
    if one_module(given):
        yield "m", Symbol("m", t), "m", module, task.modules[0]
    else:
        for name, metres in zip(("I", "II"), task.modules, strict=True):
            yield f"m_{name}", Symbol("m", t + name), "m", module, metres
    yield "k_least", None, "", Message(N_("least number of satellites examined")), task.satellites[0]
    yield "k_most", None, "", Message(N_("largest number of satellites examined")), task.satellites[-1]
    stopped = Message(N_("efficiency of the stage with carrier %(carrier)s stopped"), {"carrier": carrier})
    yield "eta_stopped", Symbol("eta", carrier), "", stopped, given.efficiency
    height = Message(N_("coefficient of the height of the head"))
    yield "ha", Symbol("h", "at", "*") if t else HA, "", height, task.rack.ha
    angle = Message(N_("profile angle of the basic rack"))
    yield "alpha", Symbol("alpha", t), "deg", angle, np.degrees(task.rack.alpha)
    if task.weight:
        weight = Message(N_("weight of the nearness of the ratio in the ranking"))
        yield "ratio_weight", Symbol("w"), "", weight, task.weight
    yield from _helical(given)
    for key, text, number in (
        ("external_least", N_("least number of external teeth examined"), task.external[0]),
        ("external_most", N_("largest number of external teeth examined"), task.external[1]),
        ("rings_least", N_("least number of teeth of rings examined"), task.rings[0]),
        ("rings_most", N_("largest number of teeth of rings examined"), task.rings[1]),
    ):
        yield key, None, "", Message(text), number


def one_module(given: Given) -> bool:
    """Whether both rows have the same module."""
    return given.task.scheme.single or given.task.modules[0] == given.task.modules[1]


def _helical(given: Given) -> Iterator[Row]:
    """What is stated of helical teeth, in the normal section."""
    if given.module_n is None or given.rack_n is None:
        return
    yield "beta", Symbol("beta"), "deg", Message(N_("helix angle")), np.degrees(given.helix)
    module = Message(N_("module in the normal section"))
    for key, metres in zip(("m",) if one_module(given) else ("m_I", "m_II"), given.module_n, strict=False):
        yield f"{key}_n", Symbol("m", "n" + key[2:]), "m", module, metres
    angle = Message(N_("profile angle of the basic rack in the normal section"))
    yield "alpha_n", Symbol("alpha", "n"), "deg", angle, np.degrees(given.rack_n.alpha)
    height = Message(N_("coefficient of the height of the head in the normal section"))
    yield "ha_n", HA, "", height, given.rack_n.ha


def _ratio(found: Found) -> Iterator[Row]:
    given, task = found.given, found.given.task
    meaning = Message(N_("ratio of the stage, the second input at rest"))
    yield "u", ratio_symbol(given, task.input, task.output), "", meaning, found.ratio
    meaning = Message(N_("ratio with the carrier stopped, wheel 1 to wheel 3"))
    yield "u_basic", ratio_symbol(given, "wheel1", "wheel3"), "", meaning, found.basic
    meaning = Message(N_("ratio of wheel 1 to the carrier, wheel 3 at rest"))
    yield "u_carrier", ratio_symbol(given, "wheel1", "carrier"), "", meaning, 1 - found.basic
    meaning = Message(N_("deviation of the ratio"))
    yield "delta_u", Symbol("Delta", "u"), "%", meaning, 100 * found.deviation
    yield "combinations", None, "", listing.COUNT.meaning, found.candidates.examined
    yield "solutions", None, "", Message(N_("how many solutions there are")), found.candidates.solutions


def _satellites(found: Found) -> Iterator[Row]:
    yield "k", Symbol("k"), "", Message(N_("number of satellites")), found.satellites
    distance = float(found.sizes.centre_distance)
    yield "a_w", math_symbol("a_w"), "m", Message(N_("centre distance")), distance
    apart = Message(N_("distance between the axes of neighbouring satellites"))
    yield "apart", None, "m", apart, found.apart
    gap = Message(N_("gap between the tip circles of neighbouring satellites"))
    yield "gap", Symbol("Delta"), "m", gap, found.gap
    least = Message(N_("least number of teeth that the rack does not undercut"))
    yield "least_teeth", math_symbol("z_min"), "", least, found.least_teeth
    rounded = Message(N_("least number of teeth as the course rounds it"))
    yield "least_teeth_rounded", None, "", rounded, least_teeth(found.given.task.rack)


def _assembly(found: Found) -> Iterator[Row]:
    whole = Message(N_("whole number of the assembly condition"))
    yield "assembly", Symbol("C"), "", whole, found.assembly_number
    divisor = Message(N_("greatest common divisor of the teeth of the two crowns"))
    if not found.scheme.single:
        yield "divisor", Symbol("D"), "", divisor, np.gcd(found.teeth[1], found.teeth[2])
    if not found.scheme.single and found.turns is not None:
        turns = Message(N_("whole turns of the carrier in the usual form of the condition of assembly"))
        yield "turns", Symbol("p"), "", turns, found.turns
        usual = Message(N_("whole number of the usual form of the condition of assembly"))
        yield "usual_assembly", Symbol("C", "", "′"), "", usual, found.usual_assembly


def _whole(found: Found) -> Iterator[Row]:
    yield "eta", _motion_symbol(found), "", Message(N_("efficiency of the stage")), found.efficiency
    force = N_(
        "circumferential force on one satellite from wheel %(wheel)s for each newton metre of its moment"
    )
    one = found.given.member("wheel1")
    yield "force", Symbol("F", "t" + one), "N/(N·m)", Message(force, {"wheel": one}), found.force_per_moment
    yield "mu_l", math_symbol("mu_l"), "m/mm", Message(N_("scale of the drawing of the stage")), found.scale


def _motion_symbol(found: Found) -> Symbol:
    task = found.given.task
    return Symbol("eta", *_between(found.given, task.input, task.output))


# --- wheels and meshes


def _wheels(found: Found) -> Iterator[Column]:
    order = list(found.scheme.wheels)
    names = [found.given.wheels[i] for i in order]
    yield text_column("wheel", Message(N_("number of the wheel")), names)
    yield _named(TEETH, [found.teeth[i] for i in order], names)
    if found.given.helix:
        yield _named(NORMAL, found.sizes.shifts[order] / np.cos(found.given.helix), names)
    yield _named(TRANSVERSE if found.given.helix else SHIFT, found.sizes.shifts[order], names)
    for key in DIAMETERS:
        yield _named(dimension(key), found.sizes.diameters[key][order], names)
    yield _named(FULL_TIP, found.sizes.tip[order], names)


def _named(quantity: Quantity, values: Any, names: Sequence[str]) -> Column:
    """A column of wheels: d_a in the head, d_a2 in the row of wheel 2."""
    return Column(quantity, values, [of_wheel(quantity.sign, name) for name in names])


def _rows(found: Found) -> Iterator[Column]:
    """Of wheel 1 with its crown and of wheel 3 with the other."""
    rows, sizes, names = found.rows, found.sizes, found.given.wheels
    central, crowns = [names[0], names[3]], [names[1], names[2]]
    pairs = [f"{names[0]}-{names[1]}", f"{names[2]}-{names[3]}"]
    yield text_column("mesh", Message(N_("wheels in mesh")), pairs)
    total = Message(N_("sum of the teeth of the wheels in mesh; with a ring, their difference"))
    yield Quantity("z_sum", None, "", total).column(rows.teeth)
    for key, unit, meaning, numbers in (
        ("a", "m", N_("reference centre distance of the mesh that is opened"), sizes.pitch_distances),
        ("alpha_w", "deg", N_("operating angle of that mesh"), np.degrees(sizes.angles)),
    ):
        yield Quantity(key, math_symbol(key), unit, Message(meaning)).column(numbers)
    yield _shift_sums(found)
    contact = Message(N_("contact ratio"))
    yield Quantity("eps_alpha", math_symbol("epsilon_alpha"), "", contact).column(rows.contact)
    yield _named(CROWN, sizes.working[1:3], crowns)
    yield _named(START, rows.start, crowns)
    yield from _rings(found, central)


def _shift_sums(found: Found) -> Column:
    """x_Σ of an external mesh, x_d of one with a ring."""
    symbols = [math_symbol(_sum_key(row)) for row in found.scheme.rows]
    meaning = Message(N_("sum of the shift coefficients in mesh; with a ring, their difference"))
    return Column(Quantity("x_sum", symbols[0], "", meaning), found.sizes.shift_sums, symbols)


def _sum_key(row: int) -> str:
    return "x_Sigma" if row == p.EXTERNAL else "x_d"


def _rings(found: Found, names: Sequence[str]) -> Iterator[Column]:
    """What only meshes with a ring have."""
    rows = found.rows
    meaning = Message(N_("distance between the limit points of the line of action"))
    yield Quantity("line", None, "m", meaning).column(rows.line)
    meaning = Message(N_("radius of curvature at the tip of the ring of full height"))
    yield Quantity("rho_a", None, "m", meaning).column(rows.curvature)
    yield _named(CUT, rows.cut, names)
    yield _named(LEAST_RING, rows.least, names)


# --- motions


def _motions(found: Found) -> Iterator[Column]:
    motions, member = found.motions, found.given.member
    for key, text, pick in (
        ("held", N_("member that is held"), lambda m: m.held),
        ("input", N_("input member"), lambda m: m.input),
        ("output", N_("output member"), lambda m: m.output),
    ):
        yield text_column(key, Message(text), [member(pick(motion)) for motion in motions])
    for one in p.MEMBERS:
        about = Message(N_("speed of member %(name)s to that of the input"), {"name": member(one)})
        speed = Quantity(f"omega_{member(one)}", Symbol("omega", member(one)), "", about)
        yield speed.column([motion.speed[one] for motion in motions])
    satellite = Symbol("omega", found.given.crowns[0])
    about = Message(N_("speed of the satellites to that of the input"))
    yield Quantity("omega_satellite", satellite, "", about).column([motion.satellite for motion in motions])
    yield listing.RATIO.column([motion.ratio for motion in motions])
    about = Message(N_("efficiency; not positive: locks"))
    eta = Quantity("eta", Symbol("eta"), "", about)
    symbols = [Symbol("eta", *_between(found.given, motion.input, motion.output)) for motion in motions]
    yield Column(eta, [motion.efficiency for motion in motions], symbols)
    way = Message(N_("flow of the power, carrier stopped: 1 from wheel 1 to wheel 3, −1 back"))
    yield Quantity("power", None, "", way).column([motion.exponent for motion in motions])
