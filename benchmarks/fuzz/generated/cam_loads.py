"""What loads the follower of a drawn cam that stands alone."""

from __future__ import annotations

from random import Random
from typing import Any

Data = dict[str, Any]


def loaded(one: Data, swings: bool, end: str, random: Random) -> None:
    """Loads, spring and friction of a follower of the kind, seldom some of the other kind."""
    one.setdefault("speed", "150 rpm")
    if random.random() < 0.7:
        one["moment" if swings else "load"] = _load("N*m" if swings else "N", 4 if swings else 200, random)
    if random.random() < 0.75:
        one |= {"inertia": "0.004 kg*m^2"} if swings else {"mass": "1.5 kg"}
        if swings and random.random() < 0.4:
            one |= {"mass": "0.8 kg", "mass_centre": "50 mm"}
        if random.random() < 0.4:
            one["gravity"] = "9.81 m/s^2"
        if random.random() < 0.8:
            one["torsion" if swings else "spring"] = _spring(swings, random)
    if random.random() < 0.6:
        one |= _rubs(swings, end, random)
    if end != "knife" and random.random() < 0.4:
        one["contact"] = {"width": "12 mm"}
        for key in ("cam", "follower"):
            if random.random() < 0.5:
                metal = {"young": "210 GPa", **({"poisson": 0.28} if random.random() < 0.5 else {})}
                one["contact"][key] = random.choice(("steel", "cast iron", "bronze", metal))
        if random.random() < 0.5:
            one["contact"]["permitted"] = "800 MPa"
    if end == "roller" and random.random() < 0.3:
        one["closure"] = random.choice(("groove", "force"))
    if random.random() < 0.5:
        one["at"] = ["50 deg", "200 deg"]


def _load(unit: str, size: int, random: Random) -> Any:
    some, more = f"{size} {unit}", f"{2 * size} {unit}"
    return random.choice(
        (
            some,
            {"constant": some},
            {"rise": more, "return": some},
            {"by_angle": [["0 deg", some], ["90 deg", more], ["360 deg", some]]},
            {"forward": [[0, some], [0.4, more], [1, more]], "back": [[0, some], [1, some]]},
        )
    )


def _spring(swings: bool, random: Random) -> Any:
    rate, preload = ("15 N*m/rad", "3 N*m") if swings else ("4 N/mm", "60 N")
    pressed = {"turned": "12 deg"} if swings else {"compression": "12 mm"}
    found: Any = random.choice(
        (
            "smallest",
            {"rate": rate, "preload": preload},
            {"rate": rate, **pressed},
            {"rate": rate, "preload": "smallest"},
            {"rate": "smallest", "preload": preload},
            {"ratio": 0.4},
        )
    )
    if isinstance(found, dict) and random.random() < 0.4:
        found = {**found, "reserve": 1.3}
    return found


def _rubs(swings: bool, end: str, random: Random) -> Data:
    journal = {"friction": 0.08} | random.choice(({"diameter": "4 mm"}, {"radius": "2 mm"}))
    found: Data = {"pivot": journal} if swings else {
        "guide": {"length": "90 mm", "overhang": "60 mm", "friction": 0.1}
        | ({"shortens": True} if random.random() < 0.4 else {})
    }  # fmt: skip
    if end == "roller":
        found["pin"] = dict(journal)
    else:
        found["face_friction"] = 0.1
    return found
