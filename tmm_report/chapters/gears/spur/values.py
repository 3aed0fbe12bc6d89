"""The single numbers of a spur stage; they belong to its quantities and stand here for their length."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.gears.spur.solve.motion import sliding_limit
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.mechanics.gears import shift_sharing
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.gear_terms import HA, C

Row = tuple[str, Symbol | None, str, str, float]  # key, symbol, unit, meaning, number


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the pair; every key begins with `prefix`."""
    topics = (_pair, _given, _teeth, _section, _shifts, _quality, _motion, _drawing)
    for key, symbol, unit, meaning, number in (row for topic in topics for row in topic(found)):
        shown = float(np.degrees(number)) if unit == "deg" else float(number)
        yield Quantity(f"{prefix}_{key}", symbol, unit, Message(meaning)).value(shown)


def _pair(found: Found) -> Iterator[Row]:
    p = found.pair
    sum_ = Symbol("x", "d" if p.internal else "Sigma")
    yield "ratio", _ratio(found), "", N_("ratio of the angular velocities"), p.ratio
    yield "a", Symbol("a"), "m", N_("reference centre distance"), p.a
    yield "a_w", Symbol("a", "w"), "m", N_("centre distance"), p.a_w
    yield "alpha_w", Symbol("alpha", "w"), "deg", N_("operating pressure angle"), p.alpha_w
    yield (
        "x_sum",
        sum_,
        "",
        N_("sum of the shift coefficients (of an internal pair, their difference)"),
        p.x_sum,
    )
    yield "y", Symbol("y"), "", N_("coefficient of the shift of the centres"), p.y
    yield "shortening", Symbol("Deltay"), "", N_("coefficient of the shortening of the tips"), p.shortening
    yield "p", Symbol("p"), "m", N_("pitch"), p.p
    yield "p_b", Symbol("p", "b"), "m", N_("base pitch"), p.p_b
    yield "p_w", Symbol("p", "w"), "m", N_("pitch on the working circles"), p.p_w
    yield "backlash", Symbol("j", "w"), "m", N_("backlash on the working circles"), p.backlash
    line = N_("theoretical line of action, between its points of contact with the base circles")
    yield "line", segment("N1N2"), "m", line, p.line
    yield "active", segment("AB"), "m", N_("active part of the line of action"), p.active
    yield "eps", Symbol("epsilon", "alpha"), "", N_("contact ratio"), p.eps
    if found.cut_short:
        line = N_("line of action between the tip circles")
        yield "active_tips", segment("A0B0"), "m", line, p.active_tips
        yield "eps_tips", Symbol("epsilon", "0"), "", N_("contact ratio by the tip circles alone"), p.eps_tips
    share = N_("share of the time in which two pairs are in mesh")
    yield "two_pairs", Symbol("delta", "2"), "", share, p.two_pairs


def _ratio(found: Found) -> Symbol:
    return Symbol("u", "".join(found.given.wheels))


def _given(found: Found) -> Iterator[Row]:
    given, rack = found.given, found.pair.rack
    yield "u_required", _ratio(found), "", N_("required ratio of the angular velocities"), given.ratio
    yield "m", Symbol("m"), "m", N_("module"), given.module
    yield "alpha", Symbol("alpha"), "deg", N_("profile angle of the basic rack"), rack.alpha
    yield "ha", HA, "", N_("coefficient of the height of the head"), rack.ha
    yield "c", C, "", N_("coefficient of the radial clearance"), rack.c
    if given.helix:
        yield "beta", Symbol("beta"), "deg", N_("helix angle"), given.helix
    if given.width is not None:
        yield "b", Symbol("b"), "m", N_("face width"), given.width


def _teeth(found: Found) -> Iterator[Row]:
    """How the numbers of teeth were found."""
    if (choice := found.teeth.choice) is None:
        return
    names, small = found.given.wheels, found.teeth.small
    bound = Symbol("z", "d" if found.given.internal else "Sigma")
    text = N_("what the sum of the numbers of teeth (of an internal pair, their difference) must not exceed")
    yield "u", Symbol("u"), "", N_("required ratio of the larger number of teeth to the smaller"), choice.u
    yield "z_bound", bound, "", text, choice.bound
    smaller = N_("teeth of the smaller wheel before rounding")
    larger = N_("teeth of the larger wheel by the ratio, before rounding")
    yield "z_share", Symbol("z", names[small]), "", smaller, choice.share
    yield "z_larger", Symbol("z", names[1 - small]), "", larger, choice.larger
    spare = N_("what the numbers of teeth leave of their bound")
    yield "z_spare", Symbol("Delta", "z"), "", spare, choice.spare


