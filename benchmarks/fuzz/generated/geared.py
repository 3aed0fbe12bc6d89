"""Mechanisms with wheels in mesh by chance: two cranks coupled by gears, a rack on a slider, planets, rollers."""

from __future__ import annotations

from random import Random
from typing import Any

Data = dict[str, Any]


def mm(length: float) -> str:
    return f"{length:.6g} mm"


def coupled_cranks(random: Random) -> tuple[Data, Data]:
    """A geared five-bar, its rods in C, some with an idler beside."""
    times, internal = random.choice((1, 1, 2, 3)), random.random() < 0.3
    times = max(times, 2) if internal else times
    module, own = random.choice((3, 4, 5)), random.choice((40, 60))
    other = own // times
    apart = module * (own - other if internal else own + other) / 2
    wheels: Data = {"links": [1, 2]}
    way = random.randrange(3)
    if way == 0:
        wheels["teeth"] = [own, other]
        if random.random() < 0.5:
            wheels["module"] = mm(module)
    elif way == 1:
        wheels["radii"] = [mm(module * own / 2), mm(module * other / 2)]
    else:
        wheels["ratio"] = other / own
    if internal or random.random() < 0.3:
        wheels["mesh"] = "internal" if internal else "external"
    _engaged(wheels, random)
    if random.random() < 0.4:
        wheels["phase"] = f"{random.uniform(-180, 180):.4g} deg"
    elif random.random() < 0.5:
        wheels["angles"] = ["0 deg", f"{random.uniform(-180, 180):.4g} deg"]
    crank, rod = random.uniform(0.1, 0.2) * apart, random.uniform(0.8, 1.2) * apart
    return {
        "frame": {"O": [0, 0], "Q": [mm(apart), 0]},
        "links": {
            "1": {"points": {"O": 0, "A": mm(crank)}},
            "2": {"points": {"Q": 0, "D": mm(crank * random.uniform(0.6, 1.2))}},
            "3": {"points": {"A": 0, "B": mm(rod)}},
            "4": {"points": {"D": 0, "B": mm(rod * random.uniform(0.9, 1.1))}},
        },
        "wheels": [wheels],
        "driver": {"link": 1},
        "assembly": {"B": random.choice(("left of A-D", "right of A-D"))},
    }, {}


def racked_slider(random: Random) -> tuple[Data, Data]:
    """A slider-crank whose slider turns a wheel."""
    crank, radius = random.uniform(30, 120), random.uniform(20, 60)
    rack: Data = {"slider": 3, "wheel": 4}
    if random.random() < 0.5:
        rack |= {"teeth": random.randint(17, 40), "module": mm(random.choice((3, 4)))}
    else:
        rack["radius"] = mm(radius)
    if random.random() < 0.5:
        rack["side"] = random.choice(("above", "below", "above", "left", "right"))
    if random.random() < 0.3:
        rack["phase"] = "20 deg"
    _engaged(rack, random)
    return {
        "frame": {"O": [0, 0], "E": [mm(2 * crank), mm(random.choice((-1, 1)) * (radius + 20))]},
        "guides": {"x": {"through": "O"}},
        "links": {
            "1": {"points": {"O": 0, "A": mm(crank)}},
            "2": {"points": {"A": 0, "B": mm(crank * random.uniform(2.5, 5))}},
            "3": {"points": ["B"], "slides": "x"},
            "4": {"points": {"E": 0}},
        },
        "racks": [rack],
        "driver": {"link": 1},
        "assembly": {"B": random.choice(("right", "left"))},
    }, {"B": ("left", "right")}


