"""Names of the links of a lever mechanism by how they move: crank, rocker, slider, connecting rod and others."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmm_report.chapters.lever.structure.solve import Structure
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_


class LinkName(NamedTuple):
    """Message ids."""

    name: str
    motion: str


FIXED = LinkName(N_("frame"), N_("fixed"))
ROTATION, ROCKING, TRANSLATION, PLANE = N_("rotation"), N_("rocking"), N_("translation"), N_("plane motion")


def link_name(found: Structure, motion: Motion, link: str) -> LinkName:
    """A link's name by its `motion` over the cycle, and that motion."""
    if link == FRAME:
        return FIXED
    pairs, driver = found.pairs, found.linkage.mechanism.driver
    carries = any(p.kind == "P" and p.slider != link and link in p.links for p in pairs)
    slides = [p.other(link) for p in pairs if p.kind == "P" and p.slider == link]
    pivoted = any(p.kind == "R" and FRAME in p.links and link in p.links for p in pairs)
    turning = ROTATION if _makes_turns(motion, link) else ROCKING
    free = _free_motion(motion, link, float(driver.omega))
    if any(link == cam.cam for cam in found.linkage.mechanism.cams):
        return LinkName(N_("cam"), turning)
    if driver.stroke is not None and (name := _by_stroke(driver.stroke, link, turning)) is not None:
        return LinkName(name, TRANSLATION if FRAME in slides else free if slides else turning)
    if link == driver.link:
        return LinkName(N_("crank") if turning == ROTATION else N_("driving rocker"), turning)
    if (wheel := _wheel(found, link, bool(FRAME in slides))) is not None:
        return LinkName(wheel, TRANSLATION if FRAME in slides else turning if pivoted else free)
    if FRAME in slides:
        return LinkName(N_("translating slotted link") if carries else N_("slider"), TRANSLATION)
    if _is_ternary(found, link) and not pivoted:
        return LinkName(N_("ternary link"), free)
    if pivoted and carries:
        return LinkName(N_("slotted link"), turning)
    if pivoted:
        name = N_("rocking block") if slides else N_("rocker")
        return LinkName(name if turning == ROCKING or slides else N_("driven crank"), turning)
    if slides:
        return LinkName(N_("block of the slotted link"), free)
    return LinkName(N_("slotted connecting rod") if carries else N_("connecting rod"), free)


def _by_stroke(stroke: Stroke, link: str, turning: str) -> str | None:
    """Of a driving slider, of both links of a cylinder and of the link that follows the stroke."""
    if link == stroke.link:
        return N_("driven crank") if turning == ROTATION else N_("rocker")
    if stroke.slides:
        return N_("driving slider") if link in stroke.by else None
    if link not in stroke.by:
        return None
    sign = next(one.sign for one in stroke.takes if one.link == link)
    return N_("rod of the cylinder") if sign > 0 else N_("barrel of the cylinder")


def _wheel(found: Structure, link: str, slides: bool) -> str | None:
    """Of a link that is a rack, or a gear and nothing else."""
    mechanism = found.linkage.mechanism
    meshes = [mesh for mesh in mechanism.meshes if link in mesh.links]
    if not meshes:
        return None
    moved = next((one for one in found.linkage.structure.coupled if one.link == link), None)
    if moved is not None and moved.bearing.links[0] != FRAME:  # its axis moves
        return N_("rolling wheel") if moved.mesh.rolls else N_("planet gear")
    if slides:
        return N_("slider with a rack")
    joints = [p for p in mechanism.links[link].points if len(mechanism.links_at(p)) > 1]
    return N_("gear") if len(joints) == 1 else None


def _is_ternary(found: Structure, link: str) -> bool:
    """Whether the link is one of those with three or more pairs in a group above class II."""
    higher = any(link in g.links and g.group_class > 2 for g in found.groups)
    return higher and sum(link in pair.links for pair in found.pairs) > 2


def _free_motion(motion: Motion, link: str, omega: float) -> str:
    rate = motion.angular_velocity(link)
    return PLANE if np.any(np.abs(rate) > 1e-9 * abs(omega)) else TRANSLATION


def _makes_turns(motion: Motion, link: str) -> bool:
    turn = np.unwrap(np.angle(motion.turn(link)))
    return bool(abs(turn[-1] - turn[0]) > 2 * np.pi - 1e-6)
