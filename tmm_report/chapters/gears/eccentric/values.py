"""Every number of the eccentric epicyclic mechanism: single ones, those of a set of teeth, of satellites, of paths.

`digits`: whole numbers have all of theirs in formulas.
"""

from __future__ import annotations

from tmm_report.chapters.gears.eccentric.given import CARRIER, RING, SUN
from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.problems import N_, Message
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.terms.gear_terms import HA, C
from tmm_report.quantity.terms.wheel_words import DIAMETERS

MM = ("mm", "mm")  # of print, in formulas
WHOLE = 9  # digits
GAP = "Delta"
TEETH = N_("number of teeth of wheel %(wheel)s")
COEFFICIENT = N_("coefficient %(name)s of the equation of the teeth")
EUCLID = N_("coefficient %(name)s of the extended algorithm of Euclid")
DIVIDED = N_("coefficient %(name)s divided by the greatest common divisor")
PARTICULAR = N_("teeth of wheel %(wheel)s in the particular solution")
FREE = N_("free distance between the tip circles of planet gears %(pair)s")
LARGER = N_("how many times the drawing is larger than the mechanism")
SMALLER = N_("how many times the drawing is smaller than the mechanism")
RATIO = N_("ratio of the teeth of ring and sun")


def _named(symbol: Symbol, meaning: str, **names: str) -> Q:
    """A whole number that has the name of a wheel or of a coefficient."""
    return Q(symbol, "", Message(meaning, names), digits=WHOLE)


def _teeth(wheel: str) -> Q:
    return _named(Symbol("z", wheel), TEETH, wheel=wheel)


class Values(Sheet, prefix="eccentric"):
    u_teeth = Q("u", "", RATIO)
    e = Q("e", "m", N_("eccentricity"), *MM)
    m = Q("m", "m", N_("module"), *MM)
    alpha = Q("alpha", "deg", N_("profile angle of the basic rack"))
    ha = Q(HA, "", N_("addendum coefficient"))
    c = Q(C, "", N_("tip clearance coefficient"))
    delta = Q("delta", "m", N_("least distance between the tips of neighbouring planet gears"), *MM)
    j_n = Q("j_n", "m", N_("normal backlash of the meshes"), *MM)
    omega = Q("omega", "rad/s", N_("angular velocity of the driving wheel"))

    E = Q("E", "", N_("eccentricity in halves of a module"), digits=WHOLE)
    equation_k = Q("k", "", N_("factor that makes the coefficients of the equation whole"), digits=WHOLE)
    equation_a, equation_b, equation_c = (_named(Symbol(of), COEFFICIENT, name=of) for of in "abc")
    divisor = Q("d", "", N_("greatest common divisor of the coefficients a and b"), digits=WHOLE)
    euclid_x, euclid_y = (_named(Symbol(of), EUCLID, name=of) for of in "xy")
    z1_0, z2_0 = (_named(Symbol("z", of, "0"), PARTICULAR, wheel=of) for of in "12")
    a_1, b_1 = (_named(Symbol(of, "1"), DIVIDED, name=of) for of in "ab")

    t = Q("t", "", N_("number of the set"), digits=WHOLE)
    z1, z3 = map(_teeth, (SUN, RING))
    satellites = Q("n", "", N_("number of planet gears"), digits=WHOLE)
    remainder_teeth = Q(None, "", N_("remainder of z1 + z3 divided by 4"))
    remainder_E = Q(None, "", N_("remainder of 2e/m divided by 4"))
    least_teeth = Q("z_min", "", N_("least number of teeth that the rack does not undercut"))
    least_teeth_rounded = Q(None, "", N_("least number of teeth as the course rounds it"))
    ring_rule = Q(None, "", N_("least teeth of a ring without shift by the rule of the course"))

    r_1 = Q("r_1", "m", N_("radius of the pitch circle of the sun"), *MM, digits=6)
    r_3 = Q("r_3", "m", N_("radius of the pitch circle of the ring"), *MM, digits=6)
    gap_2_4 = Q(Symbol(GAP, "2,4"), "m", Message(FREE, {"pair": "2–4"}), *MM, digits=4)
    in_hand_2_4 = Q(
        None,
        "m",
        N_("margin of the free distance of planet gears 2 and 4; negative where it lacks"),
        "mm",
    )
    gap_1_3 = Q(
        Symbol(GAP, "1,3"), "m", N_("distance between the tips of sun and ring where they are nearest"), *MM
    )
    alpha_a3 = Q("alpha_a3", "deg", N_("profile angle at the tips of the ring of full height"), digits=6)
    cut = Q(None, "m", N_("by how much the tips of the ring are cut down"), "mm")

    checked = Q(None, "", N_("number of positions at which the teeth were checked"))
    overlap = Q(None, "m²", N_("largest overlap of the teeth over a pitch"), "mm²")
    clearance = Q(None, "m", N_("least clearance of the teeth over a pitch"), "mm")

    u = Q(Symbol("u", SUN + RING, CARRIER), "", N_("ratio of sun and ring with the axes stopped"))
    u_1H = Q(
        Symbol("u", SUN + CARRIER, RING),
        "",
        N_("ratio of the sun and the body of the axes with the ring stopped"),
    )
    u_3H = Q(
        Symbol("u", RING + CARRIER, SUN),
        "",
        N_("ratio of the ring and the body of the axes with the sun stopped"),
    )

    drawing_enlargement, drawing_reduction = Q(None, "", LARGER), Q(None, "", SMALLER)
    close_enlargement, close_reduction = Q(None, "", LARGER), Q(None, "", SMALLER)

    tolerance = Q(Symbol("Delta", "u"), "%", N_("allowed deviation of the ratio"))
    u_wanted = Q("u", "", N_("required ratio of the teeth of ring and sun"))
    near_sets = Q(None, "", N_("sets of teeth near the ratio"))
    near_holding = Q(None, "", N_("those of them that hold two planet gears or more"))
    near_ring = Q(None, "", N_("teeth of the largest ring looked at"))
    b = Q("b", "m", N_("facewidth"), "mm")
    density = Q("rho", "kg/m³", N_("density of the planet gears"))
    M_1 = Q("M_1", "N·m", N_("moment on the sun, positive counter-clockwise"))
    M_3 = Q("M_3", "N·m", N_("moment on the ring, positive counter-clockwise"))
    M_H = Q("M_H", "N·m", N_("moment on the body of the axes, positive counter-clockwise"))
    F_sum = Q("F_Sigma", "N", N_("sum of the circumferential forces of all the planet gears on the sun"))
    kappa = Q("kappa", "", N_("ratio of the stiffness of a mesh to that of the axis of a planet gear"))
    share_sum = Q("w_Sigma", "", N_("sum of the numbers by which the planet gears share the force"))
    R_1 = Q("R_1", "N", N_("force of all the planet gears on the axis of the sun"))
    R_3 = Q("R_3", "N", N_("force of all the planet gears on the axis of the ring"))
    saved_share = Q("delta_m", "%", N_("what the smallest planet gear saves of the mass of the largest"))


