"""The keys `wheels`, `racks` and `rolling` -> Mesh. What cannot be built raises Wrong with its key; `checks` tries it
first."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.cams.cam.block.laws import Wrong
from tmm_report.chapters.lever.structure.block.wheels.models import RackModel, RollingModel, WheelsModel
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Mechanism, Slide
from tmm_report.mechanics.lever.wheels.mesh import Mesh, Way
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import Typed

if TYPE_CHECKING:
    from tmm_report.chapters.lever.structure.block.models import MechanismModel

FITS = 1e-6  # of the distance of the axes: what sizes of wheels may miss it by
SIDES = {"above": 1j, "below": -1j, "right": 1 + 0j, "left": -1 + 0j}


def meshes(model: MechanismModel, built: Mechanism) -> Iterator[Mesh]:
    """Raises Wrong."""
    for k, one in enumerate(model.wheels):
        yield gear_pair(k, one, built)
    for k, rack in enumerate(model.racks):
        yield rack_pair(k, rack, built)
    for k, wheel in enumerate(model.rolling):
        yield rolling_pair(k, wheel, built)


# ---------------------------------------------------------------- axes


def axis_of(link: str, built: Mechanism, key: str) -> str:
    """The name of the fixed point about which a link turns."""
    points = [point for point in built.links[link].points if point in built.links[FRAME].points]
    if points:
        return points[0]
    text = N_("link %(link)s turns about no fixed point, and no carrier is stated")
    joined = [one for one in built.moving if one != link and _shared(one, link, built)]
    right = N_("carrier: %(links)s, the link that holds both axes, or a point of the frame (%(words)s)")
    words = ", ".join(built.links[FRAME].points) or "O: [0, 0]"
    values = {"links": " / ".join(joined[:4]) or "1", "words": words}
    raise Wrong(key, Message(text, {"link": link}), Message(right, values))


def axis_on(carrier: str, link: str, built: Mechanism) -> str:
    """The name of the point about which a link turns on its carrier."""
    points = _shared(carrier, link, built)
    if len(points) == 1:
        return points[0]
    text = N_(
        "carrier %(carrier)s and link %(link)s have not one common point, which would be the wheel's axis"
    )
    right = Message(N_("the link to which both wheels are pivoted"))
    raise Wrong("carrier", Message(text, {"carrier": carrier, "link": link}), right)


def _shared(one: str, other: str, built: Mechanism) -> list[str]:
    return [point for point in built.links[one].points if point in built.links[other].points]


# ---------------------------------------------------------------- wheels


def gear_pair(k: int, model: WheelsModel, built: Mechanism) -> Mesh:
    first, second = model.links
    carrier = model.carrier or FRAME
    if model.carrier is None:
        points = axis_of(first, built, "links.0"), axis_of(second, built, "links.1")
    else:
        points = axis_on(carrier, first, built), axis_on(carrier, second, built)
    axes = tuple(complex(built.links[carrier].points[point]) for point in points)
    apart = abs(axes[1] - axes[0])
    if apart < 1e-9:
        text = N_("the wheels have one axis, and can't be in mesh")
        raise Wrong("links", Message(text), Message(N_("wheels of one shaft are one link")))
    radii = _radii(model, apart, model.mesh == "internal")
    made = Mesh(
        f"wheels {k}", (first, second), model.mesh, radii, (axes[0], axes[1]), model.phase or 0.0,
        model.pressure_angle, teeth=model.teeth, module=model.module, carrier=carrier, points=points,
    )  # fmt: skip
    if model.angles is None:
        return made
    if first == FRAME and model.angles[0]:
        raise Wrong("angles.0", Message(N_("the frame does not turn")), Message(N_("0 of the frame")))
    return replace(made, phase=model.angles[1] - made.ratio * model.angles[0])


def _radii(model: WheelsModel, apart: float, internal: bool) -> tuple[float, float]:
    """Radii of the working pitch circles, m, whose sum (difference) is the distance of the axes."""
    sizes: tuple[float, float] = model.teeth or model.radii or (1.0, float(model.ratio or 1.0))
    together = abs(sizes[0] - sizes[1]) if internal else sizes[0] + sizes[1]
    key = "teeth" if model.teeth else "radii" if model.radii else "ratio"
    if together < 1e-12:
        text = N_("wheels in internal mesh can't be equal")
        raise Wrong(key, Message(text), Message(N_("a larger ring, or mesh: external")))
    scale = apart / together
    wanted = model.module / 2 if model.module else 1.0 if model.radii else scale
    if abs(wanted - scale) > FITS * scale:
        raise Wrong("module" if model.module else key, *_misses(model, wanted * together, scale, apart))
    return sizes[0] * scale, sizes[1] * scale


def _misses(model: WheelsModel, made: float, scale: float, apart: float) -> tuple[Message, Message]:
    """That sizes and the distance of the axes do not go together, and what would."""
    text = N_(
        "the working pitch circles do not touch: their radii make %(made)s mm, and the axes are %(apart)s mm apart"
    )
    values = {"made": f"{1e3 * made:.6g}", "apart": f"{1e3 * apart:.6g}"}
    if model.module:
        right = N_("module: %(right)s mm, or leave it out; or axes %(made)s mm apart")
        return Message(text, values), Message(right, {"right": f"{2e3 * scale:.6g}", **values})
    radii = ", ".join(f"{1e3 * scale * r:.6g} mm" for r in model.radii or ())
    right = N_("radii: [%(right)s] in the same ratio, or axes %(made)s mm apart")
    return Message(text, values), Message(right, {"right": Typed(radii), **values})


# ---------------------------------------------------------------- racks and rails


def rack_pair(k: int, model: RackModel, built: Mechanism) -> Mesh:
    slider, carrier = model.slider, model.carrier or FRAME
    held = _fixed_slide(carrier, built, "carrier") if model.carrier else None
    point = axis_on(carrier, model.wheel, built) if held else axis_of(model.wheel, built, "wheel")
    axis = complex(built.links[carrier].points[point])
    radius = model.radius or (model.teeth or 0) * (model.module or 0.0) / 2
    if slider == FRAME:
        if held is None:
            text = N_("a fixed rack and a wheel with a fixed axis do not move")
            right = N_("carrier: the slider to which the wheel is pivoted")
            raise Wrong("slider", Message(text), Message(right))
        own, (slide, guide) = 0j, held
    else:
        slide, guide = _fixed_slide(slider, built, "slider")
        own = complex(slide.through)
    t, through = complex(guide.direction), complex(guide.through)
    if held and abs(cross(t, complex(held[1].direction))) > 1e-9:
        text = N_("the guides of the rack and of the carrier %(carrier)s are not parallel")
        right = N_("a slider on a guide with the angle of that of the rack")
        raise Wrong("carrier", Message(text, {"carrier": carrier}), Message(right))
    carried = (
        Way(*(complex(x) for x in (held[0].through, held[1].through, held[1].direction))) if held else None
    )
    off = _across(carried, held[0], axis) if carried and held else axis
    toward = _toward(model.side, t, dot(1j * t, off - through))
    teeth = (0, model.teeth) if model.teeth else None
    return Mesh(
        f"racks {k}", (slider, model.wheel), "rack", (0.0, radius), (None, axis), model.phase,
        model.pressure_angle, t, through, own, toward, teeth, model.module, carrier, carried, points=("", point),
    )  # fmt: skip


def _across(way: Way, slide: Slide, axis: complex) -> complex:
    """Where a carrier's point is in the drawing, but for the way along its guide, m."""
    return way.through + way.along / complex(slide.direction) * (axis - way.own)


