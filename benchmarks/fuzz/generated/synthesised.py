"""Mechanisms whose lengths a synthesis finds: the block and the links that take them."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

Data = dict[str, Any]
LEVEL = ("left", "right")


def slider_crank(random: Random) -> tuple[Data, Data]:
    asked: Data = {"stroke": f"{random.uniform(60, 400):.4g} mm"}
    if random.random() < 0.5:
        asked["K"] = f"{random.uniform(1.02, 1.25):.4g}"
    else:
        asked["ratio"] = f"{random.uniform(3, 6):.3g}"
    height = "synthesis.offset" if "K" in asked else 0
    return {
        "synthesis": {"slider_crank": asked},
        "frame": {"O": [0, 0], "Q": [0, height]},
        "guides": {"x": {"through": "Q"}},
        "links": {
            "1": {"points": {"O": 0, "A": "synthesis.crank"}},
            "2": {"points": {"A": 0, "B": "synthesis.rod"}},
            "3": {"points": ["B"], "slides": "x"},
        },
        "driver": {"link": 1},
        "assembly": {"B": random.choice(LEVEL)},
    }, {"B": LEVEL}


def crank_rocker(random: Random) -> tuple[Data, Data]:
    asked = {
        "swing": f"{random.uniform(20, 50):.4g} deg",
        "rocker": f"{random.uniform(200, 600):.4g} mm",
        "K": random.choice((1, f"{random.uniform(1.02, 1.2):.4g}")),
    }
    return {
        "synthesis": {"crank_rocker": asked},
        "frame": {"O": [0, 0], "C": ["synthesis.frame_x", "synthesis.frame_y"]},
        "links": {
            "1": {"points": {"O": 0, "A": "synthesis.crank"}},
            "2": {"points": {"A": 0, "B": "synthesis.rod"}},
            "3": {"points": {"C": 0, "B": "synthesis.rocker", "E": "1.2*l_CB"}},
        },
        "driver": {"link": 1},
        "assembly": {"B": random.choice(("left of A-C", "right of A-C"))},
    }, {}


def shaper(random: Random) -> tuple[Data, Data]:
    asked = {
        "stroke": f"{random.uniform(200, 500):.4g} mm",
        "K": f"{random.uniform(1.2, 1.8):.4g}",
        "frame": f"{random.uniform(300, 500):.4g} mm",
        "rod_ratio": f"{random.uniform(0.25, 0.5):.3g}",
    }
    return {
        "synthesis": {"slotted_link": asked},
        "frame": {"O": [0, "synthesis.frame"], "C": [0, 0], "Q": [0, "synthesis.slide_line"]},
        "guides": {"x": {"through": "Q"}, "k": {"through": "C", "link": 3}},
        "links": {
            "1": {"points": {"O": 0, "A": "synthesis.crank"}},
            "2": {"points": ["A"], "slides": "k"},
            "3": {"points": {"C": 0, "B": "synthesis.link"}},
            "4": {"points": {"B": 0, "D": "synthesis.rod"}},
            "5": {"points": ["D"], "slides": "x"},
        },
        "driver": {"link": 1},
        "assembly": {"2-3": "+", "D": random.choice(LEVEL)},
    }, {"D": LEVEL}


def dwelling(random: Random) -> tuple[Data, Data]:
    """Its slide goes in a direction that the synthesis finds."""
    side, away = f"{random.uniform(110, 140):.4g} mm", f"{random.uniform(100, 140):.4g} mm"
    frame = "100 mm"
    asked = {
        "crank": "50 mm", "coupler": side, "rocker": side, "frame": frame, "point": [away, away],
        "angles": ["140 deg", "180 deg", "220 deg"],
    }  # fmt: skip
    return {
        "synthesis": {"dwell": asked},
        "frame": {"O": [0, 0], "C": [frame, 0], "Q": ["synthesis.centre_x", "synthesis.centre_y"]},
        "guides": {"t": {"through": "Q", "angle": "synthesis.guide_angle"}},
        "links": {
            "1": {"points": {"O": 0, "A": "50 mm"}},
            "2": {"points": {"A": 0, "B": side, "P": [away, away]}},
            "3": {"points": {"C": 0, "B": side}},
            "4": {"points": {"P": 0, "D": "synthesis.radius"}},
            "5": {"points": ["D"], "slides": "t"},
        },
        "driver": {"link": 1},
        "assembly": {"B": "left of A-C", "D": "right"},
    }, {}


SYNTHESES: tuple[Callable[[Random], tuple[Data, Data]], ...] = (slider_crank, crank_rocker, shaper, dwelling)
