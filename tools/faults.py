"""Wrong outputs to be planted one at a time: what is wrong, where, and on which variant it must be noticed.

An edit replaces one short text of a file by another; the text must stand there exactly once, or the edit says so by
its `count`. `tests`: what looks at it beside tests/page.
"""

from __future__ import annotations

from typing import NamedTuple


class Fault(NamedTuple):
    name: str
    file: str
    old: str
    new: str
    variants: str = "crank_rocker"
    tests: tuple[str, ...] = ()


KIN = "tmm_report/chapters/kinematics/"
STATICS = "tmm_report/chapters/kinetostatics/"
FRICTION = "tmm_report/chapters/friction/"
DRIVE = "tmm_report/chapters/drive/"
SPUR = "tmm_report/chapters/spur/"
PLANETARY = "tmm_report/chapters/planetary/"
ECCENTRIC = "tmm_report/chapters/eccentric/"
MECHANICS = "tmm_report/mechanics/"
PAGE = "tmm_report/report/page.py"
MODEL = "tmm_report/quantity/model.py"
SCHEME = ("tests/figures/test_scheme.py",)
MESH = ("tests/figures/test_gearing.py",)

FAULTS = (
    # --- kinetostatics ---
    Fault("reactions turned by 180° in their table", STATICS + "quantities.py",
          "np.degrees(np.angle(force)) % 360", "np.degrees(np.angle(-force)) % 360"),
    Fault("the driver's reaction turned by 180°", MECHANICS + "statics.py",
          "Reaction(pair, -driver.force, 0.0", "Reaction(pair, driver.force, 0.0"),
    Fault("inertia forces doubled", STATICS + "solve.py",
          "-link.mass * motion.acceleration(", "-2 * link.mass * motion.acceleration("),
    Fault("inertia forces along the accelerations", STATICS + "solve.py",
          "link.name: -link.mass * motion.acceleration(", "link.name: link.mass * motion.acceleration("),
    Fault("inertia couples with the wrong sign", STATICS + "solve.py",
          "-link.inertia * motion.angular_acceleration", "link.inertia * motion.angular_acceleration"),
    Fault("half of every weight", STATICS + "solve.py",
          "link.mass * given.gravity * one", "link.mass * given.gravity * one / 2"),
    Fault("forces against the motion act along it", STATICS + "solve.py",
          'along if force.direction == "along" else -along', '-along if force.direction == "along" else along',
          "shaper"),
    Fault("moments against the rotation act along it", STATICS + "solve.py",
          'sense if moment.direction == "along" else -sense', '-sense if moment.direction == "along" else sense'),
    Fault("names of the power table swapped", STATICS + "quantities.py",
          "(inertia_force(link), weight(link)) for link in load.inertia",
          "(inertia_force(link), weight(link)) for link in reversed(load.inertia)"),
    Fault("powers of inertia couples negated", STATICS + "solve.py",
          "[couple * motion.angular_velocity(link)", "[-couple * motion.angular_velocity(link)"),
    Fault("sum of the powers negated", STATICS + "quantities.py",
          "TOTAL_POWER.column(np.sum(", "TOTAL_POWER.column(-np.sum("),
    Fault("the power-balance column negated", STATICS + "quantities.py",
          "BY_POWER.column(solved.power)", "BY_POWER.column(-solved.power)"),
    Fault("rows of the lever's moment shifted by one", STATICS + "quantities.py",
          "BY_LEVER.column(solved.lever)", "BY_LEVER.column(np.roll(solved.lever, 1))"),
    Fault("the guide's moment with the wrong sign", STATICS + "quantities.py",
          "column(full.moment)", "column(-full.moment)", "shaper"),
    Fault("weights printed of the wrong link", STATICS + "view.py",
          "cell = self.page.cell(table, of.key, 0, size=True)",
          'cell = self.page.cell(table, "G_3", 0, size=True)'),
    Fault("the unit of the results over converted numbers", PAGE,
          "self.head(column.symbol(), unit or column.unit), cells, least)",
          "self.head(column.symbol(), column.unit), cells, least)"),
    Fault("forces of the lever reversed", STATICS + "draw.py",
          "arrow = force / abs(force)", "arrow = -force / abs(force)"),
    # --- kinematics ---
    Fault("a rocker's degrees left in radians", PAGE,
          "numbers = column.numbers(unit)[:rows]", "numbers = column.numbers()[:rows]"),
    Fault("rows of a table shifted by one", PAGE,
          "texts = self.col(np.abs(numbers) if size else numbers, digits)",
          "texts = self.col(np.roll(np.abs(numbers) if size else numbers, 1), digits)"),
    Fault("the number of a neighbouring position", PAGE,
          "of[key].number(row, unit), of.ref(", "of[key].number(row - 1, unit), of.ref("),
    Fault("magnitudes for signed numbers", PAGE,
          "self.col(np.abs(numbers) if size else numbers, digits)", "self.col(np.abs(numbers), digits)"),
    Fault("velocity and acceleration swapped", KIN + "quantities.py",
          "(travel.S, travel.V, travel.a), (", "(travel.S, travel.a, travel.V), ("),
    Fault("displacement counted from nowhere", KIN + "solve.py", "S, dS = S - start, dS - start", "S, dS = -S, -dS",
          "compressor"),
    Fault("least and greatest swapped", KIN + "quantities.py",
          'zip(("min", "max"), texts, pair', 'zip(("min", "max"), texts, pair[::-1]'),
    Fault("rates of links with the wrong sign", KIN + "quantities.py",
          "yield quantities[key].column(numbers)", "yield quantities[key].column(-numbers)"),
    Fault("x of points equal to y", KIN + "quantities.py",
          'N_("x of point %(name)s"), place.real', 'N_("x of point %(name)s"), place.imag'),
    Fault("angles of links in radians under degrees", KIN + "quantities.py",
          "np.degrees(np.angle(motion.turn(link)))", "np.angle(motion.turn(link))"),
    Fault("angles of extremes in radians", KIN + "view.py",
          "Cell(self.page.num(np.degrees(value.at), places=places), Ref(",
          "Cell(self.page.num(value.at, places=places), Ref("),
    Fault("half the stroke", KIN + "quantities.py", ".value(travel.stroke)", ".value(travel.stroke / 2)"),
    Fault("time ratio upside down", KIN + "solve.py",
          "max(back, cycle.sweep - back) / min(", "min(back, cycle.sweep - back) / max("),
    Fault("angle of position 0 with the wrong sign", KIN + "quantities.py",
          "math.degrees(found.cycle.zero)", "-math.degrees(found.cycle.zero)"),
    Fault("Coriolis acceleration halved", MECHANICS + "dyads.py",
          "(2 * rate) * s.iw", "(1 * rate) * s.iw", "shaper"),
    Fault("y of vectors equal to x", MODEL, '("y", Y_PART, np.imag)', '("y", Y_PART, np.real)'),
    Fault("the size of a vector is its x", MODEL,
          "self.column(np.abs(values))", "self.column(np.real(values))"),
    Fault("clockwise and counter-clockwise swapped", "tmm_report/report/words.py",
          'page.t("counter-clockwise") if direction > 0', 'page.t("counter-clockwise") if direction < 0'),
    Fault("right and left swapped", "tmm_report/report/words.py",
          '{1: N_("to the right"), -1: N_("to the left")', '{-1: N_("to the right"), 1: N_("to the left")',
          "compressor"),
    Fault("up and down swapped", "tmm_report/report/words.py",
          '1j: N_("upwards"), -1j: N_("downwards")', '-1j: N_("upwards"), 1j: N_("downwards")'),
    # --- friction ---
    Fault("driving power divided by the speed", FRICTION + "solve.py",
          "np.abs(solved.balancing * omega)", "np.abs(solved.balancing / omega)"),
    Fault("one pair left out of the losses", FRICTION + "solve.py",
          "[loss.power for loss in self.pairs]", "[loss.power for loss in self.pairs[1:]]"),
    Fault("losses in place of the efficiency", FRICTION + "solve.py",
          "self.driving / (self.driving + self.total)", "self.total / (self.driving + self.total)"),
    Fault("diameter of a journal for its radius", FRICTION + "solve.py",
          "(rubbing.diameter or 0.0) / 2", "(rubbing.diameter or 0.0) / 1"),
    Fault("names of the pairs' losses swapped", FRICTION + "quantities.py",
          "yield lost(loss.pair, pairs).column(loss.power)",
          "yield lost(pairs[-1 - pairs.index(loss.pair)], pairs).column(loss.power)"),
    # --- drawings ---
    Fault("vertices of a plan mislettered", "tmm_report/chapters/plans/draw.py",
          "plan(vectors, drawn.vertices,",
          "plan(vectors, dict(zip(drawn.vertices, reversed(drawn.vertices.values()))),"),
    Fault("arrows reversed", "tmm_report/figures/plans.py",
          "Arrow(vector.start, vector.end, pen,", "Arrow(vector.end, vector.start, pen,"),
    Fault("vectors of a plan twice as long", "tmm_report/chapters/plans/draw.py",
          "PlanVector(s.start, s.end,", "PlanVector(2 * s.start, 2 * s.end,"),
    Fault("forces of a plan reversed", "tmm_report/chapters/force_plans/draw.py",
          "PlanVector(s.start, s.end,", "PlanVector(s.end, s.start,"),
    Fault("a scheme of the wrong position", "tmm_report/report/schemes.py",
          "self.scale, position, zero)", "self.scale, position - 1, zero)"),
    Fault("a scheme at another scale than stated", "tmm_report/report/schemes.py",
          "turns, self.scale, position, zero)", "turns, 2 * self.scale, position, zero)"),
    Fault("drawings upside down", "tmm_report/figures/primitives.py",
          "_number(self.centre.real), _number(-self.centre.imag)",
          "_number(self.centre.real), _number(self.centre.imag)"),
    # --- text and mathematics ---
    Fault("the minus sign lost", "tmm_report/quantity/text.py", "Parts(x < 0 and", "Parts(False and"),
    Fault("centimetres under millimetres", "tmm_report/quantity/units.py",
          '("m", "mm"): 1e3', '("m", "mm"): 1e2', "hoist_drive"),
    Fault("indices above and below swapped", "tmm_report/quantity/symbols.py",
          "notation.text(symbol.sub), notation.text(symbol.sup)",
          "notation.text(symbol.sup), notation.text(symbol.sub)"),
    Fault("fractions of LaTeX upside down", "tmm_report/quantity/symbols.py",
          "\\\\frac{{{above}}}{{{below}}}", "\\\\frac{{{below}}}{{{above}}}"),
    Fault("cells of LaTeX in reverse order", "templates/macros.tex.j2",
          "{% for cell in row %}{{ cell }}{% if not loop.last %} & ",
          "{% for cell in row|reverse %}{{ cell }}{% if not loop.last %} & "),
    # --- gears ---
    Fault("revolutions by the wrong factor", DRIVE + "quantities.py", "w * 30 / math.pi", "w * math.pi / 30",
          "hoist_drive"),
    Fault("external powers negated", DRIVE + "quantities.py",
          "power.column([float(x) for x in loads.power.values()])",
          "power.column([-float(x) for x in loads.power.values()])", "hoist_drive"),
    Fault("the driven wheel called driving", DRIVE + "quantities.py",
          "mesh.i if power > 0 else mesh.j if power < 0", "mesh.i if power < 0 else mesh.j if power > 0",
          "hoist_drive"),
    Fault("ratio of the drive without its first stage", DRIVE + "quantities.py",
          'N_("ratio of the drive, second inputs at rest"), found.geared',
          'N_("ratio of the drive, second inputs at rest"), found.geared / found.stages[0].ratio', "hoist_drive"),
    Fault("base circles by the sine", MECHANICS + "wheels.py",
          "self.d[i] * np.cos(self.t.alpha)", "self.d[i] * np.sin(self.t.alpha)", "hoist_drive"),
    Fault("involutes of a thickness added for subtracted", MECHANICS + "wheels.py",
          "(inv(self.t.alpha) - inv(alpha))", "(inv(self.t.alpha) + inv(alpha))", "hoist_drive"),
    Fault("working circles by the wrong angle", MECHANICS + "wheels.py",
          "self.d_b[i] / np.cos(self.alpha_w)", "self.d_b[i] / np.cos(self.t.alpha)", "hoist_drive",
          ("tests/mechanics/test_spur.py",)),
    Fault("ratio of a motion upside down", PLANETARY + "motions.py",
          "return 1 / self.speed[self.output]", "return self.speed[self.output]", "hoist_drive"),
    Fault("satellites' meshes inside and outside swapped", ECCENTRIC + "motion.py",
          "Mesh(body.name, RING, CARRIER, internal=True)", "Mesh(body.name, RING, CARRIER)", "eccentric"),
    Fault("teeth of a mesh turned", SPUR + "mesh.py",
          "self.wheels[i].outline * cmath.exp(1j * self.turn(i, place))",
          "self.wheels[i].outline * cmath.exp(1j * (self.turn(i, place) + 0.01))", "hoist_drive", MESH),
    Fault("working flanks of a mesh turned", SPUR + "mesh.py",
          "self.mm * own * cmath.exp(1j * self.turn(i, place))",
          "self.mm * own * cmath.exp(1j * (self.turn(i, place) + 0.01))", "hoist_drive", MESH),
    Fault("circles of a mesh by diameters", SPUR + "draw/mesh.py",
          "radius = sheet.mesh.radius(diameters, i)", "radius = 2 * sheet.mesh.radius(diameters, i)",
          "hoist_drive", MESH),
    # --- the wrong root ---
    Fault("the other assembly of a dyad", MECHANICS + "dyads.py",
          "x = (distance * distance + (pp - abs(q) ** 2)) / (2 * distance)",
          "x = (distance * distance - (pp - abs(q) ** 2)) / (2 * distance)", "crank_rocker",
          ("tests/test_golden.py",)),
)  # fmt: skip
