"""The course project: its chapters in the order of the note, what each is given, what it finds, how it is solved.

A chapter is a field of what is given, a field of what is found and a line of `solve`, all checked by types. All else of
it (block, quantities, view) stands in its folder and is found by the name of its field when asked for: see `room`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, fields, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.lever.friction.given import Friction
from tmm_report.chapters.lever.kinematics.given import Positions, Way
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.methods.given import Comparison
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.chapters.lever.press.given import Press
from tmm_report.chapters.lever.readings.given import Readings
from tmm_report.chapters.title.given import Assignment, Note, Title
from tmm_report.chapters.title.pieces import DEPTHS as DEPTHS
from tmm_report.chapters.title.pieces import Depth as Depth
from tmm_report.languages import DEFAULT, DecimalSign
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.profiles import Profile
from tmm_report.records import dataclass
from tmm_report.wording.terms import Rewording
from tmm_report.yamlread import Document

if TYPE_CHECKING:
    from tmm_report.chapters.cams.cam import solve as cam
    from tmm_report.chapters.cams.cam_forces import solve as cam_forces
    from tmm_report.chapters.find import solve as find
    from tmm_report.chapters.gears.drive import solve as drive
    from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric
    from tmm_report.chapters.gears.train.solve import train
    from tmm_report.chapters.lever.cams import solve as cams
    from tmm_report.chapters.lever.force_plans import solve as force_plans
    from tmm_report.chapters.lever.friction import solve as friction
    from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
    from tmm_report.chapters.lever.kinetostatics.solve import positions as kinetostatics
    from tmm_report.chapters.lever.methods import solve as methods
    from tmm_report.chapters.lever.moving import Moving
    from tmm_report.chapters.lever.plans import solve as plans
    from tmm_report.chapters.lever.press import solve as press
    from tmm_report.chapters.lever.readings import solve as readings
    from tmm_report.chapters.lever.reduction import solve as reduction
    from tmm_report.chapters.lever.structure import solve as structure
    from tmm_report.chapters.lever.synthesis import solve as synthesis
    from tmm_report.chapters.lever.translation import solve as translation
    from tmm_report.chapters.lever.transmission import solve as transmission
    from tmm_report.chapters.machine.balancing.solve import whole as balancing
    from tmm_report.chapters.machine.contacts import solve as contacts
    from tmm_report.chapters.machine.dynamics import solve as dynamics
    from tmm_report.chapters.machine.efficiency import solve as efficiency
    from tmm_report.chapters.machine.engine import solve as engine
    from tmm_report.chapters.machine.flywheel import solve as flywheel
    from tmm_report.chapters.machine.governor.solve import whole as governor
    from tmm_report.chapters.machine.harmonics import solve as harmonics
    from tmm_report.chapters.machine.rotor import solve as rotor
    from tmm_report.chapters.machine.travel import solve as travel
    from tmm_report.chapters.machine.vibration import solve as vibration
    from tmm_report.chapters.machine.wear import solve as wear


class Late:
    """A chapter's solve, loaded only for a variant that asks something of it."""

    def __init__(self, module: str):
        self.module = f"tmm_report.chapters.{module}"

    def __getattr__(self, name: str) -> Any:
        return getattr(import_module(self.module), name)


if not TYPE_CHECKING:
    find = Late("find.solve")
    synthesis = Late("lever.synthesis.solve")
    structure = Late("lever.structure.solve")
    kinematics = Late("lever.kinematics.solve.positions")
    cams = Late("lever.cams.solve")
    plans = Late("lever.plans.solve")
    kinetostatics = Late("lever.kinetostatics.solve.positions")
    force_plans = Late("lever.force_plans.solve")
    friction = Late("lever.friction.solve")
    reduction = Late("lever.reduction.solve")
    translation = Late("lever.translation.solve")
    transmission = Late("lever.transmission.solve")
    press = Late("lever.press.solve")
    readings = Late("lever.readings.solve")
    methods = Late("lever.methods.solve")
    dynamics = Late("machine.dynamics.solve")
    travel = Late("machine.travel.solve")
    flywheel = Late("machine.flywheel.solve")
    governor = Late("machine.governor.solve.whole")
    balancing = Late("machine.balancing.solve.whole")
    rotor = Late("machine.rotor.solve")
    engine = Late("machine.engine.solve")
    harmonics = Late("machine.harmonics.solve")
    vibration = Late("machine.vibration.solve")
    contacts = Late("machine.contacts.solve")
    efficiency = Late("machine.efficiency.solve")
    wear = Late("machine.wear.solve")
    cam = Late("cams.cam.solve")
    cam_forces = Late("cams.cam_forces.solve")
    train = Late("gears.train.solve.train")
    drive = Late("gears.drive.solve")
    eccentric = Late("gears.eccentric.solve.mechanism")


