"""What is drawn of the balancing of a mechanism, made to go together."""

from __future__ import annotations

from typing import Any

Made = dict[str, Any]


def made_right(made: Made, walk: Any) -> Made:
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
