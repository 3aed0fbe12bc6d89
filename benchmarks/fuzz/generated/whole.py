"""Whole variants: a mechanism or none, and any blocks beside it that are there together."""

from __future__ import annotations

import json
from random import Random
from typing import Any

from benchmarks.fuzz.generated.asked import backwards, tied
from benchmarks.fuzz.generated.later import later
from benchmarks.fuzz.generated.levers import mechanism
from benchmarks.fuzz.generated.walk import Names, Walk

ALONE = (
    "dynamics",
    "dynamics",
    "dynamics",
    "flywheel",
    "flywheel",
    "governor",
    "rotor",
    "engine",
    "vibration",
    "vibration",
    "contacts",
    "efficiency",
    "drive",
    "eccentric",
    "synthesis",
    "synthesis",
)
BESIDE = (
    "wear",
    "vibration",
    "dynamics",
    "dynamics",
    "flywheel",
    "flywheel",
    "balancing",
    "harmonics",
    "wear",
    "vibration",
    "synthesis",
)
UNIFORM = (
    "dynamics", "flywheel", "friction", "reduction", "harmonics", "methods", "method", "accuracy", "balancing", "wear",
    "press",
)  # fmt: skip
"""What reckons with a driving link that turns uniformly."""
MARKS = ("language", "decimal_sign", "title", "note")
PAPER = ("profile", "assignment", "words")
SLOW = {"methods": 0.05, "method": 0.25, "readings": 0.3, "drive": 0.6, "eccentric": 0.7}
"""How often what is dear, or breaks much else, is left where chance put it."""
ASKED = 0.03
"""How often a number is sought, where there is one to demand: that solves the variant a hundred times."""


def variant(seed: str) -> dict[str, Any]:
    """A variant by chance, the same of the same seed."""
    random = Random(seed)
    walk = Walk(
        random,
        Names(),
        random.choice((0.0, 0.15, 0.4, 0.4, 0.7, 1.0)),
        random.choice((0, 0, 0, 0, 0, 0, 0.02, 0.2)),
    )
    data: dict[str, Any] = {}
    beside: tuple[str, ...] = ALONE
    if random.random() < 0.5:
        data["mechanism"], walk.names = mechanism(walk)
        if "synthesis" in data["mechanism"]:
            data["synthesis"] = data["mechanism"].pop("synthesis")
            if random.random() < 0.3:
                data["synthesis"]["round"] = random.choice(("1 mm", "0.1 mm", "5 mm"))
        beside = BESIDE if random.random() < 0.9 else ALONE
        _lever(data, walk)
        blocks = random.sample(beside, random.choice((0, 0, 1, 1, 2)))
    else:
        blocks = random.sample(beside, random.choice((1, 1, 1, 2, 3)))
    for name in dict.fromkeys(blocks):
        if name not in data and random.random() < SLOW.get(name, 1):
            data[name] = walk.key(name)
    for name in MARKS:
        if random.random() < 0.4:
            data[name] = walk.key(name)
    on_paper = Walk(
        Random(f"paper {seed}"), walk.names, walk.fullness, walk.wild
    )  # draws of its own, as of the ties
    for name in PAPER:
        if on_paper.random.random() < 0.2:
            data[name] = on_paper.key(name)
    if "mechanism" in data and walk.tame():
        _agreed(data)
        tied(data, Random(f"ties {seed}"))  # draws of its own: what else is drawn does not change with them
    if (
        random.random() < 0.2
        and data.get("drive", {}).get("output") != "other"
        and "mechanism" in data
        and "drive" in data
        and "stroke" not in data["mechanism"]["driver"]
    ):
        data["mechanism"]["driver"]["speed"] = "drive"
        data["mechanism"]["driver"].pop("period", None)
    if random.random() < ASKED:
        backwards(data, random)
    later(data, Random(f"later {seed}"))
    if "friction" not in data:
        data.get("drive", {}).pop("friction", None)
    if "mechanism" not in data and walk.tame():
        data.get("flywheel", {}).pop("friction", None)
    driver = data.get("mechanism", {}).get("driver", {})
    alone = driver.get("speed") == "drive" and "drive" not in data
    if (alone or not {"speed", "period", "law", "stroke"} & set(driver)) and driver and walk.tame():
        driver["speed"] = "90 rpm"
    return data


def _lever(data: dict[str, Any], walk: Walk) -> None:
    random = walk.random
    data["positions"] = walk.part("PositionsModel")
    _positions(data["positions"], walk)
    for name in (
        "loads",
        "friction",
        "reduction",
        "drawing",
        "method",
        "accuracy",
        "methods",
        "transmission",
        "press",
        "readings",
        "allow_partial",
    ):
        share = 0.75 if name == "loads" else max(0.15, 0.6 * walk.fullness)
        if random.random() < share * SLOW.get(name, 1):
            data[name] = walk.key(name)
    if "readings" in data:
        points = walk.names.of["free"]
        data["readings"] = {
            str(k): {f"{letter}_{random.choice(points)}": "1.2"} for k, letter in ((1, "v"), (2, "a"))
        }
    force = data.get("drawing", {}).get("scales", {}).get("force")
    if isinstance(force, dict):
        data["drawing"]["scales"]["force"] = {"2-3": next(iter(force.values()))}


