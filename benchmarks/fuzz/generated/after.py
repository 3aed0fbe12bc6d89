"""What follows from what was drawn: numbers that must agree, keys that another part of the variant forbids."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from benchmarks.fuzz.generated import asked, driving, gears
from benchmarks.fuzz.generated.gears import value as _value
from benchmarks.fuzz.generated.rules import RUBBING

Made = dict[str, Any]


def _periodic(made: Made, walk: Any) -> Made:
    """A table over one turn, the same at its end."""
    if "table" in made:
        pairs = made["table"]
        count = max(3, len(pairs))
        ends = [[f"{360 * k / (count - 1):.6g} deg", pairs[k % len(pairs)][1]] for k in range(count)]
        made["table"] = [*ends[:-1], [ends[-1][0], ends[0][1]]]
    return made


def _part(made: Made, walk: Any) -> Made:
    if made.get("velocity") is not None:
        made.pop("radius", None)
    if made.get("offset") is not None:
        for key in ("ratio", "moves"):
            made.pop(key, None)
    if not made.get("mass") and not made.get("force"):
        for key in ("moves", "angle"):
            made.pop(key, None)
    if str(made.get("ratio", "1")).split(" ")[0] == "0":
        made.pop("ratio")
    return made


def _laws(made: Made, walk: Any) -> Made:
    """Points over the speed or the time fall, so that they are in balance with what resists."""
    for key, step, unit in (("by_speed", 12, "rad/s"), ("by_time", 0.4, "s"), ("by_angle", 110, "deg")):
        if key in made:
            moments = sorted((_value(pair[1]) for pair in made[key]), reverse=True)
            made[key] = [[f"{k * step:.6g} {unit}", moment] for k, moment in enumerate(moments)]
            if key == "by_speed":
                made[key].append([f"{len(moments) * step} rad/s", 0])
    return made


def _all_round(pairs: list[Any], period: float) -> list[Any]:
    """Pairs at equal steps over a cycle, the next of which begins as it did."""
    return [[f"{period * k / len(pairs):.6g} deg", one[1]] for k, one in enumerate(pairs)]


def _dynamics(made: Made, walk: Any) -> Made:
    period = _value(made["period"]) if "period" in made else 360 * walk.names.turns
    for law in (made.get("motor") or {}, *made.get("resistance", ())):
        if "by_angle" in law and walk.random.random() < 0.9:
            law["by_angle"] = _all_round(law["by_angle"] * 3, period)
    heavy = any("inertia" in part or "mass" in part for part in made.get("parts", ()))
    if walk.names.mechanism:
        for key in ("period", "varying_inertia"):
            made.pop(key, None)
    else:
        if walk.random.random() < 0.9:
            made.pop("friction", None)
            made.pop("torsion_springs", None)
        if not heavy and "varying_inertia" not in made:
            made["parts"] = [{"name": "wheel", "inertia": "3 kg*m^2"}]
    if any("velocity" in part for part in made.get("parts", ())):
        made.setdefault("speed", "12 rad/s")
    if pairs := made.get("varying_inertia"):
        sizes = [_value(pair[1]) + 0.1 for pair in pairs]
        period = _value(made["period"]) if "period" in made else 360
        points = [[f"{period * k / len(sizes):.6g} deg", f"{size} kg*m^2"] for k, size in enumerate(sizes)]
        made["varying_inertia"] = [*points, [f"{period:.6g} deg", points[0][1]]]
    if not (made.get("motor") or made.get("parts") or made.get("resistance") or made.get("springs")):
        made["motor"] = {"constant": "40 N*m"}
    for key in ("start", "coast"):
        if key in made and "motor" not in made:
            made[key].pop("motor", None)
    if "coast" in made and "begin" not in made["coast"] and walk.random.random() < 0.7:
        made["coast"]["begin"] = f"{walk.random.uniform(10, 30):.3g} rad/s"
    if "coast" in made and "resistance" not in made and "brake" not in made["coast"]:
        made["resistance"] = [{"friction": "6 N*m"}]
    start = made.get("start")
    if start is not None and "speed" in start and "begin" in start:
        start.pop("begin")
    return made


def _spring(made: Made, walk: Any) -> Made:
    if walk.names.mechanism and walk.random.random() < 0.7:
        return {
            "at": walk.random.choice(walk.names.of["at"]),
            "to": ["0.9 m", "0.7 m"],
            **{key: made[key] for key in ("stiffness", "length")},
        }
    made = {key: one for key, one in made.items() if key not in ("at", "to")}
    return {"radius": "50 mm", "apart": "220 mm", **made}


def _loading(made: Made, walk: Any) -> Made:
    """A law by positions has the positions of the table, one by displacement a point that slides."""
    names = walk.names
    if "by_position" in made:
        count = names.positions + names.partial
        made["by_position"] = [made["by_position"][k % len(made["by_position"])] for k in range(count)]
    if "by_angle" in made:
        count, whole = len(made["by_angle"]), 360 * names.turns
        points = [[f"{whole * k / count:.6g} deg", one[1]] for k, one in enumerate(made["by_angle"])]
        made["by_angle"] = [*points, [f"{whole} deg", points[0][1]]]
    if "by_time" in made:
        first, *others = made["by_time"]
        zero = f"0 {str(first[1]).partition(' ')[2]}".strip()
        middle = [[f"{0.02 * (k + 1):.3g} s", one[1]] for k, one in enumerate(others[:5])]
        made["by_time"] = [["0 s", zero], *middle, [f"{0.02 * (len(middle) + 1):.3g} s", zero]]
    if "by_displacement" in made:
        if not names.axes or (names.partial and walk.random.random() < 0.9):
            made.pop("by_displacement")
            made["constant"] = "20 kPa" if "piston_diameter" in made else "150 N"
        else:
            made["at"] = walk.random.choice(list(names.axes))
            made["by_displacement"]["zero"] = walk.random.choice(names.axes[made["at"]])
            made.pop("on", None)
    elif "on" in made and "at" in made:
        made.pop("on")
    if "stroke" in made and "at" in made:
        if names.axes and not names.partial:
            made["at"] = walk.random.choice(list(names.axes))
            made["stroke"]["zero"] = walk.random.choice(names.axes[made["at"]])
            made.pop("on", None)
        elif walk.random.random() < 0.9:
            made.pop("stroke")
    if "at" in made and made.get("direction") in ("along motion", "against motion"):
        made["at"] = walk.random.choice(names.of.get("free", names.of["at"]))
    return made


def _turning(made: Made, walk: Any) -> Made:
    """What goes by the swing of a link is mostly constant: few links swing."""
    if walk.random.random() < 0.7:
        made.pop("stroke", None)
        if made.pop("by_displacement", None):
            made["constant"] = "12 N*m"
    return _loading(made, walk) if "by_displacement" not in made else made


def _function(made: Made, walk: Any) -> Made:
    made["x"] = sorted(made["x"], key=_value)
    return made


def _dwell(made: Made, walk: Any) -> Made:
    made["angles"] = sorted(made["angles"], key=_value)
    return made


def _led(made: Made, walk: Any) -> Made:
    """Positions along a bend, pins apart."""
    random = walk.random
    made["positions"] = [
        [f"{60 * k + random.uniform(-9, 9):.4g} mm", f"{random.uniform(0, 40):.4g} mm", f"{22 * k} deg"]
        for k in range(3)
    ]
    made["points"] = [[0, 0], [f"{random.uniform(40, 90):.4g} mm", f"{random.uniform(0, 40):.4g} mm"]]
    two = {"crank", "rocker", "crank_pivot", "rocker_pivot", "crank_angle", "crank_way"} & set(made)
    if two and random.random() < 0.5:
        made["positions"].pop()
        made.setdefault("crank", "90 mm")
        return made
    for key in two if random.random() < 0.9 else ():
        made.pop(key)
    return made


def _tie(made: Made, walk: Any) -> Made:
    """Between two points."""
    first, second = made["between"]
    others = [one for one in walk.names.of.get("at", ()) if one != first]
    if first == second and others:
        made["between"] = [first, walk.random.choice(others)]
    made.pop("on", None) if walk.random.random() < 0.7 else None
    return made


def _rocker(made: Made, walk: Any) -> Made:
    """Extreme positions want the length of the rocker."""
    if "crank_angles" not in made:
        made.setdefault("rocker", "300 mm")
    return made


def _strokes(made: Made, walk: Any) -> Made:
    words = ("intake", "compression", "power", "exhaust", "хлопок", "e", "f", "g")[: 2 * walk.names.turns]
    values = list(made["strokes"].values())
    made["strokes"] = {word: values[k % len(values)] for k, word in enumerate(words)}
    if "first" in made:
        made["first"] = words[0]
    return made


def _friction(made: Made, walk: Any) -> Made:
    if "materials" not in made:
        for key in ("lubrication", "state"):
            made.pop(key, None)
    return made


def _joints(made: Made, walk: Any) -> Made:
    """A pivot has a diameter, a guide a length."""
    if "joints" in made:
        for name, one in made["joints"].items():
            one.pop("diameter" if name in walk.names.of.get("guide", ()) else "length", None)
            if name not in walk.names.of.get("guide", ()):
                one.setdefault("diameter", "30 mm")
    if walk.random.random() < 0.9:
        made.get("cams", {}).setdefault("diameter", "6 mm")
    return made


def _ordered(low: str, high: str) -> Callable[[Made, Any], Made]:
    def put(made: Made, walk: Any) -> Made:
        if low in made and high in made and _value(made[low]) >= _value(made[high]):
            made[low], made[high] = made[high], made[low]
        return made

    return put


def _flywheel(made: Made, walk: Any) -> Made:
    if walk.names.mechanism:
        for key in (
            "driving",
            "resisting",
            "areas",
            "punch",
            "inertia",
            "speed",
            "turns",
            "speeds",
            "positions",
        ):
            made.pop(key, None)
        if "wheel" not in made:
            made.setdefault("delta", "1/40")
    elif walk.random.random() < 0.9:
        made.pop("friction", None)
    for key in ("driving", "resisting", "inertia"):
        if "table" in made.get(key, {}) and walk.random.random() < 0.9:
            made[key]["table"] = _all_round(made[key]["table"] * 3, 360)
    stated = [key for key in ("driving", "resisting") if key in made]
    if len(stated) == 2 and walk.random.random() < 0.9:
        made.pop(stated.pop(0))
    if len(stated) == 1 and set(made[stated[0]]) == {"constant"}:
        made[stated[0]] = {"table": [["0 deg", "5 N*m"], ["90 deg", "80 N*m"], ["360 deg", "5 N*m"]]}
    if "speeds" in made:
        made["speeds"] = sorted(made["speeds"], key=_value)
    if made.get("shaft") == "motor":
        made.setdefault("motor", {"power": "5 kW", "speed": "960 rpm"})
    if "areas" in made:
        values = made["areas"]["values"]
        values[-1] = round(-sum(map(_value, values[:-1])), 6)
        if "inertia" in made:
            made["inertia"] = {"constant": "2 kg*m^2"}
    return made


def _harmonics(made: Made, walk: Any) -> Made:
    for one in made.get("harmonics", ()):
        one["order"] = round(_value(one["order"]))
    return _periodic(made, walk)


def _cylinders(made: Made) -> int:
    """How many there are."""
    for key, each in (("inline", 1), ("vee", 2), ("opposed", 1)):
        if key in made:
            return each * len(made[key]["cranks"])
    return int(made["radial"]["cylinders"]) if "radial" in made else len(made.get("cylinders", ()))


def _engine(made: Made, walk: Any) -> Made:
    count = _cylinders(made)
    if "cylinders" in made:
        for k, one in enumerate(made["cylinders"], 1):
            if "name" in one:
                one["name"] = f"c{k}"
            one["crank"] = f"{360 * k // count} deg"
    if "firing" in made:
        names = [one.get("name", k) for k, one in enumerate(made.get("cylinders", [{}] * count), 1)]
        made["firing"] = walk.random.sample(names, min(count, len(names)))
    return made


def _governor(made: Made, walk: Any) -> Made:
    if "arms" in made:
        lowest = walk.random.uniform(110, 150)
        highest = "highest" in made.get("radius", {})
        made["radius"] = {"lowest": f"{lowest:.4g} mm"}
        if highest:
            made["radius"]["highest"] = f"{lowest + walk.random.uniform(10, 30):.4g} mm"
            made.pop("lift", None)
        else:
            made.setdefault("lift", "20 mm")
    elif "bell_crank" in made:
        crank = made["bell_crank"]
        if not crank.get("level"):
            crank.setdefault("fulcrum", "130 mm")
        made["radius"] = {"lowest": f"{_value(crank.get('fulcrum', 130)) - 12:.5g} mm"}
        for key in ("distance", "extension"):
            made.get("balls", {}).pop(key, None)
    for key in ("balls", "sleeve"):
        made.setdefault(key, {})
    choose = made.get("choose")
    if choose:
        key = next(iter(choose))
        if key == "balls":
            made["balls"].pop("mass", None)
        if key == "sleeve":
            made["sleeve"].pop("mass", None)
        if key == "spring":
            made.pop("spring", None)
            low = walk.random.uniform(250, 500)
            choose["spring"] = [f"{low:.4g} rpm", f"{low * walk.random.uniform(1.05, 1.25):.4g} rpm"]
    if "mass" not in made["balls"] and not (choose and "balls" in choose):
        made["balls"]["mass"] = "2.5 kg"
    return made


def _efficiencies(made: Made, walk: Any) -> Made:
    """Shares of the branches make the whole."""
    key, branches = ("output_share" if "output" in made else "share"), []
    stack = [made]
    while stack:
        one = stack.pop()
        stack += one.get("series", []) + one.get("parallel", [])
        branches += [one["parallel"]] if "parallel" in one else []
        for share in ("share", "output_share"):
            one.pop(share, None)
    for parts in branches:
        for k, one in enumerate(parts):
            rest = 1 - 0.1 * (len(parts) - 1)
            one[key] = round(rest, 6) if k == 0 else 0.1
    return made


def _rotor(made: Made, walk: Any) -> Made:
    if not made.get("masses") and not made.get("bodies"):
        made["masses"] = [walk.part("Heavy"), walk.part("Heavy")]
    for k, one in enumerate([*made.get("masses", ()), *made.get("bodies", ())]):
        if "name" in one:
            one["name"] = f"m{k}"
    if len(made["planes"]) == 2:
        made["planes"][0]["at"], made["planes"][1]["at"] = "20 mm", "500 mm"
    return made


def _wear(made: Made, walk: Any) -> Made:
    for one in made.get("pivots", ()):
        point = walk.random.choice(list(walk.names.of["pivots"]))
        one["pivot"], links = point, walk.names.of["pivots"][point]
        one["journal"] = walk.random.choice(links)
        one.pop("bushing", None)
        if len(links) > 2:
            one["bushing"] = next(link for link in links if link != one["journal"])
    for one in made.get("guides", ()):
        one.pop("slider", None) if walk.random.random() < 0.8 else None
    if not walk.names.of.get("guide"):
        made.pop("guides", None)
    if not made.get("guides") and not made.get("pivots"):
        made["pivots"] = _wear({"pivots": [walk.part("PivotModel")]}, walk)["pivots"]
    return made


def _sides(made: Made, walk: Any) -> Made:
    return {
        key: sorted(one, key=lambda p: _value(p[0])) if isinstance(one, list) else one
        for key, one in made.items()
    }


def _swung(made: Made, walk: Any) -> Made:
    """The excitation of one kind."""
    kinds = [key for key in ("force", "unbalance", "base", "mechanism", "moment") if key in made]
    kept = walk.random.choice(kinds) if kinds else ""
    for key in kinds:
        if key != kept:
            made.pop(key)
    if "mechanism" in made and not walk.names.mechanism:
        made.pop("mechanism")
        made["base"] = "1 mm"
    if "friction" in made:
        for key in ("unbalance", "base", "mechanism", "foundation", "absorber", "transmissibility"):
            made.pop(key, None)
        key, size = ("force", "400 N") if "mass" in made else ("moment", "20 N*m")
        made.setdefault(key, size)
        made.setdefault("speed", "300 rpm")
    if "base" in made:
        made.pop("foundation", None)
    if not {"stiffness", "transmissibility", "deflection"} & set(made):
        made["stiffness"] = "900 kN/m" if "mass" in made else "500 N*m/rad"
    if "transmissibility" in made or "deflection" in made:
        made.pop("stiffness", None)
    return made


def _balanced(made: Made, walk: Any) -> Made:
    """Counterweights and wheels belong to links with a fixed pivot, weights to orders, and what no method uses goes."""
    pivoted = list(walk.names.of.get("pivoted", ())) or ["1"]
    for key in ("counterweights", "stated"):
        if key in made:
            made[key] = dict(zip(pivoted, made[key].values(), strict=False))
    if "wheels" in made:
        made["wheels"] = dict(zip(pivoted[1:], made["wheels"].values(), strict=False))
    for key in ("rotors", "couples"):
        if key in made:
            made[key] = {str(k): one for k, one in enumerate(list(made[key].values())[:2], 1)}
        elif "methods" in made:
            made["methods"] = [one for one in made["methods"] if one != key] or ["full"]
    for key, method in (("wheels", "inertia"), ("couples", "couples")):
        if method not in made.get("methods", (method,)) or not made.get(key):
            made.pop(key, None)
    if not {"inertia", "couples"} & {*made.get("methods", ()), *made}:
        made.pop("after", None)
    if made.get("after") not in (
        None,
        "none",
        *made.get("methods", ()),
        *(("stated",) if "stated" in made else ()),
    ):
        made["after"] = "none"
    return made


AFTER: Mapping[str, Callable[[Made, Any], Made]] = {
    "flywheel.Moment": _harmonics,
    "Inertia": _harmonics,
    "PartModel": _part,
    "MotorModel": _laws,
    "ResistanceModel": _laws,
    "SpeedModel": asked.rising,
    "DynamicsModel": _dynamics,
    "dynamics.Spring": _spring,
    "Damper": _tie,
    "kinetostatics.Spring": _tie,
    "RockerPositions": _rocker,
    "Force": _loading,
    "Piston": _loading,
    "kinetostatics.Moment": _turning,
    "Vector": _loading,
    "Generator": _function,
    "Dwell": _dwell,
    "synthesis.Body": _led,
    "StrokesDiagram": _strokes,
    "PressureStrokesDiagram": _strokes,
    "FrictionModel": _joints,
    "LawModel": driving.law,
    "Punch": _ordered("time", "period"),
    "Coast": _ordered("speed", "begin"),
    "Flywheel": _flywheel,
    "Engine": _engine,
    "governor.Given": _governor,
    "EfficiencyModel": _efficiencies,
    "PlanetaryModel": gears.planetary,
    "Spur": gears.spur,
    "PairStage": gears.pair,
    "BeltStage": gears.belt,
    "DriveModel": gears.drive,
    "ChainStage": gears.chain,
    "BevelStage": gears.bevel,
    "WormStage": gears.worm,
    "FrictionStage": gears.friction,
    "TrainStage": gears.train,
    "Eccentric": gears.eccentric,
    "rotor.Given": _rotor,
    "WearModel": _wear,
    "Sides": _sides,
    "Halves": _sides,
    "Balancing": _balanced,
    "TwoFaces": _sides,
    "Linear": _swung,
    "Turning": _swung,
    **dict.fromkeys(RUBBING, _friction),
}