@dataclass(frozen=True, eq=False)
class LeverGiven:
    """What is given of a lever mechanism, by the keys of the file, SI. A chapter whose block is None is not solved."""

    mechanism: Mechanism
    positions: Positions = field(default_factory=Positions)
    allow_partial: bool = False  # a mechanism that exists over part of the cycle only is meant so
    drawing: Drawing = field(default_factory=Drawing)
    readings: Readings = field(default_factory=dict)
    loads: Loads | None = None
    friction: Friction | None = None
    reduction: bool = False
    translation: str | None = None  # reduction to a link that slides, "" to the stroke of what drives
    transmission: float | None = None  # the least permitted angle, rad
    press: Press | None = None
    way: Way | None = None
    methods: Comparison | None = None
    accuracy: float | None = None  # relative: what the numbers are to hold


@dataclass(frozen=True, eq=False)
class Variant:
    """Everything a variant states, checked, in SI: a lever mechanism, gears, or several of them."""

    lever: LeverGiven | None = None
    find: find.Given | None = None
    synthesis: synthesis.Given | None = None
    dynamics: dynamics.Given | None = None
    travel: travel.Given | None = None
    flywheel: flywheel.Given | None = None
    governor: governor.Given | None = None
    balancing: balancing.Given | None = None
    rotor: rotor.Given | None = None
    engine: engine.Given | None = None
    harmonics: harmonics.Given | None = None
    vibration: vibration.Given | None = None
    contacts: contacts.Given | None = None
    efficiency: efficiency.Given | None = None
    wear: wear.Given | None = None
    cam: cam.Given | None = None
    cam_forces: cam_forces.Given | None = None
    train: train.Given | None = None
    drive: drive.Given | None = None
    eccentric: eccentric.Given | None = None
    title: Title = field(default_factory=Title)
    assignment: Assignment | None = None  # its sheet behind the title page
    template: tuple[bytes, str] | None = None  # the department's own, and its file
    note: Note = field(default_factory=Note)
    profile: Profile | None = None  # how the note looks on paper; None: as the standard has it
    language: str = DEFAULT  # a code of the table of languages
    decimal_sign: DecimalSign = "comma"
    words: Rewording | None = None  # the department's own, in place of the language's
    places: Mapping[tuple[str | int, ...], tuple[int, int]] = field(default_factory=dict, repr=False)
    """Where each key of the file stands: path -> (line, column), for mistakes found only in solving."""
    file: str = ""
    doubts: tuple[Problem, ...] = ()
    """What looks odd in the file, with its places."""
    document: Document | None = field(default=None, repr=False)
    """What the file states, as it was read."""

    def __repr__(self) -> str:
        name = " ".join(str(self.title.topic or self.file).split())
        stated = [one for one in ("lever", *OTHERS) if getattr(self, one) is not None]
        return f"<Variant {name!r}: {', '.join(stated)}>"


