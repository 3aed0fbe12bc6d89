"""Results of the eccentric epicyclic mechanism: the family, the satellites, the proof of the teeth, single numbers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.eccentric import CARRIER, RING, SUN, WHEELS, Found
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value


def tables(found: Found, prefix: str) -> Iterator[Table]:
    yield _family(found, f"{prefix}_family")
    yield _satellites(found, f"{prefix}_satellites")
    yield _conditions(found, f"{prefix}_conditions")
    yield _proof(found, f"{prefix}_teeth")
    if found.given.speed is not None:
        yield _speeds(found, f"{prefix}_speeds")


def _family(found: Found, name: str) -> Table:
    judged = found.judged
    z = judged.family.satellites
    text = N_("number of teeth of wheel %(wheel)s")
    columns = [
        Column("t", "", Message(N_("number of the set")), judged.family.t),
        Column("z1", "", Message(text, {"wheel": SUN}), judged.family.sun),
        Column("z2", "", Message(text, {"wheel": "2"}), z[:, 0]),
        Column("z3", "", Message(text, {"wheel": RING}), judged.family.ring),
        Column("z4", "", Message(text, {"wheel": "4"}), z[:, 1]),
        Column("z5", "", Message(text, {"wheel": "5"}), z[:, 2]),
        Column(
            "residue_4",
            "",
            Message(N_("residue of assembly of the middle satellite, pitches")),
            judged.residue[:, 1],
        ),
    ]
    gap = N_("free distance between the tip circles of satellites %(pair)s")
    for key, pair, values in (
        ("gap_2_4", "2–4", judged.gap[:, 0, 1]),
        ("gap_4_5", "4–5", judged.gap[:, 1, 2]),
    ):
        columns.append(Column(key, "m", Message(gap, {"pair": pair}), values))
    held = [", ".join(w for w, fits in zip(WHEELS.values(), row, strict=True) if fits) for row in judged.fit]
    columns.append(Column("satellites", "", Message(N_("satellites that go together")), held))
    return Table(name, Message(N_("Sets of teeth of the family")), tuple(columns))


def _satellites(found: Found, name: str) -> Table:
    all_ = found.satellites
    centres = np.array([s.centre for s in all_])
    columns = (
        Column("wheel", "", Message(N_("number of the wheel")), [s.wheel for s in all_]),
        Column("z", "", Message(N_("number of teeth")), [s.teeth for s in all_]),
        Column(
            "phi1", "deg", Message(N_("angle at the axis of the sun")), np.degrees([s.phi1 for s in all_])
        ),
        Column(
            "phi3", "deg", Message(N_("angle at the axis of the ring")), np.degrees([s.phi3 for s in all_])
        ),
        Column("x", "m", Message(N_("x of the centre, from the axis of the sun")), centres.real),
        Column("y", "m", Message(N_("y of the centre, from the axis of the sun")), centres.imag),
        Column("L", "", Message(N_("pitches in the closed line of assembly")), [s.belt for s in all_]),
        Column("residue", "", Message(N_("residue of assembly, pitches")), [s.residue for s in all_]),
    )
    return Table(name, Message(N_("Positions of the satellites")), columns)


def _conditions(found: Found, name: str) -> Table:
    """Lengths in m; the rest are pure numbers."""
    rows = found.conditions
    columns = (
        Column("condition", "", Message(N_("condition")), [c.key for c in rows]),
        Column("wheels", "", Message(N_("wheels concerned")), [c.wheel for c in rows]),
        Column("value", "", Message(N_("value, SI")), [float(c.value) for c in rows]),
        Column("limit", "", Message(N_("limit, SI")), [float(c.limit) for c in rows]),
        Column(
            "in_hand",
            "",
            Message(N_("in hand, SI; negative where the condition fails")),
            [float(c.margin) for c in rows],
        ),
    )
    return Table(name, Message(N_("Conditions of the mechanism")), columns)


def _proof(found: Found, name: str) -> Table:
    proof = found.proof
    columns = (
        Column(
            "wheels", "", Message(N_("wheels concerned")), [f"{one}–{other}" for one, other in proof.meshes]
        ),
        Column(
            "overlap",
            "m²",
            Message(N_("largest overlap of the teeth over a pitch")),
            proof.overlap.max(axis=1),
        ),
        Column(
            "clearance",
            "m",
            Message(N_("least clearance of the teeth over a pitch")),
            proof.clearance.min(axis=1),
        ),
    )
    return Table(name, Message(N_("Overlap and clearance of the teeth over a full pitch")), columns)


def _speeds(found: Found, name: str) -> Table:
    cases = [(CARRIER, SUN), (RING, SUN), (SUN, RING)]
    speeds = [found.speeds(stopped, driven) for stopped, driven in cases]
    text = N_("angular velocity of member %(name)s")
    columns = [Column("stopped", "", Message(N_("member stopped")), [stopped for stopped, _ in cases])]
    columns += [
        Column(f"omega_{key}", "rad/s", Message(text, {"name": key}), [case[key] for case in speeds])
        for key in speeds[0]
    ]
    return Table(name, Message(N_("Angular velocities of the members")), tuple(columns))


def values(found: Found, prefix: str) -> Iterator[Value]:
    judged, row = found.judged, found.row
    text = N_("free distance between the tip circles of satellites %(pair)s")
    yield Value(f"{prefix}_u", found.ratio, "", Message(N_("ratio of sun and ring with the axes stopped")))
    yield Value(f"{prefix}_e", found.e, "m", Message(N_("eccentricity")))
    yield Value(f"{prefix}_t", found.t, "", Message(N_("number of the set")))
    yield Value(
        f"{prefix}_z1", found.sun, "", Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": SUN})
    )
    yield Value(
        f"{prefix}_z3", found.ring, "", Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": RING})
    )
    yield Value(f"{prefix}_satellites", len(found.satellites), "", Message(N_("number of satellites")))
    yield Value(f"{prefix}_gap_2_4", float(judged.closed[row]), "m", Message(text, {"pair": "2–4"}))
    overlap, clearance = float(found.proof.overlap.max()), float(found.proof.clearance.min())
    yield Value(f"{prefix}_overlap", overlap, "m²", Message(N_("largest overlap of the teeth over a pitch")))
    yield Value(
        f"{prefix}_clearance", clearance, "m", Message(N_("least clearance of the teeth over a pitch"))
    )
