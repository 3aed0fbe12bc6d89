"""Results of the eccentric epicyclic mechanism: the family, the satellites, the proof of the teeth, single numbers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.eccentric.solve import CARRIER, RING, SUN, WHEELS, Found
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Table, Value, plain, plain_value


def tables(found: Found, prefix: str = "eccentric") -> Iterator[Table]:
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
        plain("t", "", Message(N_("number of the set")), judged.family.t),
        plain("z1", "", Message(text, {"wheel": SUN}), judged.family.sun),
        plain("z2", "", Message(text, {"wheel": "2"}), z[:, 0]),
        plain("z3", "", Message(text, {"wheel": RING}), judged.family.ring),
        plain("z4", "", Message(text, {"wheel": "4"}), z[:, 1]),
        plain("z5", "", Message(text, {"wheel": "5"}), z[:, 2]),
        plain(
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
        columns.append(plain(key, "m", Message(gap, {"pair": pair}), values))
    held = [", ".join(w for w, fits in zip(WHEELS.values(), row, strict=True) if fits) for row in judged.fit]
    columns.append(plain("satellites", "", Message(N_("satellites that go together")), held))
    return Table(name, Message(N_("Sets of teeth of the family")), tuple(columns))


def _satellites(found: Found, name: str) -> Table:
    all_ = found.satellites
    centres = np.array([s.centre for s in all_])
    columns = (
        plain("wheel", "", Message(N_("number of the wheel")), [s.wheel for s in all_]),
        plain("z", "", Message(N_("number of teeth")), [s.teeth for s in all_]),
        plain("phi1", "deg", Message(N_("angle at the axis of the sun")), np.degrees([s.phi1 for s in all_])),
        plain(
            "phi3", "deg", Message(N_("angle at the axis of the ring")), np.degrees([s.phi3 for s in all_])
        ),
        plain("x", "m", Message(N_("x of the centre, from the axis of the sun")), centres.real),
        plain("y", "m", Message(N_("y of the centre, from the axis of the sun")), centres.imag),
        plain("L", "", Message(N_("pitches in the closed line of assembly")), [s.belt for s in all_]),
        plain("residue", "", Message(N_("residue of assembly, pitches")), [s.residue for s in all_]),
    )
    return Table(name, Message(N_("Positions of the satellites")), columns)


def _conditions(found: Found, name: str) -> Table:
    """Lengths in m; the rest are pure numbers."""
    rows = found.conditions
    columns = (
        plain("condition", "", Message(N_("condition")), [c.key for c in rows]),
        plain("wheels", "", Message(N_("wheels concerned")), [c.wheel for c in rows]),
        plain("value", "", Message(N_("value, SI")), [float(c.value) for c in rows]),
        plain("limit", "", Message(N_("limit, SI")), [float(c.limit) for c in rows]),
        plain(
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
        plain(
            "wheels", "", Message(N_("wheels concerned")), [f"{one}–{other}" for one, other in proof.meshes]
        ),
        plain(
            "overlap",
            "m²",
            Message(N_("largest overlap of the teeth over a pitch")),
            proof.overlap.max(axis=1),
        ),
        plain(
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
    columns = [plain("stopped", "", Message(N_("member stopped")), [stopped for stopped, _ in cases])]
    columns += [
        plain(f"omega_{key}", "rad/s", Message(text, {"name": key}), [case[key] for case in speeds])
        for key in speeds[0]
    ]
    return Table(name, Message(N_("Angular velocities of the members")), tuple(columns))


def values(found: Found, prefix: str = "eccentric") -> Iterator[Value]:
    judged, row = found.judged, found.row
    text = N_("free distance between the tip circles of satellites %(pair)s")
    yield plain_value(
        f"{prefix}_u", found.ratio, "", Message(N_("ratio of sun and ring with the axes stopped"))
    )
    yield plain_value(f"{prefix}_e", found.e, "m", Message(N_("eccentricity")))
    yield plain_value(f"{prefix}_t", found.t, "", Message(N_("number of the set")))
    yield plain_value(
        f"{prefix}_z1", found.sun, "", Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": SUN})
    )
    yield plain_value(
        f"{prefix}_z3", found.ring, "", Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": RING})
    )
    yield plain_value(f"{prefix}_satellites", len(found.satellites), "", Message(N_("number of satellites")))
    yield plain_value(f"{prefix}_gap_2_4", float(judged.closed[row]), "m", Message(text, {"pair": "2–4"}))
    overlap, clearance = float(found.proof.overlap.max()), float(found.proof.clearance.min())
    yield plain_value(
        f"{prefix}_overlap", overlap, "m²", Message(N_("largest overlap of the teeth over a pitch"))
    )
    yield plain_value(
        f"{prefix}_clearance", clearance, "m", Message(N_("least clearance of the teeth over a pitch"))
    )