@dataclass(frozen=True, eq=False)
class LeverFound:
    """What is found of a lever mechanism, by chapters. A chapter that the variant does not ask for is None."""

    given: LeverGiven
    structure: structure.Structure
    kinematics: kinematics.Kinematics
    cams: cams.Cams | None
    plans: plans.Plans
    kinetostatics: kinetostatics.Kinetostatics | None = None
    force_plans: force_plans.ForcePlans | None = None
    friction: friction.FrictionFound | None = None
    reduction: reduction.Reduction | None = None
    translation: translation.Found | None = None
    transmission: transmission.Found | None = None
    press: press.Found | None = None
    readings: readings.ReadingsFound | None = None
    methods: methods.Found | None = None
    sprung: tuple[tuple[str, complex], ...] = ()  # of springs of dynamics, to be drawn: point, fixed place, m

    @property
    def sample(self) -> int:
        """The position of which formulas are written out: of the force plan, else of the plans, else a regular one."""
        forces = self.force_plans.drawn if self.force_plans is not None else ()
        if drawn := forces or self.plans.drawn:
            return drawn[0].position
        lost = (*self.kinematics.singular, *self.kinematics.missing)
        return next((k for k in range(len(self.kinematics.turned)) if k not in lost), 0)

    @property
    def partial(self) -> bool:
        """Whether the mechanism closes over part of the cycle only and the variant does not mean it so."""
        return bool(self.kinematics.gaps) and not self.given.allow_partial


@dataclass(frozen=True, eq=False)
class Results:
    """Everything found, in the order of the note. What the variant does not ask for is None."""

    variant: Variant
    lever: LeverFound | None = None
    find: find.Found | find.Both | None = None
    synthesis: synthesis.Found | None = None
    dynamics: dynamics.Found | None = None
    travel: travel.Found | None = None
    flywheel: flywheel.Found | None = None
    governor: governor.Found | None = None
    balancing: balancing.Found | None = None
    rotor: rotor.Found | None = None
    engine: engine.Found | None = None
    harmonics: harmonics.Found | None = None
    vibration: vibration.Found | None = None
    contacts: contacts.Found | None = None
    efficiency: efficiency.Found | None = None
    wear: wear.Found | None = None
    cam: cam.Found | None = None
    cam_forces: cam_forces.Found | None = None
    train: train.Found | None = None
    drive: drive.Found | None = None
    eccentric: eccentric.Found | None = None


@dataclass(frozen=True, eq=False)
class Moved:
    """What is found of a lever mechanism that was solved together with others of its kind (see `stack`)."""

    structure: structure.Structure
    kinematics: kinematics.Kinematics
    kinetostatics: kinetostatics.Kinetostatics | None


def solve(variant: Variant, moved: Moved | None = None) -> Results:
    """Solve a variant chapter by chapter, but for what is found already; what it asks backwards is left to `backwards`.
    Raises ProblemError with what cannot be solved and why, of all parts that do not depend on one another."""
    try:
        return _solved(variant, moved)
    except ProblemError as error:
        others = (problem for problem in gears_unsolvable(variant) if problem not in error.problems)
        raise ProblemError([*error.problems, *others]) from None


def gears_unsolvable(variant: Variant) -> Iterator[Problem]:
    """What cannot be solved of gears, whatever becomes of the other chapters."""
    yield from _unsolvable(variant.train, lambda given: train.solve(given))
    yield from _unsolvable(variant.drive, lambda given: drive.solve(given))
    yield from _unsolvable(variant.eccentric, lambda given: eccentric.solve(given))


def lever_unsolvable(given: LeverGiven) -> list[Problem]:
    """What cannot be solved of the structure and the motion of a lever mechanism."""
    return _unsolvable(given, lambda one: kinematics.solve(one.positions, structure.solve(one.mechanism)))


def _unsolvable(given: Any, run: Callable[[Any], object]) -> list[Problem]:
    """The mistakes met in solving a part that is given."""
    try:
        if given is not None:
            run(given)
    except ProblemError as error:
        return error.problems
    return []


