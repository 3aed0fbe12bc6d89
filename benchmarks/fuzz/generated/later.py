"""What the format takes besides, drawn after all else and by draws of its own, so that what was drawn before stays:
points by a distance and an angle, strokes that are run up and down, upright rails, a main link that slides, a cam,
compound gear trains."""

from __future__ import annotations

from random import Random
from typing import Any

from benchmarks.fuzz.generated.gears import compound
from benchmarks.fuzz.generated.levers import cam_alone

Data = dict[str, Any]
UPRIGHT = {"above": "left", "below": "right", "right": "up", "left": "down"}


def later(data: Data, random: Random) -> None:
    mechanism = data.get("mechanism", {})
    for name, link in mechanism.get("links", {}).items():
        _corner(name, link, random)
    stroke = mechanism.get("driver", {}).get("stroke", {})
    if set(stroke) == {"from", "speed", "time"}:
        for key in ("run_up", "run_down"):
            if random.random() < 0.4:
                stroke[key] = f"{random.uniform(0.02, 0.2):.3g} s"
    if "rolling" in mechanism and random.random() < 0.5:
        _upright(mechanism, random)
    if not mechanism and not data.get("find") and random.random() < 0.05:
        data["travel"] = _travel(random)
    if not data.get("find") and random.random() < 0.08:
        data["cam"] = cam_alone(random)
        if "speed" in data.get("drive", {}) and random.random() < 0.5:
            data["cam"]["speed"] = "drive"
            data["cam"].pop("rotation", None)
    if not data.get("find") and random.random() < 0.05:
        data["train"] = compound(random)


def _corner(name: str, link: Data, random: Random) -> None:
    """The mass centre of a link of stated points."""
    points, centre = link.get("points"), f"S{name}"
    if not isinstance(points, dict) or not isinstance(points.get(centre), dict) or random.random() < 0.5:
        return
    first, second = list(points)[:2]
    found: Data = {"distance": f"{random.randint(20, 90)} mm", "angle": f"{random.randint(-180, 180)} deg"}
    if random.random() < 0.5:
        found["about"] = second
    if random.random() < 0.5:
        found["to"] = first if found.get("about") else second
    points[centre] = found


def _upright(mechanism: Data, random: Random) -> None:
    """A slider-crank on a wheel, turned by a right angle, where it stands as it was made."""
    guide, wheel = mechanism["guides"].get("x"), mechanism["rolling"][0]
    if guide != {"through": "O"} or mechanism.get("assembly", {}).get("B") not in UPRIGHT:
        return
    guide["angle"] = "90 deg"
    mechanism["assembly"]["B"] = UPRIGHT[mechanism["assembly"]["B"]]
    wheel["side"] = UPRIGHT[wheel["side"]]
    if random.random() < 0.6:
        wheel["phase"] = f"{random.randint(-180, 180)} deg"


def _travel(random: Random) -> Data:
    """A piston, a hammer or a ram alone."""

    def force(size: float) -> Data:
        values = (f"{random.uniform(0.3, 1) * size:.4g} N" for _ in range(2))
        one, other = values
        laws: tuple[Data, ...] = (
            {"constant": one},
            {"by_place": [["0 mm", one], ["300 mm", one], ["300 mm", other], ["2 m", other]]},
            {"by_time": [["0 s", one], ["0.4 s", other], ["90 s", other]]},
            {"by_speed": [["0 m/s", one], ["2 m/s", other], ["90 m/s", other]]},
            {"viscous": f"{random.uniform(5, 60):.3g} N*s/m"},
            {"square": {"force": one, "speed": f"{random.uniform(2, 6):.3g} m/s"}},
        )
        named = (
            {
                "name": random.choice(
                    ("steam", {"ru": "сила пара", "uk": "сила пари", "kk": "бу күші", "en": "steam"})
                )
            }
            if random.random() < 0.4
            else {}
        )
        return random.choice(laws) | named

    found: Data = {"mass": f"{random.uniform(20, 300):.4g} kg", "to": "1.2 m", "driving": [force(4000)]}
    choices: Data = {
        "name": ("hammer", {"ru": "молот", "uk": "молот", "kk": "балға", "en": "hammer"})[
            len(found["mass"]) % 2
        ],
        "from": f"{random.randint(0, 400)} mm",
        "speed": f"{random.uniform(0.1, 2):.3g} m/s",
        "rise": f"{random.choice((-90, -30, 0, 20))} deg",
        "gravity": "9.81 m/s^2",
        "resistance": [force(300)],
        "springs": [
            {
                "name": ("buffer", {"en": "buffer", "ru": "буфер", "uk": "буфер", "kk": "буфер"})[
                    len(found["mass"]) % 2
                ],
                "stiffness": f"{random.uniform(50, 900):.3g} N/m",
                "free": "400 mm",
            }
        ],
        "wheels": [
            {
                "name": ("wheel", {"en": "wheel", "ru": "колесо", "uk": "колесо", "kk": "дөңгелек"})[
                    len(found["mass"]) % 2
                ],
                "inertia": "0.4 kg*m^2",
                "radius": "150 mm",
            }
        ],
    }
    return found | {key: value for key, value in choices.items() if random.random() < 0.4}
