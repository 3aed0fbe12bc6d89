"""What a peer is to the benchmark: a program that finds a scene's motion, called as all the others are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import metadata
from typing import Any

Array = Any
Found = dict[
    str, Array
]  # "B", "v_B", "a_B" (P,) complex; "moment" (P,); a kind that is not offered is missing
Call = Callable[[], Found]


class Refused(Exception):
    """The peer says that it cannot: an exception of its own, a message, nan. The text is the peer's."""


@dataclass(frozen=True)
class Peer:
    """`prepare(scene, phi, **setting)` builds the model and gives the call that is timed; it returns what is found at
    the angles `phi`, equal steps the way the crank turns. `settings`: title -> what the accuracy depends on; the first
    is the one to take where one is enough. `missing`: what is not offered, in words."""

    key: str
    package: str
    prepare: Callable[..., Call]
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=lambda: {"": {}})
    missing: str = ""

    def version(self) -> str | None:
        return installed(self.package)


def installed(package: str) -> str | None:
    """The version of a distribution, None where it is not installed."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def run_name(peer: Peer, setting: str) -> str:
    return f"{peer.key}, {setting}" if setting else peer.key
