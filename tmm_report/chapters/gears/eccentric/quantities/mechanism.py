"""Every number of the eccentric epicyclic mechanism with its symbol, unit and meaning."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.gears.eccentric.quantities.further import further_tables
from tmm_report.chapters.gears.eccentric.solve.mechanism import WHEELS, Found
from tmm_report.chapters.gears.eccentric.steps import steps
from tmm_report.chapters.gears.eccentric.values import Members, Mesh, Pair, Set
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.sheet import columns
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("eccentric_u_teeth", "eccentric_e")  # what is looked for first

NUMBER_OF_WHEEL = Message(N_("number of the wheel"))
CONCERNED = Message(N_("wheels concerned"))


@tabulated
def values(found: Found) -> Iterator[Value]:
    """The single numbers; behind them those of each path."""
    made = steps(found)
    yield from made.s.values()
    for path in made.paths:
        yield from path.s.values()


@tabulated
def tables(found: Found) -> Iterator[Table]:
    parts = {
        "family": (N_("Sets of teeth of the family"), _family),
        "satellites": (N_("Positions of the planet gears"), _satellites),
        "conditions": (N_("Conditions of the mechanism"), _conditions),
        "teeth": (N_("Overlap and clearance of the teeth over a full pitch"), _proof),
        "wheels": (N_("Dimensions of the wheels"), _wheels),
        "neighbours": (N_("Planet gears that stand side by side"), _neighbours),
    }
    if found.given.speed is not None:
        parts["speeds"] = (N_("Angular velocities of the members"), _speeds)
    for key, (meaning, made) in parts.items():
        yield Table(f"eccentric_{key}", Message(meaning), tuple(made(found)))
    yield from further_tables(found)


# --- the family


def _family(found: Found) -> Iterator[Column]:
    judged, family = found.judged, found.judged.family
    z = family.satellites
    yield Set.t.column(family.t)
    yield Set.z1.column(family.sun)
    yield Set.z2.column(z[:, 0])
    yield Set.z3.column(family.ring)
    yield Set.z4.column(z[:, 1])
    yield Set.z5.column(z[:, 2])
    yield Set.residue_4.column(judged.residue[:, 1])
    yield Set.gap_2_4.column(judged.gap[:, 0, 1])
    yield Set.gap_4_5.column(judged.gap[:, 1, 2])
    yield Set.closed_2_4.column(judged.closed)
    held = [", ".join(w for w, fits in zip(WHEELS.values(), row, strict=True) if fits) for row in judged.fit]
    yield text_column("satellites", Message(N_("planet gears that go together")), held)


# --- the satellites of the chosen set


def _satellites(found: Found) -> Iterator[Column]:
    yield text_column("wheel", NUMBER_OF_WHEEL, [s.wheel for s in found.satellites])
    *others, least = columns(steps(found).satellites)
    yield from others
    yield replace(
        least, symbols=[least.symbol()] * len(found.satellites)
    )  # of the ring, whatever the satellite


def _neighbours(found: Found) -> Iterator[Column]:
    """Each pair once, without its mirror image."""
    yield text_column("wheels", CONCERNED, [pair.wheels for pair in found.near])
    pairs = steps(found).pairs
    yield from columns(pairs) if pairs else (of.column([]) for of in Pair.DECLARED.values())


# --- dimensions, conditions, proof, speeds


def _wheels(found: Found) -> Iterator[Column]:
    wheels = steps(found).wheels
    yield text_column("wheel", NUMBER_OF_WHEEL, [str(wheel.index) for wheel in wheels])
    yield from columns(wheels)


def _conditions(found: Found) -> Iterator[Column]:
    """Lengths in m; the rest are pure numbers."""
    rows = found.conditions
    units = ["m" if c.unit == "mm" else c.unit for c in rows]
    yield text_column("condition", Message(N_("condition")), [c.key for c in rows])
    yield text_column("wheels", CONCERNED, [c.wheel for c in rows])
    yield text_column("unit", Message(N_("unit of the numbers in the row")), units)
    for key, text, numbers in (
        ("value", N_("value, SI"), [c.value for c in rows]),
        ("limit", N_("limit, SI"), [c.limit for c in rows]),
        ("in_hand", N_("margin, SI; negative where the condition fails"), [c.margin for c in rows]),
    ):
        quantity = Quantity(key, None, "", Message(text))
        yield Column(quantity, [float(x) for x in numbers], units=units)


def _proof(found: Found) -> Iterator[Column]:
    proof = found.proof
    yield text_column("wheels", CONCERNED, [f"{one}–{other}" for one, other in proof.meshes])
    yield Mesh.overlap.column(proof.overlap.max(axis=1))
    yield Mesh.clearance.column(proof.clearance.min(axis=1))


def _speeds(found: Found) -> Iterator[Column]:
    motions = found.motions
    yield text_column("stopped", Message(N_("member stopped")), [motion.stopped for motion in motions])
    for name in motions[0].speed:
        yield Members.omega.of(name, name=name).column([motion.speed[name] for motion in motions])
