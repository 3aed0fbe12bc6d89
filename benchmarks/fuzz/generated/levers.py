"""Small mechanisms of lengths by chance, most of which close all round, with the names that other blocks may use."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Any

from benchmarks.fuzz.generated.cam_loads import loaded
from benchmarks.fuzz.generated.geared import (
    coupled_cranks,
    planet_on_crank,
    racked_slider,
    rolling_wheel,
    sun_and_planet,
)
from benchmarks.fuzz.generated.strokes import lifted_boom, pushed_crank
from benchmarks.fuzz.generated.synthesised import SYNTHESES
from benchmarks.fuzz.generated.walk import Names, Walk

Data = dict[str, Any]
LAWS = (
    "parabolic", "decreasing", "cosine", "sine", "trapezoid", "modified_trapezoid", "modified_sine", "polynomial",
    "polynomial_4567", "uniform",
)  # fmt: skip
LEVEL, UPRIGHT = ("left", "right"), ("up", "down")


def mm(length: float) -> str:
    return f"{length:.5g} mm"


def crank(random: Random) -> tuple[float, Data]:
    r = random.uniform(30, 120)
    return r, {
        "frame": {"O": [0, 0]},
        "links": {"1": {"points": {"O": 0, "A": mm(r)}}},
        "driver": {"link": 1},
    }


def alone(random: Random) -> tuple[Data, Data]:
    """The driving link and nothing else."""
    return crank(random)[1], {}


def slider_crank(random: Random) -> tuple[Data, Data]:
    r, data = crank(random)
    offset = random.choice((0, 0, random.uniform(-0.6, 0.6) * r))
    data["frame"]["Q"] = [0, mm(offset)]
    data["guides"] = {
        "x": {
            "through": random.choice(("Q", "O")) if not offset else "Q",
            "angle": random.choice((0, "0 deg")),
        }
    }
    data["links"] |= {
        "2": {"points": {"A": 0, "B": mm(r * random.uniform(2.2, 5))}},
        "3": {"points": ["B"], "slides": "x"},
    }
    data["assembly"] = {random.choice(("B", "2-3")): random.choice(("right", "left"))}
    return data, {"B": LEVEL}


def two_sliders(random: Random) -> tuple[Data, Data]:
    """Two rods on one pin."""
    r, data = crank(random)
    data["guides"] = {"x": {"through": "O"}, "y": {"through": "O", "angle": "90 deg"}}
    rod = mm(r * random.uniform(2.5, 5))
    data["links"] |= {
        "2": {"points": {"A": 0, "B": rod}},
        "3": {"points": ["B"], "slides": "x"},
        "4": {"points": {"A": 0, "D": rod}},
        "5": {"points": ["D"], "slides": "y"},
    }
    data["assembly"] = {"B": "right", "D": "up"}
    return data, {"B": LEVEL, "D": UPRIGHT}


def four_bar(random: Random) -> tuple[Data, Data]:
    """A crank and rocker, a double crank, or what happens to be."""
    r, data = crank(random)
    frame, rod, rocker = (r * random.uniform(2.2, 2.8) for _ in range(3))
    if random.random() < 0.2:
        frame = r * random.uniform(0.2, 0.6)
        rod = rocker = r * random.uniform(1.5, 2)
    data["frame"]["C"] = [mm(frame), random.choice((0, "10 mm"))]
    data["links"] |= {"2": {"points": {"A": 0, "B": mm(rod)}}, "3": {"points": {"C": 0, "B": mm(rocker)}}}
    data["assembly"] = {
        "B": random.choice(("left of A-C", "right of A-C", "left of A-C", "right of A-C", "+"))
    }
    return data, {}


def six_bar(random: Random) -> tuple[Data, Data]:
    """A slider behind a crank and rocker."""
    data, _ = four_bar(random)
    reach = float(data["links"]["3"]["points"]["B"].split()[0])
    x = float(data["frame"]["C"][0].split()[0])
    data["frame"]["Q"] = [mm(x), mm(reach * random.uniform(1.2, 1.6))]
    data["guides"] = {"x": {"through": "Q"}}
    data["links"]["3"]["points"]["D"] = mm(reach * random.uniform(1.1, 1.5))
    data["links"] |= {"4": {"points": {"D": 0, "E": mm(3 * reach)}}, "5": {"points": ["E"], "slides": "x"}}
    data["assembly"]["E"] = random.choice(LEVEL)
    return data, {"E": LEVEL}


def quick_return(random: Random) -> tuple[Data, Data]:
    """A slotted lever, swinging or turning round, with a ram or without."""
    r, data = crank(random)
    below = r * random.uniform(1.6, 3) if random.random() < 0.7 else r * random.uniform(0.2, 0.7)
    reach = (r + below) * random.uniform(1.1, 1.6)
    data["frame"]["C"] = [0, mm(-below)]
    data["guides"] = {"k": {"through": "C", "link": 3}}
    data["links"] |= {"2": {"points": ["A"], "slides": "k"}, "3": {"points": {"C": 0, "D": mm(reach)}}}
    data["assembly"] = {"2-3": "+"}
    if random.random() < 0.3:
        return data, {}
    data["frame"]["Q"] = [0, mm(reach * random.uniform(0.9, 1.1) - below)]
    data["guides"]["x"] = {"through": "Q"}
    data["links"] |= {"4": {"points": {"D": 0, "E": mm(reach * 2.5)}}, "5": {"points": ["E"], "slides": "x"}}
    data["assembly"]["E"] = random.choice(LEVEL)
    return data, {"E": LEVEL}


def scotch_yoke(random: Random) -> tuple[Data, Data]:
    r, data = crank(random)
    data["guides"] = {"x": {"through": "O"}, "s": {"through": "E", "angle": "90 deg", "link": 3}}
    data["links"] |= {
        "2": {"points": ["A"], "slides": random.choice(("s", {"guide": "s", "angle": "90 deg"}))},
        "3": {
            "points": {"E": 0, "D": mm(3 * r)},
            "slides": random.choice(("x", ["x"], {"guide": "x", "at": "E"}, [{"guide": "x"}])),
        },
    }
    return data, {"D": LEVEL}


def trammel(random: Random) -> tuple[Data, Data]:
    """Over part of a turn."""
    r, data = crank(random)
    data["guides"] = {"x": {"through": ["O", "P"]}}
    data["frame"]["P"] = ["200 mm", 0]
    data["links"] |= {
        "2": {"points": {"A": 0, "B": mm(r), "M": mm(-1.4 * r)}},
        "3": {"points": ["B"], "slides": "x"},
    }
    data["driver"] |= {"zero": {"angle": "-60 deg"}, "range": "120 deg"}
    data["assembly"] = {"2-3": "right"}
    return data, {"B": LEVEL}


def tangent(random: Random) -> tuple[Data, Data]:
    """A slot on the driving link moves a rod."""
    far = random.uniform(60, 100)
    return {
        "frame": {"O": [0, 0], "P": [mm(far), 0]},
        "guides": {"y": {"through": "P", "angle": "90 deg"}, "k": {"through": "O", "link": 1}},
        "links": {
            "1": {"points": {"O": 0, "A": mm(1.5 * far)}},
            "2": {"points": ["B"], "slides": "k"},
            "3": {"points": {"B": 0, "D": [0, "60 mm"]}, "slides": {"guide": "y", "angle": "90 deg"}},
        },
        "driver": {"link": 1, "zero": {"angle": "-35 deg"}, "range": "75 deg"},
    }, {"B": UPRIGHT}


def cam(random: Random) -> tuple[Data, Data]:
    """A follower that slides or swings, with an edge, a roller or a face, by a law, a table or a profile."""
    base, face = random.uniform(35, 60), random.random() < 0.35
    swings = random.random() < 0.5
    data: Data = {
        "frame": {"O": [0, 0], "Q": ["0 mm", 0]},
        "links": {"1": {"points": {"O": 0}}},
        "driver": {"link": 1},
    }
    one: Data = {"follower": 2}
    if face:
        one["flat"] = {"at": "B"} | (
            {"angle": random.choice(("90 deg", "0 deg"))} if random.random() < 0.2 else {}
        )
    else:
        one["roller"] = {"at": "B"} | ({"radius": mm(random.uniform(5, 15))} if random.random() < 0.8 else {})
    if swings:
        data["frame"]["C"] = ["140 mm", "10 mm"]
        data["links"]["2"] = {"points": {"C": 0, "B": mm(random.uniform(120, 145))}}
        one["side"] = random.choice(LEVEL)
    else:
        data["guides"] = {"y": {"through": random.choice(("O", "Q", ["0 mm", "0 mm"])), "angle": "90 deg"}}
        data["links"]["2"] = {
            "points": {"B": 0, "D": mm(80)},
            "slides": random.choice(("y", {"guide": "y", "angle": "0 deg"})),
        }
    data["cams"] = {"k": one}
    _law(one, swings, base, random)
    if one.get("base") == "smallest" and face and random.random() < 0.8:
        one["least_curvature"] = "4 mm"
    for key, value in (
        ("cam", "1"),
        ("start", "30 deg"),
        ("centre", "W"),
        ("pressure_angle_limit", "35 deg"),
    ):
        if random.random() < 0.2 and (key != "start" or "profile" not in one):
            one[key] = value
    return data, {} if swings else {"B": UPRIGHT}


def cam_alone(random: Random) -> Data:
    """The block `cam`: as a sheet states it."""
    base, end = random.uniform(35, 60), random.choice(("roller", "roller", "knife", "flat"))
    swings = random.random() < 0.45
    one: Data = {"follower": end}
    if end == "roller":
        one["roller"] = mm(random.uniform(5, 15))
        if random.random() < 0.5:
            del one["follower"]
        if random.random() < 0.3:
            one["shaft"] = "20 mm"
    _law(one, swings, base, random)
    if one.get("base") == "smallest" and end == "flat" and random.random() < 0.8:
        one["least_curvature"] = "4 mm"
    if "phases" in one:
        _divided(one["phases"], random)
        if "base" in one and one["base"] != "smallest" and random.random() < 0.3:
            one["pitch_base"] = one.pop("base")
        if "roller" in one and one.get("base", "smallest") == "smallest" and random.random() < 0.3:
            one["roller"] = "chosen"
    if swings:
        free = one.get("base") == "smallest" and end != "flat" and random.random() < 0.5
        one["centre_distance"] = "free" if free else mm(random.uniform(130, 150))
        one["side"] = random.choice(("against", "with"))
        if end != "flat" or random.random() < 0.1:
            one["arm"] = mm(random.uniform(115, 135))
        elif random.random() < 0.3:
            one["face_offset"] = mm(random.choice((-6, 5, 12)))
    elif random.random() < 0.6 and "profile" not in one:
        free = one.get("base") == "smallest" and end != "flat"
        one["offset"] = "free" if free and random.random() < 0.5 else mm(random.choice((-8, 6, 12)))
        if random.random() < 0.4 and not one["offset"].startswith(("-", "free")):
            one["side"] = random.choice(("against", "with", "left", "right"))
    if end == "roller" and random.random() < 0.4:
        one |= {"closure": "groove"} if random.random() < 0.5 else {"cutter": "3 mm"}
    for key, value in (
        ("rotation", random.choice(("clockwise", "counter-clockwise"))),
        ("speed", f"{random.randint(60, 400)} rpm"),
        ("positions", random.choice((12, 24, 36, 17))),
        ("pressure_angle_limit", "35 deg"),
    ):
        if random.random() < 0.5:
            one[key] = value
    if random.random() < 0.6:
        loaded(one, swings, end, random)
    return one


def _divided(phases: list[Data], random: Random) -> None:
    """Dwells that are the rest, or none at all; phases by equal parts."""
    kind = random.random()
    if kind < 0.3:
        phases[-1]["dwell"] = "rest"
    elif kind < 0.5:
        phases[1]["dwell"] = phases[3]["dwell"] = "equal"
    elif kind < 0.7:
        phases[0]["rise"] = phases[2]["return"] = "180 deg"
        phases[1]["dwell"], phases[3]["dwell"] = "0 deg", 0
    for phase in phases:
        if random.random() < 0.3:
            phase["divisions"] = random.choice((1, 6, 8))


def _law(one: Data, swings: bool, base: float, random: Random) -> None:
    kind = random.choice(("phases", "phases", "table", "profile"))
    turned = [30 * k for k in range(13)]
    if kind == "profile":
        away = base / 4
        tip = {"base": mm(base), "nose": mm(base / 3), "lift": mm(base / 3)}
        shapes: tuple[Data, ...] = (
            {"tangent": tip},
            {"tangent": {"base": mm(base), "nose": mm(base / 3), "half_angle": "50 deg"}},
            {"tangent": {"base": mm(base), "nose": mm(base / 3), "distance": mm(base)}},
            {"arcs": tip | {"flank": mm(4 * base)}},
            {"arcs": {"base": mm(base), "nose": mm(base / 3), "distance": mm(base), "flank": mm(4 * base)}},
            {"arcs": tip | {"half_angle": "70 deg"}},
            {"circle": {"radius": mm(base), "at": [mm(away), 0]}},
            {"polar": [[f"{t} deg", mm(base + away * math.sin(math.radians(t)) ** 2)] for t in turned[:-1]]},
            {
                "points": [
                    [mm(base * math.cos(math.radians(t)) + away), mm(base * math.sin(math.radians(t)))]
                    for t in turned[:-1]
                ]
            },
        )
        one["profile"] = random.choice(shapes)
        return
    one["base"] = "smallest" if random.random() < 0.15 else mm(base)
    if one["base"] == "smallest" and random.random() < 0.5:
        one |= {"round": "1 mm", "return_angle_limit": "45 deg"}
    high = random.uniform(5, 15)
    if kind == "phases":
        one["swing" if swings else "lift"] = f"{high:.4g} deg" if swings else mm(high)
        rise, back = {"rise": "110 deg"}, {"return": "110 deg"}
        for phase in (rise, back):
            if random.random() < 0.2:
                phase["acceleration"] = graph(random)
            elif random.random() < 0.1:
                heights = [round(10 - 10 * math.cos(math.pi * k / 6), 1) for k in range(7)]
                phase["displacement"] = heights if phase is rise else heights[::-1]
            elif random.random() < 0.98:
                phase["law"] = random.choice(LAWS)
        one["phases"] = [rise, {"dwell": "50 deg"}, back, {"dwell": "90 deg"}]
        return
    heights = [high * (1 - math.cos(math.radians(t))) / 2 for t in turned]
    unit = "deg" if swings else "mm"
    one["swings" if swings else "lifts"] = [
        [f"{t} deg", f"{h:.6g} {unit}"] for t, h in zip(turned, heights, strict=True)
    ]


def graph(random: Random) -> list[Any]:
    """Of acceleration, to any scale: ordinates, or pieces."""
    if random.random() < 0.5:
        return [0, round(random.uniform(0.5, 3), 2), 1, 0, -1, round(-random.uniform(0.5, 3), 2), 0]
    return [
        {"width": 1, "sine": [0, 2]},
        {"width": round(random.uniform(0.3, 3), 2), "constant": 2},
        {"line": [2, round(-random.uniform(0.5, 3), 2)]},
        {"width": 2, "sine": [-1, 0]},
    ]


SCHEMES: tuple[Callable[[Random], tuple[Data, Data]], ...] = (
    slider_crank,
    slider_crank,
    two_sliders,
    four_bar,
    six_bar,
    quick_return,
    scotch_yoke,
    trammel,
    tangent,
    cam,
    cam,
    alone,
    coupled_cranks,
    racked_slider,
    planet_on_crank,
    sun_and_planet,
    rolling_wheel,
    pushed_crank,
    lifted_boom,
    *SYNTHESES,
)


# ---------------------------------------------------------------- masses, drive, names


def mechanism(walk: Walk) -> tuple[Data, Names]:
    """A mechanism with what its keys leave open, the synthesis that it takes lengths of under `synthesis`, and its
    names. The walk takes them over."""
    random = walk.random
    data, axes = random.choice(SCHEMES)(random)
    for name, link in data["links"].items():
        _massive(name, link, walk)
    driver = walk.part("DriverModel")
    if "stroke" in data["driver"]:
        driver = {}
    for key in ("link", "slider", "cylinder", "stroke", "range", "zero", "gear", "turns"):
        kept = driver.pop(key, None)
        if kept is not None and key == "turns" and "range" not in data["driver"]:
            driver["turns"] = random.randint(1, 4) if random.random() < 0.3 else 2
        if kept is not None and key == "gear" and "range" not in data["driver"]:
            driver["gear"] = kept
        if kept is not None and key == "zero" and "zero" not in data["driver"]:
            driver["zero"] = _zero(data, axes, random)
        if kept is not None and key == "range" and "turns" not in driver and random.random() < 0.4:
            driver["range"] = _angle(random.uniform(30, 300), "synthesis.crank_way")
    if "law" in driver:
        driver = _by_law(driver, data, random)
    data["driver"] = driver | data["driver"]
    if driver.get("turns", 1) > 1:
        data["driver"].pop("range", None)
    if random.random() < 0.1 * walk.fullness and "assembly" in data and "B" in data["assembly"]:
        data["sketch"] = {"A": [0, "50 mm"], "B": ["200 mm", "50 mm"]}
        data.pop("assembly", None)
    names = _names(data, axes)
    law = data["driver"].get("law", {})
    ends = law.get("angles", [["", "0 deg"]])[-1][1]
    goes_on = "stroke" in data["driver"] and not {"harmonic", "phases"} & set(data["driver"]["stroke"])
    open_ended = goes_on or "acceleration" in law or "polynomial" in law or ends == "140 deg"
    names.turns, names.partial = data["driver"].get("turns", 1), "range" in data["driver"] or open_ended
    return data, names


def _by_law(driver: Data, data: Data, random: Random) -> Data:
    """A law in place of a speed, and of what it says itself; a cam or a part of a turn has none."""
    if "cams" in data or "range" in data["driver"] or random.random() < 0.1:
        return {key: one for key, one in driver.items() if key != "law"} | {"speed": "90 rpm"}
    return {"law": driver["law"]}


def _massive(name: str, link: Data, walk: Walk) -> None:
    """A mass, its centre and an inertia, at points that the link has or at one more."""
    random, made = walk.random, walk.part("LinkModel")
    if isinstance(link["points"], dict) and random.random() < 0.5:
        points = list(link["points"])
        way = random.random()
        plain = not any("synthesis" in str(place) for place in link["points"].values())
        if way < 0.2 and len(points) > 1 and plain:
            link["points"][f"S{name}"] = {
                "from": {points[0]: "200 mm", points[1]: "200 mm"},
                "side": random.choice(LEVEL),
            }
        else:
            link["points"][f"S{name}"] = ["20 mm", "-5 mm"] if way < 0.6 else "25 mm"
    points = list(link["points"])
    if "mass" in made:
        link |= {"mass": made["mass"], "mass_centre": random.choice(points)}
    if "inertia" in made and "mass" in made:
        link["inertia"] = f"{random.uniform(0.001, 0.01):.3g} kg*m^2"
        if isinstance(made["inertia"], dict):
            link["inertia"] = {"value": "0.9 kg*m^2", "about": random.choice(points)}


def _angle(degrees: float, found: str) -> Any:
    """As text, as a bare number, rarely as what a synthesis finds; what is drawn after it does not change with it."""
    form = round(degrees * 997) % 24
    return found if form == 0 else round(math.radians(degrees), 3) if form % 5 == 1 else f"{degrees:.4g} deg"


def _zero(data: Data, axes: Data, random: Random) -> Data:
    pivoted = [
        n for n, link in data["links"].items() if n != "1" and set(link["points"]) & set(data["frame"])
    ]
    ways: list[Data] = [{"angle": _angle(random.randint(-180, 180), "synthesis.crank_angle")}]
    ways += [{"point": point, "extreme": random.choice(way)} for point, way in axes.items()]
    ways += [{"link": link, "extreme": random.choice(("clockwise", "counter-clockwise"))} for link in pivoted]
    return random.choice(ways)


def _names(data: Data, axes: Data) -> Names:
    links = data["links"]
    shared = {
        p: [n for n in ("0", *links) if p in (data["frame"] if n == "0" else links[n]["points"])]
        for p in {p for link in links.values() for p in link["points"]}
    }
    points, guides = sorted(shared), sorted(data.get("guides", {}))
    pivots = {p: n for p, n in sorted(shared.items()) if len(n) > 1}
    free = [p for p in points if p not in data["frame"]]
    moving = sorted(links)
    of = {
        "at": points,
        "free": free,
        "on": moving,
        "link": moving,
        "points": points,
        "links": moving,
        "guide": guides,
        "slider": moving,
        "pivot": sorted(pivots),
        "pivots": pivots,
        "journal": moving,
        "bushing": moving,
        "joints": [*pivots, *guides],
        "counterweights": moving,
        "stated": moving,
        "about": sorted(data["frame"]),
        "point": points,
        "follower": moving,
        "pivoted": ["1", *(n for n in moving if n != "1" and set(links[n]["points"]) & set(data["frame"]))],
    }
    return Names(of, axes)
