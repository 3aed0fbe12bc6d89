"""The keys `wheels` and `racks` -> Mesh. What cannot be built raises Wrong with its key; `checks` tries it first."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.structure.block.cam_laws_build import Wrong
from tmm_report.chapters.lever.structure.block.wheels.models import RackModel, WheelsModel
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Mechanism, Slide
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message

FITS = 1e-6  # of the distance of the axes: what sizes of wheels may miss it by
SIDES = {"above": 1j, "below": -1j, "right": 1 + 0j, "left": -1 + 0j}


def meshes(wheels: list[WheelsModel], racks: list[RackModel], built: Mechanism) -> Iterator[Mesh]:
    """Raises Wrong."""
    for k, one in enumerate(wheels):
        yield gear_pair(k, one, built)
    for k, rack in enumerate(racks):
        yield rack_pair(k, rack, built)


def axis_of(link: str, built: Mechanism, key: str) -> complex:
    """The fixed point about which a link turns, m."""
    fixed = built.links[FRAME].points
    points = [point for point in built.links[link].points if point in fixed]
    if not points:
        text = N_("link %(link)s turns about no fixed point: a wheel whose axis moves is not offered")
        right = N_("give it a point of the frame (%(words)s); satellites are stages of the block drive")
        raise Wrong(
            key, Message(text, {"link": link}), Message(right, {"words": ", ".join(fixed) or "O: [0, 0]"})
        )
    return complex(fixed[points[0]])


def gear_pair(k: int, model: WheelsModel, built: Mechanism) -> Mesh:
    first, second = model.links
    axes = axis_of(first, built, "links.0"), axis_of(second, built, "links.1")
    apart = abs(axes[1] - axes[0])
    if apart < 1e-9:
        text = N_("the wheels have one axis, and can't be in mesh")
        raise Wrong("links", Message(text), Message(N_("wheels of one shaft are one link")))
    internal = model.mesh == "internal"
    radii = _radii(model, apart, internal)
    phase = model.phase or 0.0
    made = Mesh(
        f"wheels {k}", (first, second), model.mesh, radii, axes, 0.0, model.pressure_angle,
        teeth=model.teeth, module=model.module,
    )  # fmt: skip
    if model.angles is not None:
        phase = model.angles[1] - made.ratio * model.angles[0]
    return Mesh(
        made.name,
        made.links,
        made.kind,
        radii,
        axes,
        phase,
        made.pressure,
        teeth=made.teeth,
        module=made.module,
    )


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
    return Message(text, values), Message(right, {"right": radii, **values})


def rack_pair(k: int, model: RackModel, built: Mechanism) -> Mesh:
    slide, guide = _fixed_slide(model.slider, built)
    axis = axis_of(model.wheel, built, "wheel")
    radius = model.radius or (model.teeth or 0) * (model.module or 0.0) / 2
    t, through = complex(guide.direction), complex(guide.through)
    normal = 1j * t
    away = dot(normal, axis - through)  # of the wheel's axis from the guide
    if model.side is not None:
        cosine = dot(normal, SIDES[model.side])
        if abs(cosine) < 0.1:
            text = N_(
                "%(side)s does not tell on which side of the rack the wheel stands: the rack runs that way"
            )
            across = ("above", "below") if abs(t.real) > abs(t.imag) else ("left", "right")
            right = Message(
                N_("side: %(one)s or side: %(other)s"), dict(zip(("one", "other"), across, strict=True))
            )
            raise Wrong("side", Message(text, {"side": model.side}), right)
    elif abs(away) < 1e-9:
        text = N_("the wheel's axis lies on the line of the guide, and the side of the rack is not stated")
        raise Wrong(
            "", Message(text), Message(N_("side: above, below, left or right, where the wheel stands"))
        )
    else:
        cosine = away
    toward = -normal if cosine > 0 else normal
    teeth = (0, model.teeth) if model.teeth else None
    return Mesh(
        f"racks {k}", (model.slider, model.wheel), "rack", (0.0, radius), (None, axis), model.phase,
        model.pressure_angle, t, through, complex(slide.through), toward, teeth, model.module,
    )  # fmt: skip


def _fixed_slide(link: str, built: Mechanism) -> tuple[Slide, Guide]:
    for slide in built.slides:
        if slide.link == link and built.guides[slide.guide].link == FRAME:
            return slide, built.guides[slide.guide]
    text = N_("link %(link)s slides along no fixed guide: a rack on it is not offered")
    right = Message(N_("slides: a guide of the frame"))
    raise Wrong("slider", Message(text, {"link": link}), right)
