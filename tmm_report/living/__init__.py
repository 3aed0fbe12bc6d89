"""The living page: what stands behind the text of a note in HTML, for the screen alone: a style, data and a script.

The script (`templates/living/*.js`) moves what is drawn and knows nothing of mechanics: all its numbers are those of
the positions that were solved, as one block of JSON. Without it the page is the static note, and so it is in print.
"""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Container, Iterator, Mapping
from functools import cache
from html import unescape
from typing import Any

from tmm_report.course import Results
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.living.charts import cursors
from tmm_report.living.cycle import Cycle, cycle_of, positions_of
from tmm_report.living.loads import Loads
from tmm_report.living.mechanism import moving, seen
from tmm_report.living.moves import moved
from tmm_report.living.plans import polygons
from tmm_report.living.told import told
from tmm_report.living.words import words
from tmm_report.report.page import Page
from tmm_report.resources import allowed, data_root

SCRIPTS = (
    "state",
    "mechanism",
    "stage",
    "figures",
    "loads",
    "moves",
    "tables",
    "fellows",
    "page",
)  # as they run
_BEGINS = "<style>\n/* The living page"  # as its style does
_SHOWN = re.compile(' data-q="([^"]*)"(?: data-k="[^"]*")?(?: data-t="([^"]*)")?')
Pictures = Mapping[str, Drawing | Graph]


def added(text: str, results: Results, page: Page, pictures: Pictures) -> str:
    """The note with all of the living page behind its text; `pictures`: the figures by their anchors."""
    script = _read("js")
    policy = f"default-src 'none'; script-src {allowed(script.encode())};"
    text = text.replace("default-src 'none';", policy, 1)
    body, end, rest = text.rpartition("</body>")
    data = as_json(known(results, page, pictures, set(_shown(text))))
    block = (
        f"<style>\n{_read('css')}</style>\n"
        f'<script type="application/json" id="living">{data}</script>\n<script>{script}</script>\n'
    )
    return f"{body}{block}{end}{rest}"


def static(page: str) -> str:
    """The note as it is where scripts are off: without all that stands behind its text for the screen."""
    body, begins, behind = page.rpartition(_BEGINS)
    return body + behind.rpartition("</script>\n")[2] if begins else page


def known(results: Results, page: Page, pictures: Pictures, shown: Container[str] = ()) -> dict[str, Any]:
    """What the script knows; `shown`: keys of the numbers on the page, and their names in the results."""
    found: dict[str, Any] = {
        "words": words(page.tr),
        "decimal": page.tr.decimal,
        "told": packed(told(results, page, shown)),
    }
    lever, moves = results.lever, moved(pictures, results)
    if lever is None or (cycle := cycle_of(results)) is None:
        turn = positions_of(results)
        charts = cursors(pictures, turn, page.tr, shown)
        if not moves and not charts:
            return found
        return found | {"cycle": turn.said(page.tr, shown, {}, {}), "moves": moves, "charts": charts}
    view = seen(lever, cycle, page)
    mechanism = moving(lever, cycle, view)
    drawn = {key for key in cycle.vectors if key[:2] in ("v_", "a_") and key[2:] in mechanism["points"]}
    drawn |= {key for key, *_ in mechanism["forces"] if key in cycle.vectors}
    vectors, turning, schemes = {key: cycle.vectors[key] for key in sorted(drawn)}, {}, {}
    of_plans: Mapping[str, Any] = cycle.vectors
    if (forces := lever.kinetostatics) is not None:
        loads = Loads(cycle, view, forces, {key: at for key, at, _ in mechanism["forces"]}, page.tr)
        schemes = loads.schemes(pictures)
        vectors, turning, of_plans = vectors | loads.vectors, loads.turning, loads.known
    plans, more = polygons(pictures, cycle, of_plans, vectors)
    return found | {
        "cycle": cycle.said(page.tr, shown, vectors | more, turning),
        "mechanism": mechanism,
        "plans": plans,
        "loads": schemes,
        "moves": moves,
        "charts": cursors(pictures, cycle, page.tr, shown),
    }


def _shown(text: str) -> Iterator[str]:
    for key, table in set(_SHOWN.findall(text)):
        yield unescape(key)
        yield f"{table}.{unescape(key)}"


def packed(data: Any) -> str:
    """What is asked for by a click alone: raw deflate (RFC 1951) in base64, a quarter of the text."""
    squeeze = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return base64.b64encode(squeeze.compress(text.encode()) + squeeze.flush()).decode()


def as_json(data: Any) -> str:
    """Text that cannot end its element: no name of a variant may (HTML Standard, 4.12.1.3)."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


@cache
def _read(kind: str) -> str:
    folder = data_root() / "templates" / "living"
    names = [f"{name}.js" for name in SCRIPTS] if kind == "js" else ["living.css"]
    return "".join((folder / name).read_text("utf-8") for name in names)


__all__ = ["Cycle", "added", "as_json", "known", "static"]
