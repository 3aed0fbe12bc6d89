"""The page of a mechanism's ways, and the sentences that go with them on the terminal too.

files = page(find(load("variant.yaml")), Translator("en"))     # {"assemblies.html": b"..."}
"""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from tmm_report.commands.assemblies.ways import MM, Assemblies
from tmm_report.figures.drawing import svg
from tmm_report.figures.schemes.scheme import scheme, standard_scale
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import number
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.resources import data_root


def degrees(found: Assemblies, tr: Translator) -> str:
    """The driving link's angle as it is printed."""
    return number(float(np.degrees(found.phi)), decimal=tr.decimal) + "°"


def heading(found: Assemblies, tr: Translator) -> Message:
    """How many ways there are, and where."""
    values = {"link": found.mechanism.driver.link, "angle": degrees(found, tr), "count": len(found.ways)}
    if found.more:
        text = N_(
            "Driving link %(link)s at %(angle)s; more than %(count)s ways, the first of them are shown."
        )
        return Message(text, values)
    return Message(
        N_("Driving link %(link)s at %(angle)s; ways to assemble the mechanism: %(count)s."), values
    )


def remarks(found: Assemblies) -> list[Message]:
    """How to choose a way, and which ways a sketch cannot choose."""
    text = N_(
        "To choose a way, write its sketch into the block mechanism, in place of assembly and of any other sketch."
    )
    if not found.alike:
        return [Message(text)]
    exceptions = N_(
        "Ways %(numbers)s have every point in the same place, so that a sketch does not tell them apart: take "
        "another angle, name one more point on their links, or state assembly."
    )
    return [Message(text), Message(exceptions, {"numbers": ", ".join(map(str, found.alike))})]


def page(found: Assemblies, tr: Translator) -> dict[str, bytes]:
    """The page by its name, `assemblies.html`: every way drawn, with its coordinates and its sketch."""
    form = Page(Html(), tr, Numbering())
    given = {"page": form, "t": form.t, "unit": form.unit}
    style = Markup((data_root() / "templates" / "style.css").read_text("utf-8"))
    said = [form.t(message.text, **message.values) for message in (heading(found, tr), *remarks(found))]
    text = template("assemblies.html.j2").render(
        given,
        found=found,
        said=said,
        pictures=pictures(found, tr),
        coordinate=lambda x: form.num(x * MM, found.digits, scale=found.size * MM),
        style=style,
    )
    return {"assemblies.html": text.encode()}


def pictures(found: Assemblies, tr: Translator) -> list[Markup]:
    """The schemes of the ways, at one scale, by which two stand side by side on a page."""
    places = {p: np.array([way.places[p] for way in found.ways]) for p in found.mechanism.point_names}
    turns = {link: np.array([way.turns[link] for way in found.ways]) for link in found.mechanism.moving}
    mu, driver = 2 * standard_scale(found.mechanism, places, turns), complex(np.exp(1j * found.phi))
    titles = [tr.gettext(N_("Way %(number)s")) % {"number": k + 1} for k in range(len(found.ways))]
    drawn = [
        scheme(found.mechanism, places, turns, mu, k, driver, title, detailed=False)
        for k, title in enumerate(titles)
    ]
    return [Markup(svg(one)) for one in drawn]
