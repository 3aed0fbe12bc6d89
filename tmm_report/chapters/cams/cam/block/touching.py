"""Whether cam and follower touch all round: a cam that cannot be made raises Wrong with the key that is wrong."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.cams.cam.block.laws import Wrong
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.cams.cam import ByLaw, Cam
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.problems import N_, Message

GRID = 1441  # angles of a turn at which it is tried


def must_touch(made: Cam) -> None:
    """The follower touches its cam all round, and by law the profile has neither cusps nor hollows that it cannot."""
    phi = np.linspace(0, FULL_TURN, GRID)
    with np.errstate(invalid="ignore", divide="ignore"):
        q, b = made.moved(phi)
        radius, bad = made.touched(q, b).radius, ~np.isfinite(q.z)
    if bad.any():
        key = "profile" if isinstance(made.given, ByProfile) else "swing"
        raise Wrong(key, Message(N_("the follower does not reach its cam all round")))
    if made.flat:
        _must_be_convex(made, radius)
    elif made.roller and isinstance(made.given, ByLaw):
        convex = radius[radius > 0]
        if convex.size and (least := float(convex.min())) <= made.roller:
            text = N_(
                "the profile is undercut: the pitch curve's radius of curvature falls to %(least)s m, and the "
                "roller's is %(roller)s m"
            )
            right = N_("a larger base circle, a smaller roller, a longer phase or a smoother law")
            values = {"least": f"{least:.4g}", "roller": f"{made.roller:.4g}"}
            raise Wrong("base", Message(text, values), Message(right))
    if not made.flat:
        _must_go_round(made, b.z * np.exp(-1j * phi))


def _must_be_convex(made: Cam, radius: np.ndarray) -> None:
    least = float(radius.min())
    if least <= 0:
        text = N_("a flat face needs a convex profile: its radius of curvature falls to %(least)s m")
        if isinstance(made.given, ByProfile):
            raise Wrong("profile", Message(text, {"least": f"{least:.4g}"}))
        right = N_("a base circle larger by %(more)s m or more, a longer phase or a smoother law")
        raise Wrong(
            "base", Message(text, {"least": f"{least:.4g}"}), Message(right, {"more": f"{-least:.4g}"})
        )


def _must_go_round(made: Cam, turned: np.ndarray) -> None:
    """The pitch curve goes once round the axis, always one way: else the follower swings through the cam's pivot."""
    rate = cross(turned[:-1], turned[1:])
    if np.any(rate >= 0):
        text = N_("the follower passes the cam's pivot: the profile does not go once round it")
        raise Wrong("base" if isinstance(made.given, ByLaw) else "profile", Message(text))
