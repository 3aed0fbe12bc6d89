"""Laws by chance of a driving link that does not turn uniformly."""

from __future__ import annotations

from typing import Any

Made = Any
LAWS = (
    "parabolic",
    "decreasing",
    "cosine",
    "sine",
    "trapezoid",
    "modified_trapezoid",
    "modified_sine",
    "polynomial",
)


def law(made: Made, walk: Any) -> Made:
    """What a law of the driving link needs beside its kind, and nothing that it does not."""
    random = walk.random
    keys = {
        "acceleration": ("angle", "speed", "acceleration", "time"),
        "harmonic": ("angle", "speed", "harmonic"),
        "polynomial": ("angle", "polynomial", "time"),
        "angles": ("angles",),
        "phases": ("angle", "phases", "swing", "time"),
    }
    kind = next((kind for kind in keys if kind in made), None)
    if kind is None:
        return made
    made = {key: one for key, one in made.items() if key in keys[kind]}
    if kind in ("polynomial", "phases"):
        made.setdefault("time", "1.5 s")
    if kind == "polynomial":
        made["polynomial"] = [round(random.uniform(0.5, 3), 3), round(random.uniform(-1, 1), 3)]
    if kind == "acceleration":
        made |= {
            "speed": f"{random.uniform(3, 9):.3g} rad/s",
            "acceleration": f"{random.uniform(0.2, 4):.3g} rad/s^2",
        }
        if "time" in made:
            made["time"] = f"{random.uniform(0.2, 0.7):.3g} s"
    if kind == "harmonic":
        speed = random.choice((0, 5, 12, -7))
        made["speed"] = f"{speed} rad/s"
        made["harmonic"] = made["harmonic"] | {
            "amplitude": f"{random.uniform(3, 20):.3g} deg",
            "frequency": f"{abs(speed) * random.randint(1, 3) or 6} rad/s",
        }
        if speed and random.random() < 0.3:
            made["harmonic"].pop("frequency")
    if kind == "angles":
        ends = random.choice((360, 0, 140))
        made["angles"] = [
            ["0 s", "0 deg"],
            ["0.3 s", "40 deg"],
            ["0.7 s", "90 deg"],
            ["1.1 s", f"{ends} deg"],
        ]
    if kind == "phases":
        made |= {
            "phases": [
                {"rise": "150 deg", "law": random.choice(LAWS)},
                {"dwell": "60 deg"},
                {"return": "150 deg", "law": random.choice(LAWS)},
            ],
            "swing": "40 deg",
        }
    return made