class Set(Row):
    """Of a set of teeth of the family."""

    t = Q("t", "", N_("number of the set"))
    z1, z2, z3, z4, z5 = map(_teeth, "12345")
    residue_4 = Q("epsilon_4", "", N_("residue of assembly of the middle planet gear, pitches"))
    gap_2_4 = Q(Symbol(GAP, "2,4"), "m", Message(FREE, {"pair": "2–4"}), *MM)
    gap_4_5 = Q(Symbol(GAP, "4,5"), "m", Message(FREE, {"pair": "4–5"}), *MM)
    closed_2_4 = Q(
        Symbol(GAP, "2,4"),
        "m",
        N_("free distance between the tip circles of planet gears 2–4 in closed form"),
        *MM,
    )


class Near(Sheet):
    """Of a set of teeth near the ratio."""

    place = Q(None, "", N_("place in the ranking"))
    u = Q("u", "", RATIO)
    delta_u = Q(Symbol("Delta", "u"), "%", N_("deviation of the ratio from the required one"))
    held = Q(None, "", N_("number of planet gears"))


def _mass(wheel: str) -> Q:
    return Q(Symbol("m", wheel), "kg", Message(N_("mass of planet gear %(wheel)s"), {"wheel": wheel}))


class Masses(Row):
    """Of the satellites of a set of the family."""

    t = Set.t.called(Symbol("t"))
    m2, m4, m5 = map(_mass, "245")
    held = Q("m_Sigma", "kg", N_("mass of the planet gears that the set holds together"))
    saving = Q("Deltam", "kg", N_("what the smallest planet gear saves in place of the largest"))