def _shared(loads: dict[str, Any]) -> None:
    """The curves that loads take are there, and no others."""
    curves, taken = loads.pop("curves", {}), {}
    parts = {"forward": [[0, 0.1], [1, 1]], "back": [[0, 0], [1, 1]]}
    for one in (*loads.get("forces", ()), *loads.get("moments", ())):
        diagram = one.get("by_displacement")
        if isinstance(diagram, dict) and "curve" in diagram:
            name = diagram["curve"] = next(iter(curves), "gas")
            stated = curves.get(name, {})  # one of strokes becomes one of two ways, which moments take, too
            diagram.pop("first", None)
            taken[name] = {
                way: [[0, 0.2], *stated.get(way, points)[1:-1], [1, 0.9]] for way, points in parts.items()
            }
    if taken:
        loads["curves"] = {
            name: {way: [[x, _part(y)] for x, y in points] for way, points in curve.items()}
            for name, curve in taken.items()
        }


def _part(value: Any) -> float:
    """Of the greatest value; an odd text is all of it."""
    try:
        return min(abs(float(value)), 1)
    except ValueError:
        return 1


def _agreed(data: dict[str, Any]) -> None:
    """What asks for loads has some, what asks for masses is there with masses."""
    if "loads" in data:
        _shared(data["loads"])
    if {"law", "stroke"} & set(data["mechanism"]["driver"]) and "at" in data.get("positions", {}):
        data["positions"]["at"] = ["0.05 s"] if len(data["positions"]["at"]) % 2 else ["0.02 s", "0.1 s"]
    massive = any("mass" in link for link in data["mechanism"]["links"].values())
    if "cams" in data["mechanism"]:
        for name in ("wear", "balancing"):
            data.pop(name, None)
    if {"wheels", "racks", "rolling"} & set(data["mechanism"]):
        for name in ("methods", "method"):
            data.pop(name, None)
    to = data.get("reduction")
    if isinstance(to, dict) and "slides" not in data["mechanism"]["links"].get(str(to.get("link")), {}):
        data["reduction"] = True
    if not massive:
        for name in ("reduction", "balancing"):
            data.pop(name, None)
    if {"dynamics", "flywheel", "friction", "wear"} & set(data) or ("loads" in data and not massive):
        loads = data.setdefault("loads", {})
        if not loads.get("forces") and not loads.get("moments"):
            pairs = [["0 deg", "4 N*m"], ["120 deg", "30 N*m"], ["360 deg", "4 N*m"]]
            loads["moments"] = [{"on": "1", "direction": "against motion", "by_angle": pairs}]
    if {"law", "stroke"} & set(data["mechanism"]["driver"]):
        for name in UNIFORM:
            if name != "friction" or "law" in data["mechanism"]["driver"]:
                data.pop(name, None)
        data.get("friction", {}).pop("corrected", None)
    if "range" in data["mechanism"]["driver"]:
        for name in ("dynamics", "flywheel", "harmonics", "balancing", "wear", "press"):
            data.pop(name, None)
    if "press" in data:
        _pressed(data)
    if "friction" not in data:
        data.get("flywheel", {}).pop("friction", None)


def _pressed(data: dict[str, Any]) -> None:
    """The press is a slider on a fixed guide, which leads to the side of its dead point; where there is one."""
    guides, made = data["mechanism"].get("guides", {}), data["press"]
    if not {"torque", "within", "working"} & set(made):
        made["within"] = "1 mm"
    if "working" in made:
        made["working"] = sorted(made["working"], key=_leading, reverse=True)
    for link, stated in data["mechanism"]["links"].items():
        slides = stated.get("slides")
        slides = slides.get("guide") if isinstance(slides, dict) else slides
        guide = guides.get(slides) if isinstance(slides, str) else None
        if guide is not None and "link" not in guide:
            upright = str(guide.get("angle", 0)).startswith("90")
            sides = ("up", "down") if upright else ("right", "left")
            made["slider"] = link
            if made.get("extreme") not in sides:
                made["extreme"] = sides[len(link) % 2]
            return
    data.pop("press")


def _leading(value: Any) -> float:
    """The number that a text begins with; an odd one is nothing."""
    try:
        return float(str(value).split()[0])
    except (ValueError, IndexError):
        return 0.0


def _positions(made: dict[str, Any], walk: Walk) -> None:
    turns = walk.names.turns
    made.setdefault("table", 4 * turns if walk.random.random() < 0.5 else 8 * turns)
    made.setdefault("diagram", 12 * turns)
    made["table"] = -(-made["table"] // turns) * turns
    made["diagram"] = made["table"] * walk.random.randint(1, 3)
    made["plans"] = made.get("plans", 1)
    walk.names.positions = made["table"]


def text(seed: str) -> str:
    return json.dumps(variant(seed), ensure_ascii=False)
