"""The motions of an eccentric epicyclic mechanism: the axes, the ring or the sun stopped."""

from __future__ import annotations

from tmm_report.chapters.gears.eccentric.given import CARRIER, RING, SUN
from tmm_report.chapters.gears.eccentric.solve.satellites import Satellite
from tmm_report.mechanics.gears.trains import Member, Mesh, Train, speeds
from tmm_report.records import dataclass

CASES = ((CARRIER, SUN), (RING, SUN), (SUN, RING))  # stopped and driven


@dataclass(frozen=True, eq=False)
class Motion:
    """Speeds of all the members, rad/s, with one stopped and another driven."""

    stopped: str
    driven: str
    speed: dict[str, float]


def motions(
    sun: int, ring: int, satellites: tuple[Satellite, ...], m: float, speed: float
) -> tuple[Motion, ...]:
    """For the driving wheel's speed, rad/s."""
    train = _train(sun, ring, satellites, m)
    found = ((stopped, driven, speeds(train, {stopped: 0.0, driven: speed})) for stopped, driven in CASES)
    return tuple(
        Motion(stopped, driven, {name: float(value) for name, value in of.items()})
        for stopped, driven, of in found
    )


def _train(sun: int, ring: int, satellites: tuple[Satellite, ...], m: float) -> Train:
    """Sun, ring, satellites and the body H that carries all the axes."""
    half = m / 2
    bodies = [Member(s.wheel, "satellite", s.teeth, half * s.teeth, carried_by=CARRIER) for s in satellites]
    members = (
        Member(SUN, "wheel", sun, half * sun),
        Member(RING, "ring", ring, half * ring),
        *bodies,
        Member(CARRIER, "carrier"),
    )
    meshes = [Mesh(SUN, body.name, CARRIER) for body in bodies]
    meshes += [Mesh(body.name, RING, CARRIER, internal=True) for body in bodies]
    return Train(members, tuple(meshes))
