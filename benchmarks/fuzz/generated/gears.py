"""What goes together in the gear drives of a drawn variant, and its compound gear trains."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

Made = dict[str, Any]


def value(written: Any) -> float:
    return float(str(written).split(" ")[0])


def planetary(made: Made, walk: Any) -> Made:
    rows = {"sun-ring": ("sun", "ring"), "any": ("wheel1", "wheel3")}
    first, last = rows.get(made.get("scheme", "sun-ring"), ("wheel1", "wheel3"))
    members = walk.random.sample([first, last, "carrier"], 3)
    if "fixed" in made and made.get("scheme") not in ("sun-ring", None):
        members, made["ratio"] = ["carrier", first, last], walk.random.choice((8, 12, -6, 20))
        if walk.random.random() < 0.7:
            members[:2] = members[1::-1]
        if walk.random.random() < 0.2:
            members = [last, "carrier", first]
    elif walk.random.random() < 0.7:
        members = [first, "carrier", last]
    made["input"], made["output"] = members[:2]
    if "fixed" in made:
        made["fixed"] = members[2]
    if "second" in made:
        made["second"]["member"] = members[2]
    single = made.get("scheme", "sun-ring") == "sun-ring"
    if isinstance(made.get("module"), list):
        made["module"] = made["module"][0] if single else sorted(made["module"], key=value)
    if isinstance(made.get("shift"), list):
        made["shift"] = [0.2, 0.1, 0, 0.1][: 3 if single else 4]
        made.setdefault("teeth", [20, 30, 80] if single else [20, 40, 20, 80])
    if "teeth" in made:
        z = walk.random.randint(17, 25)
        made["teeth"] = [z, 2 * z, 5 * z] if single else [z, 2 * z, z, 4 * z]
        made["ratio"] = 6 if single else 9
    for key, least in (("external_teeth", 15), ("ring_teeth", 30)):
        if key in made:
            made[key] = [least, least + 45]
    made.setdefault("external_teeth", [15, 45])
    made.setdefault("ring_teeth", [40, 110])
    return made


def spur(made: Made, walk: Any) -> Made:
    if "teeth" in made:
        made["teeth"] = [walk.random.randint(14, 30), walk.random.randint(31, 70)]
        sign = walk.random.choice((-1, -1, 1))
        made["ratio"] = sign * float(Fraction(made["teeth"][1], made["teeth"][0]))
        made.pop("centre_distance", None) if walk.random.random() < 0.5 else None
    elif "centre_distance" in made:
        module, ratio = value(made["module"]), abs(value(made.setdefault("ratio", -2)))
        made["centre_distance"] = f"{module * round(20 * (1 + ratio) / 2, 1):.6g} mm"
    if "mesh" in made and "ratio" in made:
        made["ratio"] = abs(value(made["ratio"])) * (1 if made["mesh"] == "internal" else -1)
    if "tip_diameters" in made:
        z = made.get("teeth", [20, 40])
        ring = value(made.get("ratio", -2)) > 0
        m = value(made["module"])
        made["tip_diameters"] = [f"{m * (z[0] + 2):.6g} mm", f"{m * (z[1] + (-1.7 if ring else 2)):.6g} mm"]
        made.setdefault("teeth", z)
    if "quality" in made:
        made["quality"] = _quality(made, walk)
    if "teeth" in made and "ratio" in made and walk.random.random() < 0.2:
        made["teeth"][walk.random.randint(0, 1)] = "rest"
    return made


def _quality(made: Made, walk: Any) -> Made:
    """Shifts and centre distances that ascend, most of them near the pair's own."""
    asked = dict(made["quality"])
    if "x1" in asked:
        asked["x1"] = sorted({round(walk.random.uniform(-0.1, 0.7), 2) for _ in range(5)})
    if "centre_distances" in asked:
        plain = 15.0 * value(made["module"])
        if "rest" not in (teeth := made.get("teeth", ["rest"])):
            one, two = teeth
            plain = value(made["module"]) * (two - one if value(made["ratio"]) > 0 else two + one) / 2
        asked["centre_distances"] = [
            f"{plain * (1 + k / 200):.6g} mm" for k in range(walk.random.randint(2, 4))
        ]
    return asked