def _solved(variant: Variant, moved: Moved | None) -> Results:
    lever = None
    if variant.lever:
        lever = solve_lever(
            variant.lever,
            moved,
            flywheel=variant.flywheel,
            machine=variant.dynamics,
        )
    moving = _moving(lever) if lever else None
    alone = cam.solve(variant.cam) if variant.cam else None
    whole = not lever or not lever.kinematics.gaps  # what goes on over the cycle is asked of one that closes
    return Results(
        variant,
        lever=lever,
        synthesis=synthesis.solve(variant.synthesis, lever) if variant.synthesis else None,
        dynamics=dynamics.solve(variant.dynamics, moving) if variant.dynamics and whole else None,
        travel=travel.solve(variant.travel, moving) if variant.travel and whole else None,
        flywheel=flywheel.solve(variant.flywheel, moving) if variant.flywheel and whole else None,
        governor=governor.solve(variant.governor, moving) if variant.governor else None,
        balancing=balancing.solve(variant.balancing, moving) if variant.balancing and whole else None,
        rotor=rotor.solve(variant.rotor, moving) if variant.rotor else None,
        engine=engine.solve(variant.engine, moving) if variant.engine else None,
        harmonics=harmonics.solve(variant.harmonics, moving) if variant.harmonics and whole else None,
        vibration=vibration.solve(variant.vibration, moving) if variant.vibration and whole else None,
        contacts=contacts.solve(variant.contacts, moving) if variant.contacts else None,
        efficiency=efficiency.solve(variant.efficiency, moving) if variant.efficiency else None,
        wear=wear.solve(variant.wear, moving) if variant.wear and whole else None,
        cam=alone,
        cam_forces=cam_forces.solve(variant.cam_forces, alone) if variant.cam_forces and alone else None,
        train=train.solve(variant.train) if variant.train else None,
        drive=drive.solve(variant.drive, moving) if variant.drive else None,
        eccentric=eccentric.solve(variant.eccentric) if variant.eccentric else None,
    )


def _moving(lever: LeverFound, rubs: bool = True) -> Moving:
    """`rubs`: whether the friction of the pairs is in it, where it is stated."""
    from tmm_report.chapters.lever.moving import Moving  # only a lever mechanism needs it

    return Moving(
        lever.kinematics,
        lever.kinetostatics,
        friction=lever.friction if rubs else None,
    )


def solve_lever(
    given: LeverGiven, moved: Moved | None = None, flywheel: Any = None, machine: Any = None
) -> LeverFound:
    """The chapters of a lever mechanism. `flywheel`: its Given, by which friction is in the machine whose positions are
    counted; `machine`: that of the machine in motion, whose springs are drawn. Raises ProblemError."""
    links = moved.structure if moved else structure.solve(given.mechanism)
    motion = moved.kinematics if moved else kinematics.solve(given.positions, links, given.way)
    drawn = plans.solve(given.drawing, given.positions.plans, motion)
    forces = kinetostatics.solve(given.loads, motion) if given.loads and not moved else None
    forces = moved.kinetostatics if moved else forces
    found = LeverFound(
        given,
        links,
        motion,
        cams.solve(motion) if given.mechanism.cams else None,
        drawn,
        forces,
        force_plans.solve(given.drawing, given.positions.force_plan, forces, drawn) if forces else None,
        friction.solve(given.friction, forces) if given.friction and forces else None,
        reduction.solve(motion, forces, drawn) if given.reduction else None,
        translation.solve(given.translation, motion, forces) if given.translation is not None else None,
        transmission.solve(motion, given.transmission) if given.transmission else None,
        press.solve(motion, given.press) if given.press else None,
        sprung=machine.held if machine else (),
    )
    if given.methods:
        moving = _moving(found, flywheel is None or flywheel.friction)
        found = replace(found, methods=methods.solve(given.methods, moving))
    return replace(found, readings=_readings(found)) if given.readings else found


def _readings(found: LeverFound) -> readings.ReadingsFound:
    """A student may have read any number of the chapters before; structure has no table by positions."""
    known = ((name, one) for name in LEVER[1:] if (one := getattr(found, name)) is not None)
    tables = ((name, table) for name, one in known for table in room(name, "quantities").tables(one))
    return readings.solve(found.given.readings, found.plans, tables)


# ---------------------------------------------------------------- the chapters by name

INITIAL_DATA = "initial_data"  # what a lever mechanism is given, at the head of its chapters
LEVER = tuple(record.name for record in fields(LeverFound) if record.name not in ("given", "sprung"))
OTHERS = tuple(record.name for record in fields(Results) if record.name not in ("variant", "lever"))
BESIDE = (*OTHERS, "profile")  # keys of blocks that most files do without, named as their chapters are
BEFORE = ("find", "synthesis")  # what stands in the note before the lever mechanism, of the others
GEARS = ("spur", "planetary", "ordinary", "train", "drive", "eccentric")  # three kinds of stages first