def _toward(side: str | None, t: complex, away: float) -> complex:
    """From the wheel's axis to a rack along `t`. `away`: of the axis from the guide, m."""
    normal = 1j * t
    if side is not None:
        cosine = float(dot(normal, SIDES[side]))
        if abs(cosine) < 0.1:
            text = N_(
                "%(side)s does not tell on which side of the rack the wheel stands: the rack runs that way"
            )
            across = ("above", "below") if abs(t.real) > abs(t.imag) else ("left", "right")
            right = Message(
                N_("side: %(one)s or side: %(other)s"), dict(zip(("one", "other"), across, strict=True))
            )
            raise Wrong("side", Message(text, {"side": side}), right)
        return -normal * float(np.sign(cosine))
    if abs(away) < 1e-9:
        text = N_("the wheel's axis lies on the line of the guide, and the side of the rack is not stated")
        raise Wrong(
            "", Message(text), Message(N_("side: above, below, left or right, where the wheel stands"))
        )
    return -normal if away > 0 else normal


def rolling_pair(k: int, model: RollingModel, built: Mechanism) -> Mesh:
    """A rail along the guide of the wheel's axle; all that the guide bears across it the rail does."""
    slide, guide = _fixed_slide(model.carrier, built, "carrier")
    axle = built.links[model.carrier]
    point = axis_on(model.carrier, model.wheel, built)
    at, t = complex(axle.points[point]), complex(guide.direction)
    others = [name for name in axle.points if abs(axle.points[name] - at) > 1e-12]
    slides = [one for one in built.slides if one.link == model.carrier]
    if others or len(slides) > 1 or abs(complex(slide.through) - at) > 1e-12 or axle.inertia:
        text = N_(
            "link %(link)s is more than the axle of a wheel: what the rail bears of its guide cannot be told apart"
        )
        right = N_("carrier: a slider of the point %(point)s alone; or mechanism.racks with slider: 0")
        raise Wrong("carrier", Message(text, {"link": model.carrier}), Message(right, {"point": point}))
    return Mesh(
        f"rolling {k}", (FRAME, model.wheel), "rack", (0.0, model.radius), (None, at), model.phase, 0.0,
        t, complex(guide.through), 0j, _toward(model.side, t, 0.0), carrier=model.carrier,
        carried=Way(at, complex(guide.through), t), rolls=True, points=("", point),
    )  # fmt: skip


def _fixed_slide(link: str, built: Mechanism, key: str) -> tuple[Slide, Guide]:
    for slide in built.slides:
        if slide.link == link and built.guides[slide.guide].link == FRAME:
            return slide, built.guides[slide.guide]
    text = N_("link %(link)s slides along no fixed guide: a rack on it is not offered")
    if key == "carrier":
        text = N_("link %(link)s slides along no fixed guide: a wheel whose axis goes so is not offered")
    right = Message(N_("slides: a guide of the frame"))
    raise Wrong(key, Message(text, {"link": link}), right)
