"""The peers on any slider-crank or four-bar: places at given angles, or the peer's own refusal.

    from benchmarks.peers import scene, scenes
    scenes.solve("kinepy", scene.slider_crank(0.1, 0.1), scene.angles(scene.slider_crank(0.1, 0.1), 360, 0.01))

What a peer leaves as nan stays nan; what it raises is `Refused` with its words; anything else is its answer.
"""

from __future__ import annotations

import contextlib
import io
import warnings
from collections.abc import Iterator

import numpy as np

from benchmarks.peers import ours
from benchmarks.peers.peer import Array, Found, Peer, Refused
from benchmarks.peers.programs import (
    by_exudyn,
    by_kinepy,
    by_mechanism,
    by_mujoco,
    by_pinocchio,
    by_pylinkage,
)
from benchmarks.peers.scene import Scene

PEERS: dict[str, Peer] = {
    room.PEER.key: room.PEER
    for room in (ours, by_pylinkage, by_kinepy, by_mechanism, by_pinocchio, by_exudyn, by_mujoco)
}


def installed() -> tuple[str, ...]:
    return tuple(key for key, peer in PEERS.items() if peer.version())


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """What programs print, and numpy's warnings of nan that they leave, kept away from the tables."""
    with np.errstate(all="ignore"), warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        yield


def solve(key: str, scene: Scene, phi: Array, setting: str | None = None) -> Found:
    """What the peer finds at the angles, in its first setting unless another is named."""
    peer = PEERS[key]
    chosen = peer.settings[setting if setting is not None else next(iter(peer.settings))]
    with quiet():
        try:
            return peer.prepare(scene, phi, **chosen)()
        except Refused:
            raise
        except Exception as error:
            raise Refused(f"{type(error).__name__}: {error}") from error