class Satellite(Row):
    z = Q("z", "", N_("number of teeth"), digits=WHOLE)
    phi1 = Q("phi_1", "deg", N_("angle at the axis of the sun"), digits=6)
    phi3 = Q("phi_3", "deg", N_("angle at the axis of the ring"), digits=6)
    x = Q("x", "m", N_("x of the centre, from the axis of the sun"), *MM)
    y = Q("y", "m", N_("y of the centre, from the axis of the sun"), *MM)
    L = Q("L", "", N_("pitches in the closed line of assembly"), digits=7)
    residue = Q("epsilon", "", N_("residue of assembly, pitches"))
    l = Q("l", "m", N_("distance of the centre from the axis of the sun"), *MM, digits=6)
    rho = Q(
        "rho", "m",
        N_("radius of curvature of the flank where the tip of the ring of full height touches it"), *MM,
    )  # fmt: skip
    z3_least = Q(
        Symbol("z", "3,min"), "",
        N_("least teeth of a ring without shift that does not interfere with the planet gear"),
    )  # fmt: skip


class Loaded(Row):
    """Of the forces on a satellite."""

    gamma = Q(
        "gamma", "deg", N_("angle at the planet gear between the directions from the axes of sun and ring")
    )
    w = Q("w", "", N_("number by which the planet gear shares the force"))
    F_t = Q("F_t", "N", N_("circumferential force in both meshes of the planet gear"))
    F_n = Q("F_n", "N", N_("normal force in both meshes of the planet gear"))
    Q_ = Q("Q", "N", N_("force of the planet gear on its axis"), key="Q")


def of_satellite(wheel: str) -> dict[str, str]:
    """What the indices of its letters have besides."""
    return {"phi1": f",{wheel}", "phi3": f",{wheel}", **dict.fromkeys(("z", "L", "l", "rho"), wheel)}


class Pair(Row):
    """Two satellites side by side."""

    l = Q("l", "m", N_("centre distance"), *MM, digits=6)
    gap = Q(GAP, "m", N_("free distance between the tip circles"), *MM, digits=4)


class Wheel(Row):
    z = Q("z", "", N_("number of teeth"))
    d, d_b, d_a, d_f = (Q(math_symbol(of), "m", DIAMETERS[of], *MM) for of in ("d", "d_b", "d_a", "d_f"))


class Mesh(Sheet):
    """Of the teeth of two wheels over a pitch."""

    overlap = Q(None, "m²", N_("largest overlap of the teeth over a pitch"), "mm²")
    clearance = Q(None, "m", N_("least clearance of the teeth over a pitch"), "mm")


class Members(Sheet):
    """Columns of the speeds, one of each member by its name."""

    omega = Q("omega", "rad/s", N_("angular velocity of member %(name)s"))


class OfPath(Sheet):
    """Of a point whose path is drawn; its name stands in key, letter and meaning."""

    radius = Q("rho", "m", N_("distance of point %(name)s from the axis of its wheel"), *MM)
    angle = Q("alpha", "deg", N_("angle of point %(name)s at the start, from the line of the axes"))
    rate = Q("u", "", N_("turns of the wheel of point %(name)s for one of the axes"))
    enlargement, reduction = Q(None, "", LARGER), Q(None, "", SMALLER)
    turns = Q(None, "", N_("turns of the axes after which the path of point %(name)s closes"))


AXIS = N_("%(axis)s of point %(name)s, from the axis of the wheel that stands still")


class Place(Row):
    """Of a position of a path."""

    position = Q(None, "", N_("number of the position"))
    theta = Q("theta", "deg", N_("angle turned by the body of the axes"))
    psi = Q("psi", "deg", N_("angle turned by the wheel of the point"))
    x, y = Q("x", "m", AXIS, *MM), Q("y", "m", AXIS, *MM)


def of_path(path: Traced) -> dict[str, Q]:
    """What the single numbers of a path are called."""
    name, (wheel, held) = path.name, path.point.members
    called = {"radius": Symbol("rho", name), "angle": Symbol("alpha", name), "turns": None,
              "rate": Symbol("u", wheel + CARRIER, held)}  # fmt: skip
    return {key: OfPath.DECLARED[key].called(symbol, name=name) for key, symbol in called.items()}


def of_place(path: Traced) -> dict[str, Q]:
    """What its coordinates are called."""
    name = path.name
    return {axis: Place.DECLARED[axis].called(Symbol(axis, name), axis=axis, name=name) for axis in "xy"}
