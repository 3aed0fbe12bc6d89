"""What looks odd in a spur stage as it is stated."""

from collections.abc import Iterator

from tmm_report.chapters.gears.spur.given import Spur
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.yamlread import Path


def doubts(stated: Spur, path: Path) -> Iterator[Problem]:
    """A ratio without a sign, as collections print it of external pairs too; teeth of which either pair can be made."""
    if stated.by_teeth:
        if stated.mesh is None and stated.centre_distance is None and len({*(stated.teeth or ())}) > 1:
            text = N_("is the pair external or internal? Without a ratio it is taken as an external one")
            yield doubt(text, (*path, "teeth"), Message(N_("write mesh: external, or mesh: internal")))
        return
    if stated.mesh is None and stated.ratio > 0:
        text = N_(
            "is the pair external or internal? A ratio of %(ratio)s without a minus is of an internal one"
        )
        right = Message(
            N_("write ratio: -%(ratio)s for an external pair, or mesh: internal"),
            {"ratio": f"{stated.ratio:g}"},
        )
        yield doubt(text, (*path, "ratio"), right, ratio=f"{stated.ratio:g}")
