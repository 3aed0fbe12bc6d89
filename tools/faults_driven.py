"""Wrong outputs to be planted: chapters of mechanisms with wheels in mesh, and of those that a stroke drives."""

from __future__ import annotations

from faults import DRIVEN, FORCES, LIFTED, MECHANICS, Fault

SUN = "sun_and_planet"
PLANS = ("tests/chapters/lever/force_plans",)
RUBBED, COUPLED = MECHANICS + "lever/forces/reactions_with_friction.py", MECHANICS + "lever/wheels/coupled.py"
RUBBING = ("tests/chapters/lever/friction/test_friction_of_wheels.py",)
SLIDING = ("tests/chapters/lever/friction/test_friction_of_strokes.py",)
BALANCING = ("tests/chapters/machine/balancing",)
WHEEL, THRUST, LEVER = FORCES + "drafting/wheel.py", FORCES + "drafting/thrust.py", FORCES + "lever.py"

FAULTS = (
    # --- force plans ---
    Fault(
        "the teeth press the other flank",
        WHEEL,
        "along, teeth = _line(sheet, wheel, -moment)",
        "along, teeth = _line(sheet, wheel, moment)",
        SUN,
        PLANS,
    ),
    Fault(
        "the arm of the teeth is the pitch radius",
        WHEEL,
        "radius * cos(replace(angle, number=mesh.pressure))",
        "radius * cos(replace(angle, number=0.0))",
        SUN,
        PLANS,
    ),
    Fault(
        "the teeth load no other wheel", WHEEL, "    sheet.load(wheel.contact, link, force)\n", "", SUN, PLANS
    ),
    Fault(
        "a rack pressed on the other flank",
        WHEEL,
        "_line(sheet, wheel, -float(dot(loads[-1]",
        "_line(sheet, wheel, float(dot(loads[-1]",
        SUN,
        PLANS,
    ),
    Fault(
        "the force of a rack loads nothing",
        WHEEL,
        "    sheet.pass_on(wheel.contact, link, end - tip, mu)\n",
        "",
        SUN,
        PLANS,
    ),
    Fault(
        "the wheels taken off from the first on",
        FORCES + "drafting/__init__.py",
        "for one in reversed(wheels):",
        "for one in wheels:",
        SUN,
        PLANS,
    ),
    Fault(
        "the part across the rod turned round",
        THRUST,
        "vector = 1j * line.out * formulas[-1].written",
        "vector = -1j * line.out * formulas[-1].written",
        LIFTED,
        PLANS,
    ),
    Fault(
        "the part along the rod turned round",
        THRUST,
        "(-moment if turning > 0 else moment) / arm",
        "(moment if turning > 0 else -moment) / arm",
        LIFTED,
        PLANS,
    ),
    Fault(
        "the barrel of a cylinder without its loads",
        THRUST,
        "bodies = (end,) if stroke.slides else stroke.by",
        "bodies = (end,)",
        LIFTED,
        PLANS,
    ),
    Fault(
        "a force against the stroke above zero",
        THRUST,
        "sign = -1 if dot(end - tip, line.along) < 0 else 1",
        "sign = 1",
        DRIVEN,
        PLANS,
    ),
    Fault(
        "a couple on a wheel is nothing on the lever",
        LEVER,
        "ends = self._ends(link) or self._radius(link)",
        "ends = self._ends(link)",
        SUN,
        PLANS,
    ),
    Fault(
        "a lever's force along the stroke turned round",
        LEVER,
        "(-sum_of if arm > 0 else sum_of) / over",
        "-sum_of / over",
        DRIVEN,
        PLANS,
    ),
    Fault(
        "a lever's force beside a moment by power",
        LEVER,
        '"power": solved.power * transfer',
        '"power": solved.power',
        LIFTED,
        PLANS,
    ),
    Fault(
        "a balancing force along the stroke in the pole",
        FORCES + "lever_draw.py",
        "            balancing.place,\n",
        "            0j,\n",
        LIFTED,
    ),
    # --- friction and balancing of mechanisms with wheels ---
    Fault(
        "parts of a wheel's force on flanks of their own",
        RUBBED,
        "_stacked(loads, units, shape), flanks.get(GEAR), flanks)",
        "_stacked(loads, units, shape), flanks.get(GEAR))",
        SUN,
        RUBBING,
    ),
    Fault(
        "a wheel's flank of the other sense",
        COUPLED,
        "dot(teeth, across) >= 0, 1.0, -1.0",
        "dot(teeth, across) >= 0, -1.0, 1.0",
        SUN,
        RUBBING,
    ),
    Fault(
        "rails rub",
        "tmm_report/chapters/lever/friction/solve.py",
        'pair.kind == "H" or pair.name in given.rails',
        'pair.kind == "H"',
        "roller_on_rail",
        RUBBING,
    ),
    Fault(
        "the guide of any wheel's axle is a rail",
        "tmm_report/chapters/lever/structure/block/checks.py",
        'rolling = mechanism.get("rolling")',
        'rolling = mechanism.get("racks")',
        "roller_on_rail",
        RUBBING,
    ),
    Fault(
        "a link's tooth load without its moment in the shaking check",
        "tmm_report/mechanics/masses/counterweights.py",
        "moment = moment + sign * (cross(reaction.at - about, reaction.force) + reaction.moment)",
        "moment = moment + sign * reaction.moment",
        SUN,
        BALANCING,
    ),
    # --- friction where a stroke drives ---
    Fault(
        "the power of a stroke by the moment",
        "tmm_report/chapters/lever/friction/solve.py",
        "_wide(statics.driving * speed, motion.shape)",
        "_wide(statics.balancing * speed, motion.shape)",
        LIFTED,
        SLIDING,
    ),
    Fault(
        "friction reduced to a stroke by the phase",
        "tmm_report/chapters/lever/friction/solve.py",
        "self.total / np.abs(self.speed)",
        "self.total / abs(self.omega)",
        LIFTED,
        SLIDING,
    ),
)
