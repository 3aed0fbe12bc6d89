"""The force plan of a group above class II: the reactions come from the equilibrium of its links, the plan shows them.

The links are walked along their inner pairs as a tree. The loads and outer reactions of a link, and of all links behind
it, stand together in the plan, so that the reaction of the inner pair through which the walk came closes them. Where
a contour closes, its last reaction is laid off on both its links; then a reaction of any pair of the contour leads from
one common point.
"""

from __future__ import annotations

from tmm_report.chapters.lever.force_plans.drafting.balance import equilibrium
from tmm_report.chapters.lever.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet
from tmm_report.chapters.lever.kinetostatics.quantities.positions import reaction
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.quantity.formula import Term, VectorEquation

ONE_LINE = 1.0  # mm: lines nearer than this are one


def plan(sheet: Sheet, group: HigherGroup) -> ForcePlan:
    """Draw the plan, read the reactions and pass the outer ones on."""
    arms: list[Arm] = []
    found = equilibrium(sheet, group, arms)
    whole = _Polygon(sheet, group.group, dict(found.forces), 1.0)
    corners = [z for stroke in whole.strokes for z in (stroke.start, stroke.end)]
    mu = sheet.scale_of(group.links, (*group.group.outer, *group.group.inner), corners)
    polygon = _Polygon(sheet, group.group, {key: force / mu for key, force in found.forces.items()}, mu)
    pairs = (*group.group.outer, *group.group.inner)
    readings = [sheet.read(reaction(*p.links), polygon.drawn[p.key], p, mu) for p in pairs]
    loads = {link: tuple(sheet.acting[link]) for link in group.links}
    couples = {link: tuple(sheet.couples[link]) for link in group.links}
    equation = VectorEquation([polygon.terms, []])
    for pair in group.group.outer:
        sheet.pass_on(pair, pair.links[1], polygon.drawn[pair.key], mu)
    return ForcePlan(
        group.group.label, group.links, mu, loads, couples, tuple(arms), (), equation,
        tuple(polygon.strokes), tuple(readings), found.balances, found.solution,
        found.held, chosen=sheet.chosen, poles=sheet.poles(group.links),
    )  # fmt: skip


class _Tree:
    """A walk over the links of a group along its inner pairs. `back`: pairs that close a contour: (pair, the link
    farther on, the link it leads back to)."""

    def __init__(self, group: Group, root: str):
        self.group, self.root = group, root
        self.children: dict[str, list[tuple[str, Pair]]] = {}
        self.back: list[tuple[Pair, str, str]] = []
        self._visit(root, None)

    def _visit(self, link: str, via: Pair | None) -> None:
        self.children[link] = []
        for pair in self.group.inner:
            if link not in pair.links or pair is via or any(pair is done for done, _, _ in self.back):
                continue
            other = pair.other(link)
            if other not in self.children:
                self.children[link].append((other, pair))
                self._visit(other, pair)
            elif not any(pair is p for _, p in self.children[link]):
                self.back.append((pair, link, other))

    @property
    def astray(self) -> int:
        """How many contours do not end in the root: in the plan their reactions stand apart."""
        return sum(ancestor != self.root for _, _, ancestor in self.back)

    def behind(self, link: str) -> list[str]:
        """A link and all links behind it."""
        return [link, *(far for child, _ in self.children[link] for far in self.behind(child))]

    def onward(self, link: str) -> list[tuple[str, Pair]]:
        """The next links, those from which a contour leads back last."""
        ends = {far for _, far, _ in self.back}
        return sorted(self.children[link], key=lambda step: bool(ends & set(self.behind(step[0]))))


class _Polygon:
    """The plan, mm. `forces`: pair key -> force of its first link on the second; `drawn`: the same as drawn."""

    def __init__(self, sheet: Sheet, group: Group, forces: dict[str, complex], mu: float):
        self.sheet, self.group, self.forces, self.mu = sheet, group, forces, mu
        self.tree = min((_Tree(group, link) for link in group.links), key=lambda tree: tree.astray)
        self.strokes: list[ForceStroke] = []
        self.drawn: dict[str, complex] = {}
        self.terms: list[Term] = []
        self.tip = 0j
        self.left = len(group.outer) + 2 * len(self.tree.back)  # reactions still to be laid off
        self._subtree(self.tree.root, None)

    def _subtree(self, link: str, via: Pair | None) -> None:
        start = self.tip
        for pair, _, ancestor in self.tree.back:
            if ancestor == link:
                self._reaction(pair, link)
        loads, self.tip = self.sheet.laid_off(link, self.tip, self.mu)
        self.strokes += loads
        self.terms += self.sheet.terms(link)
        for pair in (p for p in self.group.outer if link in p.links):
            self._reaction(pair, link)
            self.terms.append(Term(reaction(*pair.links).sign, 2))
        for child, pair in self.tree.onward(link):
            self._subtree(child, pair)
        for pair, far, _ in self.tree.back:
            if far == link:
                self._reaction(pair, link)
        if via is not None:
            self._close(via, link, start)

    def _reaction(self, pair: Pair, link: str) -> None:
        """Lay off a reaction on a link; the last one closes the plan."""
        sense = 1 if link == pair.links[1] else -1
        self.left -= 1
        end = self.sheet.pen.place(self.tip + sense * self.forces[pair.key]) if self.left else 0j
        self._stroke(pair, sense, self.tip, end)
        self.tip = end

    def _close(self, pair: Pair, link: str, start: complex) -> None:
        """The reaction of an inner pair closes the forces on a link and on all links behind it."""
        self._stroke(pair, 1 if link == pair.links[1] else -1, self.tip, start)

    def _stroke(self, pair: Pair, sense: int, start: complex, end: complex) -> None:
        """Draw the force of the pair's first link on the second along a side of the plan.

        That of the second on the first has its own line only where it does not lie on the one already drawn.
        """
        first, second = (start, end) if sense > 0 else (end, start)
        if pair.key not in self.drawn:
            self.drawn[pair.key] = second - first
            self.strokes.append(ForceStroke(first, second, reaction(*pair.links), "reaction"))
            return
        old = next(s for s in self.strokes if s.key == reaction(*pair.links).key)
        if abs(old.start - first) + abs(old.end - second) > ONE_LINE:
            one, other = pair.links if sense > 0 else pair.links[::-1]
            self.strokes.append(ForceStroke(start, end, reaction(one, other), "reaction"))
