"""The numbers of the wear: of a guide and of a pivot, of their faces, points, positions and sectors."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

WORDS = (NP_("index", "bound"), NP_("index", "unif"), NP_("index", "rep"), NP_("index", "begin"))

K_UNIT, K_SIZE = "mm³/(kN·m)", 1e12  # of a coefficient, which in 1/Pa has fifteen noughts


class Guide(Sheet):
    """A guide with its slider."""

    stroke = Q("S_max", "m", N_("stroke of the slider"), "mm", formed="mm")
    slider = Q("l_s", "m", N_("length of the slider"), "mm", formed="mm")
    length = Q("L", "m", N_("length of the guide that wears"), "mm", formed="mm")
    width = Q("b", "m", N_("width of the faces"), "mm", formed="mm")
    parts = Q("N", "", N_("number of equal parts of the guide"))
    step = Q("Delta_L", "m", N_("length of a part"), "mm", formed="mm")
    ratio = Q("n_s", "", N_("parts of the guide on the length of the slider"))
    covered = Q("N_s", "", N_("points of the guide under the slider"))
    positions = Q("P", "", N_("positions of the cycle over which it is summed"))
    cycles = Q("N_c", "", N_("number of cycles"))
    period = Q("T", "s", N_("time of a cycle"))
    time = Q("t_c", "h", N_("time of all the cycles"))
    greatest = Q("u_max", "m", N_("greatest wear"), "µm", formed="µm")
    repair = Q("x_rep", "m", N_("place of the guide worn most, from its beginning"), "mm")
    even = Q("u_unif", "m", N_("wear of that face of the guide if it wore evenly"), "µm", formed="µm")
    uneven = Q("kappa", "", N_("unevenness, ratio of the greatest wear of that face to the even one"))
    shift = Q("delta_max", "m", N_("greatest displacement of the slider across the guide"), "µm")
    tilt = Q("theta_max", "rad", N_("greatest tilt of the slider"), "deg")
    rate = Q("gamma", "µm/h", N_("rate of steady wear where it is greatest"))
    limit = Q("u_bound", "m", N_("limit of the wear"), "µm", formed="µm")
    run_in = Q("u_0", "m", N_("wear of running in"), "µm", formed="µm")
    constant = Q("tau", "h", N_("time constant of running in"))
    life = Q("t_bound", "h", N_("time until the limit of the wear"))
    life_cycles = Q("N_bound", "", N_("cycles until the limit of the wear"))
    volume = Q("V", "m³", N_("volume worn off slider and guide"), "mm³")
    density = Q("rho", "kg/m³", N_("density of the material"))
    mass = Q("m", "kg", N_("mass worn off slider and guide"))


class Surfaces(Sheet):
    """Columns of the faces; their symbols have the indices of the rows."""

    pressure = Q("p", "Pa", N_("mean pressure"), "MPa")
    k = Q("k", K_UNIT, N_("wear coefficient"))
    c = Q("c", "µm/(N·m)", N_("wear of a point per unit of its sum"))
    work = Q("W_max", "N·m", N_("greatest sum of a point"))
    rubbed = Q("W", "N·m", N_("sum over all the points"))
    depth = Q("u_max", "m", N_("greatest wear"), "µm")
    volume = Q("V", "m³", N_("volume worn off"), "mm³")


class Profile(Sheet):
    """Along the guide."""

    point = Q("j", "", N_("point of the guide"))
    x = Q("x", "m", N_("place from the beginning of the guide"), "mm")
    resistance = Q(
        "epsilon", "", N_("relative wear resistance with which the face worn most would wear evenly")
    )
    even = Q("u_unif", "m", N_("wear of that face if it wore evenly"), "µm")


class Sole(Sheet):
    """Along the slider."""

    point = Q("k", "", N_("point of the slider"))
    xi = Q("xi", "m", N_("place from the middle of the slider"), "mm")


class Depths(Sheet):
    """Of a face, along the guide or the slider."""

    work_force = Q("W", "N·m", N_("sum of the central reaction, %(face)s"))
    work_couple = Q("W", "N·m", N_("sum of the moment of the reaction, %(face)s"))
    u_force = Q("u", "m", N_("wear by the central reaction, %(face)s"), "µm")
    u_couple = Q("u", "m", N_("wear by the moment of the reaction, %(face)s"), "µm")
    u = Q("u", "m", N_("wear of the %(face)s"), "µm")


class Cycle(Sheet):
    """The slider over the cycle."""

    phi = Q("phi", "rad", N_("angle turned from position 0"), "deg")
    S = Q("S", "m", N_("displacement from the beginning of the stroke"), "mm")
    start = Q("N_begin", "", N_("first point of the guide under the slider"))
    q = Q("q", "m", N_("velocity analogue of the slider"))
    R = Q("R", "N", N_("reaction of the guide, + upwards"))
    M = Q("M", "N·m", N_("moment of the reaction about the slider's middle"))
    h = Q("h", "m", N_("arm of the reaction about the slider's middle"), "mm")
    F_M = Q("F_M", "N", N_("force of the couple"))
    shift = Q("delta", "m", N_("displacement of the worn slider across the guide"), "µm")
    tilt = Q("theta", "rad", N_("tilt of the worn slider, positive counter-clockwise"), "deg")


UPRIGHT = Q("R", "N", N_("reaction of the guide, + to the left"))


class Stages(Sheet):
    """The greatest wear against the time."""

    t = Q("t", "h", N_("time of work"))
    u = Q("u", "m", N_("greatest wear"), "µm")


class Pivot(Sheet):
    diameter = Q("d", "m", N_("diameter of the journal"), "mm")
    width = Q("b", "m", N_("width of the bushing"), "mm")
    arc = Q("alpha", "rad", N_("half the angle of contact"), "deg", formed="")
    sectors = Q("N", "", N_("number of sectors of the circumference"))
    positions = Q("P", "", N_("positions of the cycle over which it is summed"))
    cycles = Q("N_c", "", N_("number of cycles"))
    pressure = Q("p", "Pa", N_("mean pressure on the projection of the journal"), "MPa")
    rubbed = Q("W", "N·m", N_("sum of the products of reaction and path over a cycle"), formed="kN·m")
    spread = Q("lambda", "", N_("ratio of the sum of the pressures to the reaction"))
    greatest = Q("u_max", "m", N_("greatest wear"), "µm")
    limit = Q("u_bound", "m", N_("limit of the wear"))
    life_cycles = Q("N_bound", "", N_("cycles until the limit of the wear"))


class Members(Sheet):
    """Columns of journal and bushing; their symbols have the numbers of the rows."""

    k = Q("k", K_UNIT, N_("wear coefficient"))
    path = Q("w_max", "MPa·m", N_("greatest sum of the products of pressure and path"))
    depth = Q("u_max", "m", N_("greatest wear"), "µm")
    angle = Q("alpha_max", "rad", N_("angle of that sector from the x axis of the link"), "deg")
    volume = Q("V", "m³", N_("volume worn off"), "mm³")
    mass = Q("m", "kg", N_("mass worn off"), "g")


class Sectors(Sheet):
    """Along the circumference."""

    alpha = Q("alpha", "rad", N_("angle of the sector's middle"))
    path = Q("w", "MPa·m", N_("sum of the products of pressure and path, %(member)s"))
    u = Q("u", "m", N_("wear, %(member)s"))
