"""Reversed motion: the follower found back from the profile alone, and profiles that are wrong by a known amount."""

import tracemalloc
from random import Random

import numpy as np
import pytest

from tmm_report import loading
from tmm_report.chapters.cams.cam.block.alone import CamAloneModel
from tmm_report.chapters.cams.cam.block.build import built
from tmm_report.chapters.cams.cam.block.laws import Wrong
from tmm_report.mechanics.cams.cam import Cam, Sliding
from tmm_report.mechanics.cams.reversed_motion import recovered, touching
from tmm_report.mechanics.cams.stated_profile import ByProfile, Polar

SMOOTH = (
    "parabolic", "decreasing", "cosine", "sine", "trapezoid", "modified_trapezoid", "modified_sine", "polynomial",
    "polynomial_4567",
)  # fmt: skip
KINDS = [(end, swings) for end in ("roller", "knife", "flat") for swings in (False, True)]


def drawn(random: Random, end: str, swings: bool) -> Cam | None:
    """A random cam; None of one that cannot be made."""
    rise, back, dwell = (random.uniform(60, 150) for _ in range(3))
    one: dict = {
        "follower": end,
        "base": f"{random.uniform(30, 80):.4f} mm",
        "phases": [
            {"rise": f"{rise:.5f} deg", "law": random.choice(SMOOTH)},
            {"dwell": f"{min(dwell, 350 - rise - back) / 2:.5f} deg"},
            {"return": f"{back:.5f} deg", "law": random.choice(SMOOTH)},
            {"dwell": "rest"},
        ],
        "rotation": random.choice(("clockwise", "counter-clockwise")),
    }
    if end == "roller":
        one["roller"] = f"{random.uniform(4, 18):.4f} mm"
    if swings:
        one |= {
            "swing": f"{random.uniform(4, 22):.4f} deg",
            "centre_distance": f"{random.uniform(120, 170):.4f} mm",
            "side": random.choice(("against", "with")),
        }
        one |= {"face_offset": f"{random.uniform(-8, 12):.3f} mm"} if end == "flat" else {
            "arm": f"{random.uniform(100, 140):.4f} mm"
        }  # fmt: skip
    else:
        one |= {"lift": f"{random.uniform(5, 30):.4f} mm", "offset": f"{random.uniform(-15, 15):.4f} mm"}
    try:
        return built(
            CamAloneModel.model_validate(one)
        ).cam  # as the file's block is, without the file: 2000 times
    except Wrong:  # undercut, out of reach, not convex
        return None


def off(cam: Cam, phi: np.ndarray, found: np.ndarray) -> np.ndarray:
    side = 1 if isinstance(cam.motion, Sliding) else cam.motion.side
    difference = found - side * cam.moved(phi)[0].z
    return difference if isinstance(cam.motion, Sliding) else np.mod(difference + np.pi, 2 * np.pi) - np.pi


def worst(count: int, seed: str) -> dict[tuple[str, bool], list[float]]:
    """The greatest differences of so many cams of every follower."""
    random = Random(seed)
    found: dict = {kind: [] for kind in KINDS}
    for kind in KINDS:
        while len(found[kind]) < count:
            if (cam := drawn(random, *kind)) is not None:
                phi = random.uniform(0, 1) + np.linspace(0, 2 * np.pi, 25)
                found[kind].append(float(np.abs(off(cam, phi, recovered(cam, phi))).max()))
    return found


def test_a_few_cams_of_every_follower():
    assert all(max(one) <= 1e-12 for one in worst(3, "few").values())


@pytest.mark.exhaustive
def test_two_thousand_random_cams_of_every_follower():
    found = worst(334, "many")
    assert sum(map(len, found.values())) >= 2000
    assert all(max(one) <= 1e-12 for one in found.values()), {kind: max(one) for kind, one in found.items()}


class Worn(Cam):
    """A profile that is a little larger than it should be: all its radii by one part in ten thousand."""

    def profile(self, phi):
        return super().profile(phi) * (1 + 1e-4)


@pytest.mark.parametrize(("end", "swings"), KINDS)
def test_a_wrong_profile_lifts_the_follower_by_what_it_is_wrong(end, swings):
    """The contact moves out along its normal by 1e-4 n·w, so that the follower is lifted by that over the cosine of the
    pressure angle, and over the arm of the contact's normal, of one that swings."""
    random = Random(f"worn {end} {swings}")
    cam = next(cam for _ in range(99) if (cam := drawn(random, end, swings)) is not None)
    worn = Worn(**{name: getattr(cam, name) for name in Cam.__dataclass_fields__})
    phi = np.linspace(0.1, 6.2, 40)
    touch = cam.contact(phi)
    out = 1e-4 * np.real(np.conj(touch.normal) * touch.at)
    _, b = cam.moved(phi)
    acts = touch.at if cam.flat else b.z
    if isinstance(cam.motion, Sliding):
        lifted = out / np.real(np.conj(touch.normal) * cam.motion.along)
    else:
        ahead = cam.motion.side * 1j * (acts - cam.motion.pivot)
        lifted = out / np.real(np.conj(touch.normal) * ahead)
    assert off(worn, phi, recovered(worn, phi)) == pytest.approx(lifted, rel=2e-2)


def test_a_hard_shock_asks_for_a_profile_that_cuts_itself():
    text = """cam: {roller: 10 mm, base: 40 mm, lift: 20 mm,
      phases: [{rise: 120 deg, law: uniform}, {dwell: 60 deg}, {return: 120 deg, law: uniform}, {dwell: rest}]}"""
    cam = loading.loads(text).cam.cam
    phi = np.radians(np.linspace(0, 359, 360))
    difference = off(cam, phi, recovered(cam, phi))
    assert difference.min() > -1e-12 and difference.max() > 1e-5
    far = (np.abs(np.degrees(phi) - 60) < 30) | (np.abs(np.degrees(phi) - 240) < 30)
    assert np.abs(difference[far]).max() < 1e-12


def test_many_angles_over_a_profile_of_points_take_little_memory():
    """All at once they would take half a megabyte each: the points of the profile, at every end of a bracket."""
    u = np.radians(np.arange(0.0, 360.0, 3.0))
    curve = Polar(tuple(u), tuple(0.04 + 0.006 * np.cos(u)))
    motion = Sliding(1j, 0j, 1 + 0j)
    cam = Cam("", "1", "2", "B", "K", 0j, motion, ByProfile(curve, motion, 9e-3), 9e-3, 0.5, 0.034)
    phi = np.linspace(0.0, 2 * np.pi, 600)
    tracemalloc.start()
    found = recovered(cam, phi)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert np.abs(off(cam, phi, found)).max() < 1e-12
    assert peak < 60e6


def test_a_point_that_the_roller_cannot_touch_is_none():
    text = """cam: {roller: 10 mm, base: 40 mm, lift: 20 mm,
      phases: [{rise: 120 deg, law: sine}, {dwell: 60 deg}, {return: 120 deg, law: sine}, {dwell: rest}]}"""
    cam = loading.loads(text).cam.cam
    assert touching(cam, np.array([0.03 + 0.02j, 0.001 + 0.04j]), np.zeros(2))[0] == -np.inf
