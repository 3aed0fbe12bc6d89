"""Wrong outputs of the living page, to be planted."""

from __future__ import annotations

from faults import Fault

LIVING, SCRIPT = "tmm_report/living/", "templates/living/"
MOVES = ("tests/living/test_living_moves.py",)
LOADS = ("tests/living/test_living_loads.py",)
TOLD = ("tests/living/test_living_told.py",)
PACE = ("tests/living/test_living_pace.py",)
DATA, SEEN = ("tests/living/test_living_data.py",), ("tests/living/test_living_page.py",)

FAULTS = (
    Fault("links go between positions without their accelerations", LIVING + "mechanism.py",
          "a0 * h**2 / 2", "0 * a0 * h**2 / 2", "compressor", DATA),
    Fault("the script goes between positions by the places alone", SCRIPT + "mechanism.js",
          "const c3 = 10 * rise - 6 * first", "const c3 = 10 * rise - 5 * first", "compressor", SEEN),
    Fault("the numbered positions are those of the diagram", LIVING + "cycle.py",
          "np.searchsorted(turned, found.turned - SAME)", "np.arange(len(found.turned))", "compressor", DATA),
    Fault("a vertex of a plan goes against its vector", LIVING + "plans.py",
          "reached[edge.end] = start + way", "reached[edge.end] = start - way", "compressor", DATA),
    Fault("a name ends the block of data", LIVING + "__init__.py",
          '.replace("<", "\\\\u003c")', "", "compressor", DATA),
    Fault("the script is not the one that the policy allows", LIVING + "__init__.py",
          "<script>{script}</script>", "<script>\\n{script}</script>", "compressor", DATA + SEEN),
    Fault("the crank stops where it is let go, not in the position", SCRIPT + "stage.js",
          "const SNAP = 0.12;", "const SNAP = 0;", "compressor", SEEN),
    Fault("print has the plan of another position", SCRIPT + "figures.js",
          'addEventListener("beforeprint", () => restore(document.body));', "", "compressor", SEEN),
    Fault("a copied table keeps the long minus", SCRIPT + "tables.js",
          'said.replace("\\u2212", "-")', "said", "compressor", SEEN),
    Fault("a centre of percussion lies on the other side", LIVING + "loads.py",
          "shift = -1j * force", "shift = 1j * force", "compressor", LOADS),
    Fault("a pair of forces on the lever turns the other way", LIVING + "loads.py",
          "1j * along / np.abs(along) ** 2 * couple", "-1j * along / np.abs(along) ** 2 * couple", "compressor", LOADS),
    Fault("the lever is turned with the rotation", "tmm_report/chapters/lever/force_plans/lever_draw.py",
          "turn=lever.turn", "turn=-lever.turn", "compressor", LOADS),
    Fault("forces of a moving scheme point backwards", SCRIPT + "loads.js",
          "const sense = n ? -1 : 1;", "const sense = n ? 1 : -1;", "compressor", LOADS),
    Fault("the moment over a scheme is that of the position of the plan", SCRIPT + "loads.js",
          "text(value(moment.values))", "text(moment.values[load.position])", "compressor", LOADS),
    Fault("the centre of a cam's curvature stays on its axis", LIVING + "loads.py",
          "return np.where(np.abs(found - self._at(cam.point)) <= REACH, found, np.nan)", "return 0 * found",
          "cam_press", LOADS),
    Fault("what replaces a cam pair leads to the mirrored centre", LIVING + "loads.py",
          "return [[places(centre.real, 2), places(centre.imag, 2)]",
          "return [[places(centre.imag, 2), places(centre.real, 2)]", "cam_press", LOADS),
    Fault("a wheel in mesh slides on the other", LIVING + "moves.py",
          "part.sense * abs(rate) if part.sense else rate", "part.sense or rate", "hoist_drive", MOVES),
    Fault("satellites do not turn of themselves", LIVING + "moves.py",
          "rate = rates.get(part.of, 0.0)", "rate = rates.get(part.about or part.of, 0.0)", "hoist_drive", MOVES),
    Fault("a cam turns against its motion", SCRIPT + "moves.js",
          "if (part.turns) angle = along", "if (part.turns) angle = -along", "valve_cam", MOVES),
    Fault("marks of wheels are seen behind their axes", SCRIPT + "moves.js",
          'style.display = front > 0', 'style.display = front < 0', "hoist_drive", MOVES),
    Fault("marks of wheels go on other radii than their rims", "tmm_report/chapters/gears/drive/draw/pair.py",
          "sketch.mark(x, y, half, one.name)", "sketch.mark(x, y, 0.5 * half + 2, one.name)", "hoist_drive", MOVES),
    Fault("moving teeth are printed with the note's", SCRIPT + "living.css",
          ".loads, .turning, dialog", ".loads, dialog", "hoist_drive", MOVES),
    Fault("the page needs a font of the machine", SCRIPT + "stage.js",
          "const controls = element(",
          'document.body.append(element("select", {}, element("option", {}, "1")));\n  const controls = element(',
          "compressor", ("tests/page/drawings/test_measured_on_paper.py",)),
    Fault("a click works out position 0 in place of that of the note", LIVING + "told.py",
          "return at.index(sample) if sample in at else 0", "return 0", "compressor", TOLD),
    Fault("a click starts with the numbers of position 0", SCRIPT + "fellows.js",
          "text(of.values[place])", "text(of.values[0])", "compressor", TOLD),
    Fault("a vector without a formula of its own is told by none", SCRIPT + "fellows.js",
          'return ["_x", "_y"].map((c) => formulaOf(key + c, row)).filter(Boolean);', "return [];", "compressor", TOLD),
    Fault("a star in the name of a number stands for a dot", "tmm_report/quantity/ways.py",
          'if "." not in before and name.startswith(part, at):', "if name.startswith(part, at):", "compressor",
          ("tests/quantity/test_fitting_names.py",)),
    Fault("each frame measures and paints the whole page", SCRIPT + "living.css",
          ".living main > * { position: relative; }", "", "compressor", PACE),
    Fault("figures have no names but their own", "tmm_report/figures/drawing.py",
          "title = drawing.title or title", "title = drawing.title", "crank_rocker",
          ("tests/page/drawings/test_titles.py",)),
)  # fmt: skip
