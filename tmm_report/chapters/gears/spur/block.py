"""What looks odd in a spur stage as it is stated."""

from collections.abc import Iterator

from tmm_report.chapters.gears.spur.given import Spur
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.yamlread import Path


def doubts(stated: Spur, path: Path) -> Iterator[Problem]:
    """A ratio without a sign, as collections print it of external pairs too."""
    if stated.mesh is None and stated.ratio > 0:
        text = N_(
            "is the pair external or internal? A ratio of %(ratio)s without a minus is of an internal one"
        )
        right = Message(
            N_("write ratio: -%(ratio)s for an external pair, or mesh: internal"),
            {"ratio": f"{stated.ratio:g}"},
        )
        yield doubt(text, (*path, "ratio"), right, ratio=f"{stated.ratio:g}")