def belt(made: Made, walk: Any) -> Made:
    if made.get("belt") == "crossed":
        made.pop("ratio", None) if "driven" in made else None
    if isinstance(made.get("ratio"), float | int):
        made["ratio"] = abs(made["ratio"])
    if not {"driven", "ratio"} <= set(made) or "driving" not in made:
        made["driven"] = "280 mm"
    if {"driving", "ratio"} <= set(made) and walk.random.random() < 0.4:
        made["driven"] = "standard"
    if made.get("belt") != "V":
        made.pop("groove", None)
    if "distance" in made and made.get("length") != "standard":
        made.pop("length", None)
    return made


def pair(made: Made, walk: Any) -> Made:
    made["teeth"] = [walk.random.randint(17, 30), walk.random.randint(31, 90)]
    if "ratio" in made:
        made["ratio"] = round(-made["teeth"][1] / made["teeth"][0], 3)
        if walk.random.random() < 0.5:
            made["teeth"][walk.random.randint(0, 1)] = "rest"
    return made


POWER = ("motors", "overload", "ratio_range", "needed", "bearings", "coupling", "split", "shafts")


def drive(made: Made, walk: Any) -> Made:
    """Either a speed and a torque, or a machine and motors, whose ratio the stages have or one of them is left."""
    random, stages = walk.random, made["stages"]
    divided = any("second" in stage for stage in stages)
    if divided or random.random() < 0.4 or ("output" not in made and random.random() < 0.5):
        for key in POWER:
            made.pop(key, None)
        if isinstance(made.get("output"), dict):
            made.pop("output")
        made.setdefault("speed", "1460 rpm")
        return made
    made.pop("torque", None)
    whole = 1.0
    for stage in stages:
        whole *= abs(value(stage.get("ratio", 2)))
    pairs = [stage for stage in stages if stage["kind"] == "spur"]
    if pairs and random.random() < 0.5:
        opened = random.choice(pairs)
        whole *= random.uniform(2.2, 6) / abs(value(opened.get("ratio", 2)))
        opened["teeth"] = [random.randint(17, 26), "rest"]
        for key in set(opened) - {"kind", "name", "module", "mesh", "teeth", "rack", "helix", "efficiency"}:
            opened.pop(key)
        made.setdefault("motors", [])
    turns = random.choice((950, 1410, 2850))
    machine = made["output"] if isinstance(made.get("output"), dict) else {"power": "2 kW"}
    loaded = bool({"force", "torque", "power"} & set(machine))
    if "motors" in made or not loaded:
        made.pop("speed", None)
        motors = [[f"M{k}", f"{power} kW", f"{turns} rpm"] for k, power in enumerate((1.5, 4, 30))]
        made["motors"] = motors[: random.choice((1, 3)) if loaded else 1]
    else:
        made["speed"] = f"{turns} rpm"
    if "ratio_range" in made:
        made["ratio_range"] = [round(whole / 2, 2), round(whole * 2, 2)]
    rpm = turns / whole
    around = value(machine.get("diameter", "300 mm")) / 1000
    if "pitch" in machine:
        machine |= {"teeth": 9, "pitch": "80 mm", "speed": f"{9 * 0.08 * rpm / 60:.6g} m/s"}
    elif "force" in machine or "diameter" in machine:
        machine.setdefault("diameter", "300 mm")
        machine["speed"] = f"{3.141593 * around * rpm / 60:.6g} m/s"
    else:
        machine["speed"] = f"{rpm:.6g} rpm"
    made["output"] = machine
    made.pop("needed", None) if random.random() < 0.9 else None
    shafts = 1 + len(stages)
    if isinstance(made.get("coupling"), dict):
        made["coupling"].pop("after", None)
    shafts += "coupling" in made
    if isinstance(made.get("bearings"), dict) and "pairs" in made["bearings"]:
        made["bearings"]["pairs"] = [random.randint(0, 2) for _ in range(shafts)]
    opened = any("rest" in stage.get("teeth", ()) for stage in stages if isinstance(stage.get("teeth"), list))
    if opened and isinstance(made.get("split"), dict):
        made["split"] = {"step": 1.2}
    if "motors" not in made and "shafts" in made:
        made["shafts"].pop("by", None)
    return made


