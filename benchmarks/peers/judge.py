"""Errors of what a peer has found, and its time beside ours for the same work."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused, run_name
from benchmarks.peers.scene import KINDS, Scene
from benchmarks.peers.turns import in_turns

PREFIXES = {"position": "", "velocity": "v_", "acceleration": "a_"}
QUICK = 0.03  # s: rivals quicker than this take many turns with ours, the others few
ROUNDS = (60, 5)


@dataclass(frozen=True)
class Row:
    """A run of a peer with one of its settings. `errors`: kind -> relative error, None where it is not offered;
    `ratio`: its time to ours for the same kinds; `refused`: its own words, where it found nothing."""

    peer: str
    setting: str
    errors: Mapping[str, float | None]
    ratio: float = float("nan")
    refused: str = ""

    @property
    def name(self) -> str:
        return f"{self.peer}, {self.setting}" if self.setting else self.peer


def keys_of(kind: str, scene: Scene) -> list[str]:
    return ["moment"] if kind == "moment" else [PREFIXES[kind] + point for point in scene.points]


def errors(found: Found, exact: Mapping[str, Array], scene: Scene) -> dict[str, float | None]:
    """Largest error of any point at any position, relative to the largest exact value of that point; nan where a value
    is missing, None where the kind is not offered."""
    return {kind: _error(found, exact, keys_of(kind, scene)) for kind in KINDS}


def _error(found: Found, exact: Mapping[str, Array], keys: list[str]) -> float | None:
    if any(key not in found for key in keys):
        return None
    off = [np.max(np.abs(found[key] - exact[key])) / np.max(np.abs(exact[key])) for key in keys]
    return float(max(off))


def measured(
    peers: Mapping[str, Peer],
    scene: Scene,
    phi: Array,
    exact: Mapping[str, Array],
    rounds: tuple[int, int] = ROUNDS,
) -> list[Row]:
    """Every peer with every setting; those that refuse are rows without a time."""
    calls, rows = {}, []
    for peer in peers.values():
        for setting, chosen in peer.settings.items():
            try:
                call = peer.prepare(scene, phi, **chosen)
                rows.append(Row(peer.key, setting, errors(call(), exact, scene)))
                calls[run_name(peer, setting)] = call
            except Refused as refusal:
                rows.append(Row(peer.key, setting, dict.fromkeys(KINDS), refused=str(refusal)))
    ratios = _ratios(calls, {row.name: row.errors["moment"] is not None for row in rows}, rounds)
    return [Row(r.peer, r.setting, r.errors, ratios.get(r.name, float("nan")), r.refused) for r in rows]


def _before(ours: Mapping[str, Call], warm: Mapping[str, Call]) -> dict[str, Call]:
    """Each of ours after a call of it that does not count."""
    return dict(pair for both in zip(warm.items(), ours.items(), strict=True) for pair in both)


def _ratios(calls: dict[str, Call], forces: Mapping[str, bool], rounds: tuple[int, int]) -> dict[str, float]:
    """Times to ours of the same work; the quick take turns with ours, and then the slow do."""
    once = in_turns(calls, 1)
    ours = {name: calls[name] for name in calls if name.startswith("ours")}
    found: dict[str, float] = {}
    for quick, turns in zip((True, False), rounds, strict=True):
        rivals = {name: call for name, call in calls.items() if (once[name] < QUICK) == quick}
        warm = {
            f"{name}, to warm up": call for name, call in ours.items()
        }  # a slow rival leaves the caches cold
        taken = in_turns(_before(ours, warm) | rivals, turns)
        base = {forces[name]: taken[name] for name in ours}
        found |= {name: taken[name] / base[forces[name]] for name in rivals if forces[name] in base}
    return found