def chapters(results: Results) -> Iterator[tuple[str, Any]]:
    """Name and Found of every chapter that was solved, in the order of the note."""
    after = tuple(name for name in OTHERS if name not in BEFORE)
    for names, record in ((BEFORE, results), (LEVER, results.lever), (after, results)):
        found = ((name, getattr(record, name)) for name in names if record is not None)
        yield from ((name, one) for name, one in found if one is not None)


def with_data(results: Results) -> Iterator[tuple[str, Any]]:
    """The same after the initial data of a lever mechanism: all that has numbers."""
    if results.lever is not None:
        yield INITIAL_DATA, results.lever
    yield from chapters(results)


def summary(results: Results) -> Iterator[Message]:
    """The main numbers of the chapters beside the lever's, in sentences; what was left out."""
    if asked := left_out(results):
        text = N_("left out, as the mechanism does not close over the whole cycle: %(blocks)s")
        yield Message(text, {"blocks": ", ".join(asked)})
    yield from (line for name, found in chapters(results) if name in OTHERS for line in found.summary())


def doubts(results: Results) -> list[Problem]:
    """What looks odd and was solved all the same: in the file, and in what chapters found (of those that have it)."""
    of_found = (problem for _, one in chapters(results) for problem in getattr(one, "doubts", ()))
    return [*results.variant.doubts, *of_found]


def sound(results: Results) -> bool:
    """Whether the checks of every chapter beside the lever's held; most have none that can fail."""
    return all(getattr(found, "sound", True) for name, found in chapters(results) if name in OTHERS)


def left_out(results: Results) -> list[str]:
    """The blocks of the variant that were not solved: a mechanism that does not close all round has no cycle."""
    return [name for name in OTHERS if getattr(results.variant, name) and not getattr(results, name)]


def room(chapter: str, name: str) -> Any:
    """A module of a chapter's folder by its name: "block", "quantities" or "view". Loaded when it is asked for."""
    return import_module(f"tmm_report.chapters.{wing(chapter)}{chapter}.{name}")


def wing(chapter: str) -> str:
    """Which wing a chapter stands in, "lever." and so on: none for the title page."""
    if chapter in ("cam", "cam_forces"):
        return "cams."
    if chapter in (INITIAL_DATA, *BEFORE[1:], *LEVER):  # the first, find, is of no wing: it asks all of them
        return "lever."
    return "gears." if chapter in GEARS else "machine." if chapter in OTHERS[1:] else ""


_LEVER = N_("Kinetostatic analysis")
_DRIVE = N_("Synthesis of the gear drive")
SECTIONS = {  # what the note calls them, by chapter
    "find": N_("A question asked backwards"),
    "synthesis": N_("Synthesis of the linkage"),
    "initial_data": N_("Initial data"),
    "structure": N_("Structural analysis"),
    "kinematics": N_("Kinematic analysis by the analytical method"),
    "plans": N_("Kinematic analysis by the graphical method"),
    "kinetostatics": _LEVER,
    "force_plans": _LEVER,
    "friction": N_("Friction losses and efficiency"),
    "reduction": N_("Reduction of masses and forces"),
    "translation": N_("Reduction to a link that slides"),
    "transmission": N_("Transmission angles"),
    "press": N_("The press"),
    "methods": N_("Choice of method"),
    "dynamics": N_("The machine in motion"),
    "travel": N_("Motion of the main link along its guide"),
    "flywheel": N_("The flywheel"),
    "governor": N_("Speed governor"),
    "balancing": N_("Balancing of the mechanism on its foundation"),
    "rotor": N_("Balancing of the rotor"),
    "engine": N_("Balance of the engine"),
    "harmonics": N_("Harmonics of the motion"),
    "vibration": N_("Vibration and its isolation"),
    "contacts": N_("Friction in single pairs"),
    "cams": N_("Cam pair"),
    "cam": N_("Cam mechanism"),
    "cam_forces": N_("Forces of the cam mechanism"),
    "efficiency": N_("Efficiency of machines joined"),
    "wear": N_("Wear"),
    "train": N_("Gear train"),
    "drive": _DRIVE,
    "spur": _DRIVE,
    "planetary": _DRIVE,
    "eccentric": N_("Eccentric epicyclic mechanism"),
}