def _section(found: Found) -> Iterator[Row]:
    """The transverse section of helical teeth, and the involute functions of both angles."""
    p, helical = found.pair, found.pair.beta > 0
    if helical:
        yield "m_t", Symbol("m", "t"), "m", N_("module of the transverse section"), p.m_t
        yield "alpha_t", Symbol("alpha", "t"), "deg", N_("profile angle in the transverse section"), p.t.alpha
    profile, operating = found.involutes
    name = Symbol("inv α", "t" if helical else "")
    yield "inv_alpha", name, "", N_("involute function of the profile angle"), profile
    yield "inv_alpha_w", Symbol("inv α", "w"), "", N_("involute function of the operating angle"), operating


def _shifts(found: Found) -> Iterator[Row]:
    p = found.pair
    sum_ = Symbol("x", "d" if p.internal else "Sigma")
    needed = N_("sum of the shifts (of an internal pair, their difference) that leaves no backlash")
    least = N_("least number of teeth without undercut, by the rule")
    stated = found.given.shift
    if found.altered and isinstance(stated, tuple):
        for wheel, x in zip(found.given.wheels, stated, strict=True):
            text = N_("shift coefficient that is stated")
            yield f"x_stated_{wheel}", Symbol("x", f"st{wheel}"), "", text, x
    if found.loose:
        yield "x_needed", sum_, "", needed, found.needed
    yield "z_rule", Symbol("z", "min"), "", least, shift_sharing.rule_teeth(p.rack)
    yield "backlash_n", Symbol("j", "n"), "m", N_("backlash along the line of action"), p.normal_backlash


def _quality(found: Found) -> Iterator[Row]:
    p, width = found.pair, found.given.width
    zone = N_("each of the two parts of the line of action with two pairs in mesh")
    if found.two_zones:
        yield "two_length", segment("AC"), "m", zone, p.active - p.p_b
    if p.beta > 0 and width is not None:
        yield (
            "eps_beta",
            Symbol("epsilon", "beta"),
            "",
            N_("overlap ratio of helical teeth"),
            p.overlap(width),
        )


def _motion(found: Found) -> Iterator[Row]:
    """At the speed of the drive."""
    if (motion := found.motion) is None:
        return
    for wheel, omega in zip(found.given.wheels, motion.omega, strict=True):
        yield (
            f"omega_{wheel}",
            Symbol("omega", wheel),
            "rad/s",
            N_("magnitude of the angular velocity"),
            omega,
        )
    pitch = N_("pitch-line velocity, that of the point of contact in the pitch point")
    yield "v_pitch", Symbol("V"), "m/s", pitch, motion.pitch
    if found.given.sliding_limit is None:
        limit = N_("largest specific sliding allowed at this pitch-line velocity")
        yield "sliding_limit", Symbol("lambda", "max"), "", limit, sliding_limit(motion.pitch)
    along = N_("velocity of both teeth along the line of action, at any of its points")
    yield "v_along", Symbol("V", "n"), "m/s", along, motion.along
    way = abs(float(found.path.at.rho[motion.fastest]) - float(found.pair.rho_w[0]))
    far = N_("distance of the pitch point from the end of the active part where the profiles slide fastest")
    yield "v_way", segment("P" + list(found.path.points)[motion.fastest]), "m", far, way


def _drawing(found: Found) -> Iterator[Row]:
    """Of the drawing of the mesh, and of the outlines turned over a pitch."""
    scale, proof = found.mesh.scale, found.proof
    read = N_("accuracy to which places are read off the drawing of the mesh")
    yield "accuracy", None, "m", read, found.given.accuracy
    yield "scale", None, "", N_("lengths of the drawing of the mesh to those of the wheels"), scale
    yield "reduction", None, "", N_("lengths of the wheels to those of the drawing of the mesh"), 1 / scale
    if not found.beyond:
        round_scale = N_("specific sliding that 1 mm of its graph stands for")
        yield "mu_sliding", Symbol("mu", "lambda"), "1/mm", round_scale, found.sliding_scale
    yield "overlap", None, "m²", N_("largest area that the outlines of the teeth share"), proof.overlap
    yield "clearance", None, "m", N_("smallest distance between the outlines of the teeth"), proof.clearance
    counted = N_("number of pairs in mesh, counted on the outlines")
    yield "eps_counted", None, "", counted, proof.ratio
