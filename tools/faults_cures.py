"""Wrong answers to what a variant states and to how it is written, to be planted."""

from __future__ import annotations

from faults import STATICS, Fault

CURES = ("tests/variant/test_cures_of_slips.py",)
UNUSUAL = ("tests/variant/test_unusual_but_right.py",)
FOLLOWED = ("tests/mechanics/lever/high_class/test_branch.py",)

FAULTS = (
    # --- loads and points ---
    Fault(
        "a force goes to another link than the stated one",
        STATICS + "solve/acting_forces.py",
        "    if force.on is not None:\n        return force.on\n",
        "",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    Fault(
        "results name the point in place of the link that takes a force",
        STATICS + "quantities/positions.py",
        "f.at, loaded_link(motion, f), _way(f.way)",
        "f.at, f.at, _way(f.way)",
    ),
    Fault(
        "with a range the last value by position holds on",
        STATICS + "block/checks.py",
        "count = steps if closed else steps + 1",
        "count = steps",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    Fault(
        "pressures by position are taken as forces",
        "tmm_report/mechanics/calculus/laws.py",
        "return tuple(value * factor for value in values)",
        "return values",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    Fault(
        "a constant pressure is taken as a force",
        "tmm_report/mechanics/calculus/laws.py",
        "amount=self.amount * factor",
        "amount=self.amount",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    Fault(
        "lengths between points at one place are listed",
        "tmm_report/chapters/lever/initial_data/quantities/__init__.py",
        "for segment, size in found if size > 0]",
        "for segment, size in found]",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    Fault(
        "masses without loads are passed over",
        STATICS + "block/doubts.py",
        "        if heavy and not _weighed(read):\n",
        "        if not heavy:\n",
        tests=("tests/chapters/lever/test_stated_in_vain.py",),
    ),
    Fault(
        "friction without loads is passed over",
        "tmm_report/chapters/lever/friction/block.py",
        'if "loads" not in read.data:',
        'if "loads" in read.data:',
        tests=("tests/chapters/lever/test_stated_in_vain.py",),
    ),
    Fault(
        "the arm that gives the scale is a point at the pivot",
        "tmm_report/chapters/lever/initial_data/quantities/__init__.py",
        "if abs(points[p] - points[pivot]) > 0)",
        "if p != pivot)",
        tests=("tests/chapters/lever/kinetostatics/test_loads_at_the_edge.py",),
    ),
    # --- messages ---
    Fault(
        "a decimal comma inside { } read as two keys",
        "tmm_report/yamlread/commas.py",
        "_REST.fullmatch(text) and _WHOLE.fullmatch(before[1])",
        "_REST.fullmatch(text) and not _WHOLE.fullmatch(before[1])",
        tests=("tests/variant/test_slips_of_yaml.py",),
    ),
    Fault(
        "an unclosed bracket told where the parser stopped",
        "tmm_report/yamlread/slips.py",
        'yield Slip(begun, Message(text, {**told, "next": broken.place[0]}), right)',
        'yield Slip(broken.place, Message(text, {**told, "next": broken.place[0]}), right)',
        tests=("tests/variant/test_slips_of_yaml.py",),
    ),
    Fault(
        "names that look alike kept apart without a word",
        "tmm_report/variant/slips/lookalike.py",
        "found[latin(word)].setdefault(word, [])",
        "found[word].setdefault(word, [])",
        tests=("tests/variant/test_lookalikes.py",),
    ),
    Fault(
        "the rarer spelling taken for the meant one",
        "tmm_report/variant/slips/lookalike.py",
        "return max(words, key=lambda",
        "return min(words, key=lambda",
        tests=("tests/variant/test_lookalikes.py",),
    ),
    Fault(
        "a word suggested in place of itself",
        "tmm_report/variant/errors.py",
        "others = [one for one in known if one != word]",
        "others = list(known)",
        tests=("tests/variant/test_lookalikes.py",),
    ),
    Fault(
        "bare metres of a whole mechanism pass",
        "tmm_report/variant/slips/odd.py",
        "LARGE, SMALL = 20.0, 5e-4",
        "LARGE, SMALL = 2000.0, 5e-4",
        tests=("tests/variant/test_odd_numbers.py",),
    ),
    Fault(
        "a length a thousand times too small passes",
        "tmm_report/variant/slips/odd.py",
        "return alike and back and ratio < 1 / 50",
        "return alike and back and ratio < 1 / 50000",
        tests=("tests/variant/test_odd_numbers.py",),
    ),
    Fault(
        "moments of inertia held against no radius",
        "tmm_report/chapters/lever/structure/block/odd.py",
        "radius = math.sqrt(inertia.size / mass.size)",
        "radius = 0.3 * longest",
        tests=("tests/variant/test_odd_numbers.py",),
    ),
    Fault(
        "mistakes of a file told in the system's language",
        "tmm_report/course.py",
        "raise ProblemError(error.problems, stated_in(text)) from None",
        "raise ProblemError(error.problems) from None",
        tests=("tests/variant/test_layers_of_mistakes.py",),
    ),
    Fault(
        "gears that cannot be hidden behind a mechanism that cannot be",
        "tmm_report/course.py",
        "    yield from _of_gears(Variant(**_given(gears, read)))",
        "    yield from ()",
        tests=("tests/variant/test_layers_of_mistakes.py",),
    ),
    Fault(
        "doubts never printed",
        "tmm_report/commands/solve.py",
        "    for problem in doubts(results):",
        "    for problem in ():",
        tests=("tests/variant/test_odd_numbers.py",),
    ),
    # --- bounds and files ---
    Fault(
        "a killed run is not taken up",
        "tmm_report/commands/whole.py",
        "    if begun.entries:\n",
        "    if False:\n",
        tests=("tests/commands/test_whole_folder.py",),
    ),
    Fault(
        "an edited note is lost",
        "tmm_report/commands/whole.py",
        'found[name] = _free(folder, f"{name}.bak")',
        "pass",
        tests=("tests/commands/test_whole_folder.py",),
    ),
    Fault(
        "a figure of the last note stays",
        "tmm_report/commands/whole.py",
        "goes = [name for name in stays if _same_kind(name, new)]",
        "goes: list[str] = []",
        tests=("tests/commands/test_whole_folder.py",),
    ),
    Fault(
        "gear conditions do not count",
        "tmm_report/commands/solve.py",
        "return good and sound(results)",
        "return good",
        tests=("tests/commands/test_exit_codes.py",),
    ),
    Fault(
        "points are not counted",
        "tmm_report/variant/sizes.py",
        "> POINTS:",
        "> 10 * POINTS:",
        tests=("tests/variant/test_sizes.py",),
    ),
    Fault(
        "a leader goes through a box",
        "tmm_report/figures/crowded.py",
        "return ~outside & (low < high)",
        "return ~outside & (low > high)",
        tests=("tests/figures/test_placing.py",),
    ),
    Fault(
        "a scale larger than paper",
        "tmm_report/quantity/paper.py",
        "low <= largest / scale <= high",
        "low <= largest / scale",
        tests=("tests/variant/test_sizes.py",),
    ),
    # --- foreign folders, long motions ---
    Fault(
        "links as the staged set",
        "tmm_report/commands/whole.py",
        "return not staged.is_symlink() and not any(",
        "return not any(",
        tests=("tests/commands/test_foreign_folders.py",),
    ),
    Fault(
        "links within the staged set",
        "tmm_report/commands/whole.py",
        ' and not any(path.is_symlink() for path in staged.rglob("*"))',
        "",
        tests=("tests/commands/test_foreign_folders.py",),
    ),
    Fault(
        "figures that are a link",
        "tmm_report/commands/whole.py",
        "(parent.is_symlink() or not parent.is_dir())",
        "not parent.is_dir()",
        tests=("tests/commands/test_foreign_folders.py",),
    ),
    Fault(
        "a run that goes on is not waited for",
        "tmm_report/commands/whole.py",
        "                if not left:\n                    raise\n",
        "                if not left:\n                    break\n",
        tests=("tests/commands/test_foreign_folders.py",),
    ),
    Fault(
        "a motion is followed without end",
        "tmm_report/mechanics/machine/run/by_time.py",
        "range(min(TURNS, FOLLOWED // plant.panels.x.size))",
        "range(TURNS)",
        tests=("tests/variant/test_sizes.py",),
    ),
    # --- cures ---
    Fault(
        "every block asked for where there is no mechanism",
        "tmm_report/variant/reading.py",
        "and not _without_mechanism(data, rooms)",
        "",
        tests=CURES,
    ),
    Fault(
        "light links of small mechanisms warned about",
        "tmm_report/chapters/lever/structure/block/odd.py",
        "min(THIN * found.longest, WIRE * cube)",
        "THIN * found.longest",
        tests=UNUSUAL,
    ),
    Fault(
        "low pressures warned about",
        "tmm_report/variant/slips/odd.py",
        "Limit(50.0, 5e8",
        "Limit(1e3, 5e8",
        tests=UNUSUAL,
    ),
    Fault(
        "points that 0 and O tell apart read as two",
        "tmm_report/variant/slips/lookalike.py",
        "keys |= dict.fromkeys(places, meant)",
        "pass",
        tests=CURES,
    ),
)
