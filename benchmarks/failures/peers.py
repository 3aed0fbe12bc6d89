"""Other programs on the failing scenes: JSON of scenes in, JSON of what they find out. Run where they are installed."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from typing import Any

import numpy as np

from benchmarks.peers import scene as made
from benchmarks.peers import scenes


def main() -> None:
    asked = json.load(sys.stdin)
    found = {
        peer: {key: _found(peer, one["peer"], np.array(one["phi"])) for key, one in asked.items()}
        for peer in scenes.installed()
        if peer != "ours"
    }
    print(json.dumps(found))


def _found(peer: str, what: list[Any], phi: Any) -> dict[str, Any]:
    kind, *numbers = what
    build = made.slider_crank if kind == "slider" else made.four_bar
    scene = replace(build(*numbers), omega=10.0)
    try:
        got = scenes.solve(peer, scene, phi)
    except scenes.Refused as error:
        return {"refused": str(error)[:120]}
    return {
        name: [[float(z.real), float(z.imag)] for z in np.asarray(values, dtype=complex)]
        for name, values in got.items()
        if name in ("B", "v_B", "a_B")
    }


if __name__ == "__main__":
    main()