def chain(made: Made, walk: Any) -> Made:
    made["teeth"] = walk.random.randint(17, 29)
    if "ratio" in made:
        made["ratio"] = abs(value(made["ratio"]))
    else:
        made["teeth"] = [made["teeth"], walk.random.randint(30, 70)]
    if "distance" in made:
        made.pop("links", None)
    return made


def friction(made: Made, walk: Any) -> Made:
    if made.get("contact") == "internal":
        made.pop("ratio", None)
        made |= {"driving": "80 mm", "driven": f"{walk.random.randint(120, 300)} mm"}
    if made.get("contact") != "bevel":
        made.pop("shaft_angle", None)
    return made


def bevel(made: Made, walk: Any) -> Made:
    one = walk.random.randint(17, 25)
    made["teeth"] = one if "ratio" in made else [one, walk.random.randint(30, 60)]
    return made


def worm(made: Made, walk: Any) -> Made:
    made["starts"] = walk.random.choice((1, 1, 2, 4))
    if "teeth" in made:
        made["teeth"] = walk.random.randint(28, 60)
        made.pop("ratio", None)
    else:
        made["ratio"] = walk.random.choice((16, 20, 30))
    return made


def train(made: Made, walk: Any) -> Made:
    made["idlers"] = [walk.random.randint(17, 40) for _ in range(walk.random.randint(1, 3))]
    made["teeth"] = [walk.random.randint(17, 30), walk.random.randint(60, 90)]
    if "ratio" in made and walk.random.random() < 0.5:
        made |= {"teeth": made["teeth"][0], "ratio": walk.random.choice((3.5, 4))}
    else:
        made.pop("ratio", None)
    return made


def eccentric(made: Made, walk: Any) -> Made:
    if "teeth" in made:
        z = walk.random.randint(20, 30)
        made["teeth"] = [z, z + walk.random.choice((22, 24, 30)), 3 * z][: walk.random.choice((2, 3))]
        if len(made["teeth"]) == 2:
            made["teeth"][1] = 4 * z
            made.setdefault("eccentricity", f"{9 * value(made['module']):.6g} mm")
        for key in ("t", "tolerance"):
            made.pop(key, None)
    if "eccentricity" in made:
        made["eccentricity"] = f"{walk.random.randint(6, 20) / 2 * value(made['module']):.6g} mm"
    if "density" in made or "width" in made:
        made.setdefault("density", "7800 kg/m^3")
        made.setdefault("width", "20 mm")
    made.pop("ring_up_to", None) if walk.random.random() < 0.5 else None
    return made


# --- compound trains: the schemes of collections, what is asked of them by chance

CLOSED: Made = {
    "wheels": {"1": 18, "2": 36, "3": 90, "3'": 21, "4": 30, "5": 81},
    "carriers": {"H": 2},
    "joined": [["5", "H"]],
    "meshes": ["1-2", "2-3 internal", "3'-4", "4-5 internal"],
    "input": 1,
    "output": "H",
}
THREE_K: Made = {
    "wheels": {"a": 18, "g": 36, "b": 90, "f": 33, "e": 87},
    "carriers": {"H": ["g", "f"]},
    "joined": [["g", "f"]],
    "meshes": ["a-g", "g-b internal", "f-e internal"],
    "input": "a",
    "output": "e",
    "fixed": "b",
}
IDLERS: Made = {
    "wheels": {"1": 24, "2": 36, "3": 30, "4": 60, "4'": 20, "5": 80},
    "meshes": ["1-2", "2-3", "3-4", "4'-5 внутреннее"],
    "input": 1,
    "output": 5,
}
SUNS: Made = {
    "wheels": {"A": 28, "B": 22, "C": 26, "D": 24},
    "carriers": {"E": ["B", "C"]},
    "joined": [["B", "C"]],
    "meshes": ["A-B", "C-D"],
    "input": "E",
    "output": "D",
    "fixed": "A",
}
CHAIN: Made = {
    "wheels": {"1": 20, "2": 20, "3": 21, "4": 82},
    "carriers": {"H": ["2", "3"]},
    "meshes": ["1-2", "2-3", "3-4 internal"],
    "input": 1,
    "output": "H",
    "fixed": [4],
}
TWO_INPUTS: Made = {
    "wheels": {"1": 21, "2": 33, "3": 87},
    "carriers": {"H": 2},
    "meshes": ["1-2", "2-3 internal"],
    "input": [1, 3],
    "output": "H",
}
AXLE: Made = {
    "wheels": {"1": 11, "2": 43, "3": 20, "4": 12, "5": 20},
    "carriers": {"H": 4},
    "joined": [[2, "H"]],
    "meshes": ["1-2 bevel", "3-4 bevel", "4-5 bevel same"],
    "input": 1,
    "output": [3, 5],
}
RANGES: Made = {"a": [15, 24], "g": [18, 40], "b": [50, 100], "f": [15, 40], "e": [50, 100]}


