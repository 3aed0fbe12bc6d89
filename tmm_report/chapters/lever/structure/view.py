"""View of the structural analysis: links, pairs, mobility, Assur groups, other driving links."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.schemes import schemes_of
from tmm_report.chapters.lever.structure import quantities as q
from tmm_report.chapters.lever.structure.naming import link_name
from tmm_report.chapters.lever.structure.solve import Structure
from tmm_report.figures.schemes.scheme import Drawn
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import roman
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part
from tmm_report.report.schemes import Schemes
from tmm_report.report.words import (
    PAIR_KINDS,
    group_name,
    of_so_many,
    so_many_pairs,
    structural_formula,
)

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

KINDS = {1: "RRR", 2: "RRP", 3: "RPR", 4: "PRP", 5: "RPP"}
# Kind of a pair -> what of its reaction is known, and what is not.
KNOWN = {
    "R": N_(
        "Of the reaction in a revolute pair the point of application is known, the axis of the pivot; its "
        "magnitude and direction are to be found."
    ),
    "P": N_(
        "Of the reaction in a prismatic pair the direction is known, perpendicular to the guide; its magnitude "
        "and point of application are to be found."
    ),
    "H": N_(
        "Of the reaction in a higher pair the point of contact and the direction along the common normal n–n are "
        "known; its magnitude is to be found."
    ),
    "rolling": N_(
        "Of the reaction in the pair of a rolling wheel the point of contact and the direction along the rail are "
        "known, since the guide of the axle bears the normal force; its magnitude is to be found."
    ),
}
MESHES = {
    "external": N_("wheels of links %(one)s and %(other)s in external mesh, pitch point %(point)s"),
    "internal": N_("wheels of links %(one)s and %(other)s in internal mesh, pitch point %(point)s"),
    "rack": N_("a rack on link %(one)s and a wheel on link %(other)s, pitch point %(point)s"),
}
ON_FRAME = {
    "external": N_(
        "the wheel of link %(other)s round a fixed wheel, in external mesh, pitch point %(point)s"
    ),
    "internal": N_("the wheel of link %(other)s in a fixed ring, in internal mesh, pitch point %(point)s"),
    "rack": N_("the wheel of link %(other)s on a fixed rack, pitch point %(point)s"),
}
RING_RUNS = N_("the ring of link %(other)s round a fixed wheel, in internal mesh, pitch point %(point)s")
ROLLS = N_("wheel %(other)s, which rolls on a fixed rail without slip, point of contact %(point)s")
CARRIED = {
    False: N_("carrier %(carrier)s holds the axes"),
    True: N_("the axis of the wheel moves along a guide on link %(carrier)s"),
}
ORDINALS = {1: N_("1st kind"), 2: N_("2nd kind"), 3: N_("3rd kind"), 4: N_("4th kind"), 5: N_("5th kind")}


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    motion = lever.kinematics.diagram
    view = StructureView(lever.structure, motion, schemes_of(lever, page), lever.sample, page)
    yield Part("lever/structure", view)


class StructureView(BookView):
    def __init__(self, found: Structure, motion: Motion, schemes: Schemes, position: int, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.motion, self.schemes, self.position = found, motion, schemes, position

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The mechanism has the mobility W = 1, its structural formula is %(formula)s, and it belongs to class "
            "%(class)s."
        )
        return [self.t(text, **{"formula": self.formula(), "class": self.class_})]

    @property
    def driver(self) -> str:
        return self.found.linkage.mechanism.driver.link

    @property
    def stroke(self) -> Stroke | None:
        """Of a driving slider or cylinder."""
        return self.found.linkage.mechanism.driver.stroke

    @property
    def reversed(self) -> bool:
        """Whether the motion is found by reversing it."""
        return isinstance(self.stroke, Reversed)

    @property
    def cylinder_only_reversed(self) -> bool:
        """Whether the groups with the cylinder as what drives are not known."""
        return self.reversed and self.stroke is not None and not self.stroke.slides

    def held(self) -> str:
        """The cylinder as one link."""
        stroke = self.found.linkage.mechanism.driver.stroke
        assert stroke is not None
        return "+".join(stroke.by) or "".join(stroke.ends)

    def with_the_cylinder(self) -> str:
        """The structural formula with the cylinder as what drives."""
        return " → ".join(["0", *map(group_name, self.found.by_cylinder)])

    def class_with_the_cylinder(self) -> str:
        return roman(max(group.group_class for group in self.found.by_cylinder))

    @property
    def class_(self) -> str:
        return roman(self.found.mechanism_class)

    def formula(self) -> str:
        return structural_formula(self.found.linkage.structure)

    def counted(self, key: str) -> int:
        return round(self.value(key).value)

    def of_links(self) -> str:
        """How many moving links, as the mechanism consists of them."""
        return of_so_many(self.counted("n"), self.page.tr)

    def pairs_of(self, key: str) -> str:
        """How many pairs of class V ("p5") or IV ("p4"), as the links form them."""
        return so_many_pairs(self.counted(key), self.page.tr)

    def mobility(self) -> Formula:
        n, p5, p4 = map(self.var, ("n", "p5", "p4"))
        return self.value("W").formula(3 * n - 2 * p5 - p4)

    # ------------------------------------------------------------ cam pairs

    def replacing(self) -> list[Markup]:
        """What replaces every cam pair."""
        return [self._replacing(cam) for cam in self.found.cams]

    def _replacing(self, cam: Cam) -> Markup:
        names = {"cam": cam.cam, "follower": cam.follower, "link": cam.name, "centre": cam.centre}
        if cam.flat:
            text = N_(
                "the pair of cam %(cam)s and the flat face of follower %(follower)s by link %(link)s, which is "
                "pivoted to the cam at %(centre)s, the centre of curvature of the profile at the contact, and slides "
                "along the face"
            )
            return self.t(text, **names)
        if cam.roller:
            text = N_(
                "the pair of cam %(cam)s and follower %(follower)s by link %(link)s, which is pivoted to the cam "
                "at %(centre)s, the centre of curvature of the profile at the contact, and to the follower at "
                "the roller's centre %(point)s; the roller's own rotation is a local degree of freedom that does "
                "not affect the motion, and the roller is counted as one with the follower"
            )
        else:
            text = N_(
                "the pair of cam %(cam)s and follower %(follower)s by link %(link)s, which is pivoted to the cam at "
                "%(centre)s, the centre of curvature of the profile at the contact, and to the follower at its edge "
                "%(point)s"
            )
        return self.t(text, point=cam.point, **names)

    def replaced_mobility(self) -> Formula:
        """The replacing mechanism has the mobility of the real one."""
        n, p5 = map(self.var, ("n_repl", "p5_repl"))
        return self.value("W_repl").formula(3 * n - 2 * p5)

    def of_replaced(self) -> list[dict[str, Any]]:
        return self.explained("n_repl", "p5_repl")

    def of_mobility(self) -> list[dict[str, Any]]:
        return self.explained("n", "p5", "p4")

    @cached_property
    def groups_drawn(self) -> Drawn:
        groups, small = self.found.linkage.structure.groups, not self.page.note.every
        return self.schemes.groups(groups, self.position, small)

    def groups_scale(self) -> Var:
        """mu_l with the scale at which the groups are drawn apart."""
        return scale_of("mu_l", self.groups_drawn.mu, "m/mm")

    # ------------------------------------------------------------ wheels and racks

    @property
    def coupled(self) -> tuple[Coupled, ...]:
        return self.found.linkage.structure.coupled

    def meshing(self) -> list[Markup]:
        """What is in mesh, and how."""
        return [self._meshing(mesh) for mesh in self.found.linkage.mechanism.meshes]

    def _meshing(self, mesh: Mesh) -> Markup:
        """Its wheels, and what is stated of their teeth and their phase."""
        one, other = mesh.links
        names = {"one": one, "other": other, "point": mesh.pole, "carrier": mesh.carrier}
        said = [self.t(_kind(mesh), **names)]
        if mesh.carrier != FRAME:
            said.append(self.t(CARRIED[mesh.kind == "rack"], **names))
        for link in mesh.links:
            key = q.teeth_of(mesh, link).key
            if self.knows(key):
                said.append(self.t("z = %(teeth)s on link %(link)s", teeth=self.number(key), link=link))
        if mesh.module is not None:
            said.append(self.t("module %(module)s", module=self.measured(q.module_of(mesh).key)))
        said.append(self.t(_at(mesh), phase=self.number(q.phase_of(mesh).key), **names))
        return self.page.listed(said, "; ")

    def still(self) -> bool:
        """Whether there are wheels with fixed axes."""
        return any(mesh.carrier == FRAME for mesh in self.found.linkage.mechanism.meshes)

    def carried(self) -> list[Mesh]:
        """Those whose axes move."""
        return [mesh for mesh in self.found.linkage.mechanism.meshes if mesh.carrier != FRAME]

    def turning(self) -> bool:
        """Whether there are carriers that turn."""
        return any(mesh.carried is None for mesh in self.carried())

    def toothed(self) -> bool:
        """Whether not all higher pairs are those of rolling wheels without teeth."""
        return not all(mesh.rolls for mesh in self.found.linkage.mechanism.meshes)

    def ratios(self) -> list[Formula]:
        """The ratio of every mesh by its radii; of a wheel that runs on a fixed one that to its carrier, too."""
        found, made = self.found.linkage, []
        for mesh in found.mechanism.meshes:
            first, second = (
                self.value(q.pitch_radius(found, mesh, link).key).var() if mesh.radius(link) else None
                for link in mesh.links
            )
            assert second is not None
            size: Expr = first / second if first is not None else 1 / second
            of, number = q.transfer_of(mesh), mesh.ratio
            if mesh.kind == "rack" and FRAME in mesh.links:
                of, number = q.share_of(mesh), mesh.share
            made.append(self.value(of.key).formula(size if number > 0 else -size))
            if mesh.kind != "rack" and FRAME in mesh.links:
                made.append(self.value(q.share_of(mesh).key).formula(1 - self.value(of.key).var()))
        return made

    def of_ratios(self) -> list[dict[str, Any]]:
        return self.page.where(*self.ratios())

    def law(self, mesh: Mesh) -> Definition:
        """The angle of the second wheel by those of the first and of the carrier, in symbols."""
        one, other = mesh.links
        start: Expr = self.value(q.phase_of(mesh).key).var()
        if FRAME in mesh.links:
            ratio = self.value(q.share_of(mesh).key).var()
            own = Var(Symbol("s" if mesh.kind == "rack" else "phi", mesh.carrier), 0.0)
            return Definition(Symbol("phi", other), start + ratio * own)
        ratio = self.value(q.transfer_of(mesh).key).var()
        letter = "s" if mesh.kind == "rack" else "phi"
        first, carrier = Var(Symbol(letter, one), 0.0), Var(Symbol(letter, mesh.carrier), 0.0)
        if mesh.kind == "rack":
            alike = mesh.share * mesh.ratio < 0  # the guides run the same way
            return Definition(
                Symbol("phi", other), start + ratio * (first - carrier if alike else first + carrier)
            )
        return Definition(Symbol("phi", other), start + carrier + ratio * (first - carrier))

    # ------------------------------------------------------------ tables

    def links(self, caption: Any) -> Table:
        rows = []
        for link in [FRAME, *self.found.linkage.mechanism.real.moving]:
            name = link_name(self.found, self.motion, link)
            rows.append([link, self.t(name.name), self.t(name.motion)])
        return worded(caption, [self.t("Link"), self.t("Name"), self.t("Motion")], rows, (1, 4, 4))

    def pairs(self, caption: Any) -> Table:
        table = self.table("pairs")
        rows = [
            [
                self.page.cell(table, "number", k), self.page.word("–".join(pair.links), table, "links", k),
                self.page.named(table, "name", k), self.t(PAIR_KINDS[pair.kind]),
                "IV" if pair.kind == "H" else "V",
            ]
            for k, pair in enumerate(self.found.pairs)
        ]  # fmt: skip
        heads = [
            self.t("No."), self.t("Links"), self.t("Point, guide"), self.t("Kind"), self.t("Class"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 2, 2, 4, 1.4))

    def reactions(self) -> list[Markup]:
        """What of the reaction in each kind of pair is known beforehand, and what is to be found."""
        rolling = {one.contact.key for one in self.coupled if one.mesh.rolls}
        kinds = ["rolling" if pair.key in rolling else pair.kind for pair in self.found.pairs]
        return [self.t(text) for kind, text in KNOWN.items() if kind in kinds]

    def groups(self, caption: Any) -> Table:
        """Groups in the order in which they are detached."""
        table = self.table("groups")
        rows = [
            [
                group_name(group), self.page.word(", ".join(group.links), table, "links", k),
                self.page.word(roman(group.group_class), table, "class", k), self.page.cell(table, "order", k),
                self._kind(group), _pair_list(group.inner), _pair_list(group.outer),
            ]
            for k, group in enumerate(q.detached(self.found))
        ]  # fmt: skip
        heads = [
            self.t("Group"), self.t("Links"), self.t("Class"), self.t("Order"), self.t("Kind"),
            self.t("Inner pairs"), self.t("Outer pairs"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2.4, 1.4, 1.4, 1.6, 3, 3, 3))

    def determinacy(self, caption: Any) -> Table:
        """That every group is statically determinate: its equations of equilibrium against its unknowns."""
        table = self.table("groups")
        keys = ("links_count", "lower", "higher", "equations", "unknowns")
        rows = [
            [group_name(group), *(self.page.cell(table, key, k) for key in keys)]
            for k, group in enumerate(q.detached(self.found))
        ]
        heads = [self.t("Group"), *self.signs().values(), self.t("Equations"), self.t("Unknowns")]
        return worded(caption, heads, rows, (3, 1, 1, 1, 2, 2))

    @property
    def alike(self) -> bool:
        """Whether all groups have as many links and lower pairs, and none a higher one."""
        table = self.table("groups")
        same = all(len(set(table[key].values)) == 1 for key in ("links_count", "lower"))
        return same and not any(table["higher"].values)

    def of_every_group(self) -> dict[str, Markup]:
        """The numbers that all groups have, for a sentence."""
        keys = {"links": "links_count", "lower": "lower", "equations": "equations", "unknowns": "unknowns"}
        return self.signs() | {
            name: self.page.shown(self.table("groups"), key, 0) for name, key in keys.items()
        }

    def signs(self) -> dict[str, Markup]:
        """The letters of the formula of mobility, for a sentence."""
        return {key: self.page.sym(self.value(key).symbol) for key in ("n", "p5", "p4")}

    def _kind(self, group: Group) -> str:
        """ "2nd kind (RRP)"; a dash for a group that is no dyad."""
        if group.kind is None:
            return "—"
        return f"{self.page.tr.gettext(ORDINALS[group.kind])} ({KINDS[group.kind]})"

    def drivers(self, caption: Any) -> Table:
        """What the groups become when another link drives."""
        table, rows = self.table("drivers"), []
        for k, other in enumerate(self.found.alternatives):
            if other.structure is None:
                rows.append([other.link, other.reason and self.page.sentence(other.reason), "—"])
            else:
                class_ = self.page.word(roman(other.structure.mechanism_class), table, "class", k)
                rows.append([other.link, structural_formula(other.structure), class_])
        heads = [self.t("Driving link"), self.t("Structural formula"), self.t("Class")]
        return worded(caption, heads, rows, (2, 8, 2))

    def other_drivers(self) -> list[Markup]:
        """The same in words, where it is short."""
        found, table = self.found.alternatives, self.table("drivers") if self.found.alternatives else None
        whole = [other.structure for other in found if other.structure is not None]
        if self.page.note.every or self.stroke is not None or table is None or len(whole) < len(found):
            return []
        text = N_("with driving link %(link)s it is %(formula)s, class %(class)s")
        said = []
        for k, (other, structure) in enumerate(zip(found, whole, strict=True)):
            class_ = self.page.said(Cell(roman(structure.mechanism_class), table.ref("class", k)))
            formula = self.page.text(structural_formula(structure))
            said.append(self.t(text, link=other.link, formula=formula, **{"class": class_}))
        return said

    @property
    def taken_apart(self) -> list[str]:
        """Links that would drive a mechanism of dyads alone."""
        return [other.link for other in self.found.alternatives if other.taken_apart]


def _pair_list(pairs: Sequence[Pair]) -> str:
    return ", ".join(f"{pair.links[0]}–{pair.links[1]} ({pair.name})" for pair in pairs)


def _kind(mesh: Mesh) -> str:
    """What is in mesh."""
    if mesh.rolls:
        return ROLLS
    if FRAME not in mesh.links:
        return MESHES[mesh.kind]
    return RING_RUNS if mesh.rings(mesh.links[1]) else ON_FRAME[mesh.kind]


def _at(mesh: Mesh) -> str:
    """The place at which its phase is stated."""
    if mesh.kind == "rack":
        if FRAME in mesh.links:
            return N_(
                "where link %(carrier)s is at the point of its guide, link %(other)s has the angle %(phase)s°"
            )
        if mesh.carrier != FRAME:
            return N_(
                "where links %(one)s and %(carrier)s are at the points of their guides, link %(other)s has the angle "
                "%(phase)s°"
            )
        return N_("where link %(one)s is at the point of its guide, link %(other)s has the angle %(phase)s°")
    if FRAME in mesh.links:
        return N_("where link %(carrier)s has the angle 0, link %(other)s has %(phase)s°")
    if mesh.carrier != FRAME:
        return N_("where links %(one)s and %(carrier)s have the angle 0, link %(other)s has %(phase)s°")
    return N_("where link %(one)s has the angle 0, link %(other)s has %(phase)s°")
