"""Mechanisms by chance that a slider or a cylinder drives, and the laws of their strokes."""

from __future__ import annotations

from random import Random
from typing import Any

from benchmarks.fuzz.generated.driving import LAWS

Data = dict[str, Any]


def mm(length: float) -> str:
    return f"{length:.6g} mm"


def pushed_crank(random: Random) -> tuple[Data, Data]:
    """A slider that pushes a crank over a part of its turn."""
    crank, rod = random.uniform(100, 200), random.uniform(350, 500)
    low, high = rod - 0.6 * crank, rod + 0.6 * crank
    return {
        "frame": {"O": [0, 0], "Q": [0, mm(random.uniform(-40, 40))]},
        "guides": {"x": {"through": "Q"}},
        "links": {
            "1": {"points": {"O": 0, "A": mm(crank)}},
            "2": {"points": {"A": 0, "B": mm(rod)}},
            "3": {"points": ["B"], "slides": "x"},
        },
        "driver": {"slider": 3, "stroke": stroke(random, low, high)},
        "assembly": {"A": random.choice(("left of O-B", "right of O-B"))},
    }, {}


def lifted_boom(random: Random) -> tuple[Data, Data]:
    """A boom that a cylinder lifts, with a slider-crank on it at times."""
    boom, away = random.uniform(400, 600), random.uniform(500, 800)
    low, high = 0.7 * away, 0.95 * (boom + away) - 100
    data: Data = {
        "frame": {"O": [0, 0], "A": [mm(away), mm(random.uniform(-200, 0))]},
        "guides": {"axis": {"through": "A", "link": 1}},
        "links": {
            "1": {"points": {"A": 0}},
            "2": {"points": {"B": 0}, "slides": "axis"},
            "3": {"points": {"O": 0, "B": mm(boom)}},
        },
        "driver": {"cylinder": ["A", "B"], "stroke": stroke(random, low, high)},
        "assembly": {"B": "left of O-A"},
    }
    if random.random() < 0.4:
        data["guides"]["x"] = {"through": "O"}
        data["links"] |= {
            "4": {"points": {"B": 0, "D": mm(2.5 * boom)}},
            "5": {"points": ["D"], "slides": "x"},
        }
        data["assembly"]["D"] = "left"
    return data, {}


def stroke(random: Random, low: float, high: float) -> Data:
    """A law of the stroke between two places, mm."""
    middle, half = (low + high) / 2, (high - low) / 2
    way = random.choice((1, -1))
    start, end = middle - 0.8 * way * half, middle + 0.8 * way * half
    time = random.uniform(0.5, 3)
    speed = (end - start) / time
    match random.randrange(7):
        case 0:
            over: Data = {"to": mm(end)} if random.random() < 0.5 else {"time": f"{time:.4g} s"}
            return {"from": mm(start), "speed": f"{speed:.5g} mm/s", **over}
        case 1:
            grown = {"acceleration": f"{speed / time:.5g} mm/s^2", "time": f"{time:.4g} s"}
            return {"from": mm(start), "speed": f"{speed / 3:.5g} mm/s", **grown}
        case 2:
            parts = [[f"{time / 4:.4g} s", f"{1.6 * speed / time:.5g} mm/s^2"], [f"{time / 2:.4g} s", 0]]
            return {"from": mm(start), "accelerations": parts}
        case 3:
            sway = {"amplitude": mm(0.6 * half), "frequency": "5 rad/s"}
            if random.random() < 0.5:
                sway["phase"] = f"{random.randint(-90, 90)} deg"
            return {"from": mm(middle), "harmonic": sway}
        case 4:
            by_times = [round(0.7 * speed / 1000, 5), round(0.1 * speed / 1000 / time, 5)]
            return {"from": mm(start), "polynomial": by_times, "time": f"{time:.4g} s"}
        case 5:
            places = (0, 0.2, 0.6, 0.9, 1)
            pairs = [[f"{part * time:.4g} s", mm(start + part * (end - start))] for part in places]
            return {"lengths": pairs}
    phases = [
        {"rise": "150 deg", "law": random.choice(LAWS)},
        {"return": "210 deg", "law": random.choice(LAWS)},
    ]
    return {"from": mm(low + 0.1 * half), "phases": phases, "rise": mm(1.6 * half), "time": f"{time:.4g} s"}