def compound(random: Random) -> Made:
    def often(part: float = 0.4) -> bool:
        return random.random() < part

    scheme = random.choice((CLOSED, THREE_K, IDLERS, SUNS, CHAIN, TWO_INPUTS, AXLE))
    found: Made = {**scheme, **_motion(scheme, random)}
    loads: tuple[Made, ...] = (
        {"torque": f"{random.randint(1, 200)} N*m"},
        {"power": f"{random.uniform(0.2, 8):.3g} kW"},
        {"output_torque": f"{random.randint(20, 900)} N*m"},
        {"output_power": f"{random.uniform(0.2, 8):.3g} kW"},
        {"rope": {"drum": "400 mm", "force": f"{random.randint(1, 12)} kN"}},
    )
    single = len(loads) if isinstance(scheme["output"], str | int) else 2
    found |= random.choice(loads[:single]) if often(0.8) else {}
    if often(0.7):
        found["efficiency"] = {
            key: value
            for key, value in (("external", 0.98), ("internal", 0.99), ("bevel", 0.96))
            if often(0.7)
        }
        if often():
            found["efficiency"]["meshes"] = {scheme["meshes"][0].split(" ")[0]: random.choice((0.9, 0.97))}
    found |= (
        {
            "name": random.choice(
                ("3K", "drum", {"ru": "привод", "uk": "привод", "kk": "жетек", "en": "drive"})
            )
        }
        if often()
        else {}
    )
    found |= {"satellites": random.choice((2, 3, [3, 4]))} if often() and "carriers" in scheme else {}
    found |= {"module": f"{random.choice((2, 2.5, 4))} mm"} if often() else {}
    found |= {"modules": {next(iter(scheme["wheels"])): "3 mm"}} if often(0.1) else {}
    if scheme is THREE_K and often():
        found |= {"wheels": RANGES, "find": {"ratio": random.choice((60, 90, 116))}}
        found["find"] |= {"tolerance": f"{random.randint(1, 5)} %"} if often(0.7) else {}
        found["find"] |= {"shifted": random.choice((0, 1))} if often() else {}
    return found


def _motion(scheme: Made, random: Random) -> Made:
    speed = f"{random.randint(60, 1500)} rpm"
    if scheme is TWO_INPUTS:
        return {"speed": speed, "speeds": {"3": f"{random.choice((-1, 1)) * random.randint(20, 300)} rpm"}}
    if scheme is not AXLE:
        return {"speed": speed} if random.random() < 0.7 else {}
    found: Made = {"speed": speed, "speeds": {"5": f"{random.randint(0, 300)} rpm"}}
    if random.random() < 0.6:
        road = {"speed": "36 km/h", "wheel": "640 mm"}
        found = {"road": road | ({"radius": "18 m", "track": "1.45 m"} if random.random() < 0.7 else {})}
    found |= {"locking": random.choice((1.25, 2))} if random.random() < 0.5 else {}
    return found | ({"cases": [{"1": "900 rpm", "5": "0 rpm"}]} if random.random() < 0.5 else {})
