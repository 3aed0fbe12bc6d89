"""What the ordinary stages of a drive state; none has teeth whose shape is found."""

from __future__ import annotations

from tmm_report.chapters.gears.ordinary.crossing import BevelStage, WormStage
from tmm_report.chapters.gears.ordinary.parallel import (
    DRAWN,
    STANDARD,
    BeltStage,
    ChainStage,
    FrictionStage,
    Ordinary,
    PairStage,
    TrainStage,
)

__all__ = [
    "DRAWN",
    "STANDARD",
    "BeltStage",
    "BevelStage",
    "ChainStage",
    "FrictionStage",
    "Given",
    "Ordinary",
    "PairStage",
    "TrainStage",
    "WormStage",
]

Given = PairStage | BeltStage | ChainStage | FrictionStage | TrainStage | BevelStage | WormStage