def planet_on_crank(random: Random) -> tuple[Data, Data]:
    """A planet round a fixed wheel or in a ring, with a rod from its pin to a slider at times."""
    times, internal = random.choice((1, 2, 2, 3, 4)), random.random() < 0.5
    times = max(times, 2) if internal else times
    planet = random.choice((20, 30, 40))
    arm = planet * (times - 1 if internal else times + 1)
    wheels: Data = {"links": [0, 2], "carrier": 1, "mesh": "internal" if internal else "external"}
    if random.random() < 0.5:
        wheels["radii"] = [mm(times * planet), mm(planet)]
    else:
        wheels["teeth"] = [20 * times, 20]
    _engaged(wheels, random)
    if random.random() < 0.5:
        wheels["phase"] = f"{random.uniform(-180, 180):.4g} deg"
    pin = random.uniform(0.3, 1.2) * planet
    data: Data = {
        "frame": {"O": [0, 0]},
        "links": {"1": {"points": {"O": 0, "A": mm(arm)}}, "2": {"points": {"A": 0, "D": mm(pin)}}},
        "wheels": [wheels],
        "driver": {"link": 1},
    }
    if random.random() < 0.3:
        return data, {}
    data["guides"] = {"x": {"through": "O"}}
    data["links"] |= {
        "3": {"points": {"D": 0, "B": mm(random.uniform(2.5, 5) * (arm + pin))}},
        "4": {"points": ["B"], "slides": "x"},
    }
    return data | {"assembly": {"B": random.choice(("right", "left"))}}, {"B": ("left", "right")}


def sun_and_planet(random: Random) -> tuple[Data, Data]:
    """A wheel fixed to the coupler of a crank-rocker turns one about the pivot of the crank, or of the rocker."""
    crank = random.uniform(60, 120)
    on_crank, ratio = random.random() < 0.5, random.choice((1, 2, 1.7))
    wheels: Data = {"links": [2, 4], "carrier": 1 if on_crank else 3, "ratio": ratio}
    _engaged(wheels, random)
    return {
        "frame": {"O": [0, 0], "C": [mm(3.5 * crank), 0]},
        "links": {
            "1": {"points": {"O": 0, "A": mm(crank)}},
            "2": {"points": {"A": 0, "B": mm(3.3 * crank)}},
            "3": {"points": {"C": 0, "B": mm(2.4 * crank)}},
            "4": {"points": {"O" if on_crank else "C": 0}},
        },
        "wheels": [wheels],
        "driver": {"link": 1},
        "assembly": {"B": random.choice(("left of A-C", "right of A-C"))},
    }, {}


def rolling_wheel(random: Random) -> tuple[Data, Data]:
    """A slider-crank whose slider is the axle of a wheel: it rolls on a rail, or on a fixed rack and moves another."""
    crank, radius = random.uniform(30, 120), random.uniform(20, 60)
    side, other = random.choice((("above", "below"), ("below", "above")))
    on_wheel: Data = {"wheel": 4, "carrier": 3, "radius": mm(radius)}
    data: Data = {
        "frame": {"O": [0, 0]},
        "guides": {"x": {"through": "O"}},
        "links": {
            "1": {"points": {"O": 0, "A": mm(crank)}},
            "2": {"points": {"A": 0, "B": mm(crank * random.uniform(2.5, 5))}},
            "3": {"points": ["B"], "slides": "x"},
            "4": {"points": {"B": 0, "E": mm(0.5 * radius)}},
        },
        "driver": {"link": 1},
        "assembly": {"B": random.choice(("right", "left"))},
    }
    if random.random() < 0.5:
        data["rolling"] = [on_wheel | {"side": side}]
        return data, {"B": ("left", "right")}
    data["racks"] = [{"slider": 0, "side": side} | on_wheel]
    if random.random() < 0.7:
        data["frame"]["P"] = [0, mm(radius if side == "above" else -radius)]
        data["guides"]["y"] = {"through": "P"}
        data["links"]["5"] = {"points": ["K"], "slides": "y"}
        data["racks"].append({"slider": 5, "side": other} | on_wheel)
    for rack in data["racks"]:
        _engaged(rack, random)
    return data, {"B": ("left", "right")}


def _engaged(one: Data, random: Random) -> None:
    if random.random() < 0.4:
        one["pressure_angle"] = random.choice(("0 deg", "20 deg", "25 deg"))
