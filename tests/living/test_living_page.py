"""The living page in a browser: the mechanism dragged, stepped and played; what follows it; print, and scripts off."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from browser import Talk, browser
from conftest import read, solved
from test_living_data import data, page

POSITION = 7
NAMES = ("compressor", "cam_press", "quick_return")


@cache
def seen(name: str) -> dict[str, Any]:
    """Everything that is looked at, in one visit of a page."""
    with opened(page(name)) as talk:
        found = {"start": run(talk, f"{OPEN}; where.at"), "lengths": run(talk, LENGTHS)}
        found["dragged"] = dragged(talk, POSITION) if name == "compressor" else None
        found["readings"] = run(talk, f"{GO % POSITION}; {READINGS}")
        found["lit"] = run(
            talk,
            "[...new Set([...document.querySelectorAll('td.now[data-q=position]')].map(x => x.dataset.k))]",
        )
        found["keys"] = keys(talk)
        found["plans"] = run(talk, PLANS)
        found["said_on_plan"] = run(
            talk, "document.getElementById(Object.keys(known.plans)[0]).querySelector('.over').textContent"
        )
        found["explained"] = run(talk, EXPLAINED % "x => formulaOf(x.dataset.q, x.dataset.k, x.dataset.t)")
        found["titles"] = run(
            talk,
            "[...document.querySelectorAll('main figure svg')].map(s => s.querySelector('title')?.textContent ?? '')",
        )
        found["side"] = run(
            talk,
            "[document.querySelectorAll('.side a').length, document.querySelectorAll('nav.contents a').length]",
        )
        found["copied"] = run(talk, COPIED)
        found["labels"] = run(talk, LABELS) if name == "compressor" else []
        found["played"] = run(talk, PLAYED)
        found["narrow"] = narrow(talk)
        found |= {"asked": talk_asked(talk), "said": talk_said(talk)}
        return found


@contextmanager
def opened(text: str, scripts: bool = True, wide: int = 1366) -> Iterator[Talk]:
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder, browser(Path(folder)) as talk:
        file = Path(folder) / "note.html"
        file.write_text(text, encoding="utf-8")
        target = talk.ask("Target.createTarget", url="about:blank", width=wide, height=768, newWindow=True)
        talk.session = talk.ask("Target.attachToTarget", **target, flatten=True)["sessionId"]
        talk.events.clear()
        for domain in ("Page", "Runtime", "Log", "Network"):
            talk.ask(f"{domain}.enable")
        size(talk, wide)
        talk.ask("Emulation.setScriptExecutionDisabled", value=not scripts)
        talk.ask("Page.navigate", url=file.as_uri())
        talk.wait_for("Page.loadEventFired")
        yield talk
        talk.session = None
        talk.ask("Target.closeTarget", **target)


def size(talk: Talk, wide: int) -> None:
    talk.ask(
        "Emulation.setDeviceMetricsOverride", width=wide, height=768, deviceScaleFactor=1, mobile=wide < 600
    )


def run(talk: Talk, code: str) -> Any:
    """The last of the statements of the page's own scope."""
    answer = talk.ask("Runtime.evaluate", expression=code, awaitPromise=True, returnByValue=True)
    assert "exceptionDetails" not in answer, answer["exceptionDetails"]
    return answer["result"].get("value")


def talk_asked(talk: Talk) -> list[str]:
    """All but the page itself and what it carries within."""
    asked = [event["params"]["request"]["url"] for event in talk.of("Network.requestWillBeSent")]
    return [url for url in asked if not url.startswith("data:")][1:]


def talk_said(talk: Talk) -> list[str]:
    events = talk.of("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")
    return [json.dumps(event["params"]) for event in events]


OPEN = "document.querySelector('.readings').open = true"
GO = "show(cycle.at[cycle.numbered[%d]])"
READINGS = """
Object.fromEntries([...document.querySelectorAll('.readings td[data-now]')].map(x => [x.dataset.now, x.textContent]))
"""
# places of the joints as they are drawn, in every position and three times between two
LENGTHS = """
(() => {
  const rows = [];
  for (let i = 0; i < last; i++) for (const s of [0, 0.25, 0.5, 0.75]) {
    show(cycle.at[i] + s * (cycle.at[i + 1] - cycle.at[i]));
    const marks = [...document.querySelectorAll('.scheme circle[data-point]')].filter(m => m.style.display !== 'none');
    const centre = m => [Number(m.getAttribute('cx')), Number(m.getAttribute('cy'))];
    rows.push(Object.fromEntries(marks.map(m => [m.dataset.point, centre(m)])));
    // the link itself, by its own transform
    for (const g of document.querySelectorAll('.scheme g.link')) if (g.style.display !== 'none') {
      const m = g.transform.baseVal.consolidate().matrix;
      rows.at(-1)[`link ${g.dataset.link}`] = [m.a, m.b, m.c, m.d, m.e, m.f];
    }
  }
  show(cycle.at[0]);
  return rows;
})()
"""
PLANS = """
(() => {
  const [anchor, plan] = Object.entries(known.plans)[0];
  const figure = document.getElementById(anchor);
  const shape = () => figure.querySelector('svg').outerHTML;
  figure.scrollIntoView();
  return new Promise(done => setTimeout(() => {
    show(cycle.at[plan.position]);
    const was = shape();
    show(cycle.at[(plan.position + 5) % last]);
    const moved = shape();
    show(cycle.at[plan.position]);
    const back = shape();
    show(cycle.at[(plan.position + 5) % last]);
    dispatchEvent(new Event('beforeprint'));
    const print = shape();
    dispatchEvent(new Event('afterprint'));
    done([was !== moved, was === back, was === print]);
  }, 400));
})()
"""
EXPLAINED = """
(async () => {
  const cells = [...document.querySelectorAll('main td[data-q]')].filter(x => x.dataset.q !== 'position');
  const cell = cells.find(%s);
  cell.click();
  while (!document.querySelector('dialog.told')) await new Promise(done => setTimeout(done, 20));
  const box = document.querySelector('dialog.told');
  const count = what => box.querySelectorAll(what).length;
  const all = what => [...box.querySelectorAll(what)].map(x => x.textContent);
  const found = [count('math'), box.textContent.includes(cell.textContent), count('script'),
    all('.formula a'), all('li')];
  box.close();
  return found;
})()
"""
COPIED = """
copied([...document.querySelectorAll('main table')].find(
  t => /−\\d.*−\\d/s.test(t.textContent) && t.querySelector('[data-q=position]')), true)
"""
# how far apart the numbers at the cursor of a diagram with several curves stand, mm
LABELS = """
(async () => {
  const [anchor] = Object.entries(known.charts).find(([, c]) => c.panels.some(p => p.curves.length > 1));
  const figure = document.getElementById(anchor);
  figure.scrollIntoView();
  await new Promise(done => setTimeout(done, 300));
  return cycle.at.flatMap(at => {
    show(at);
    const texts = [...figure.querySelectorAll('.cursor text')].filter(x => x.style.display !== 'none');
    const ys = texts.map(x => Number(x.getAttribute('y'))).sort((a, b) => a - b);
    return ys.slice(1).map((y, k) => y - ys[k]);
  });
})()
"""
PLAYED = """
new Promise(done => {
  const from = where.at;
  const times = [];
  play();
  const tick = now => {
    times.push(now);
    times.length < 40 ? requestAnimationFrame(tick) : (stop(), done([where.at !== from, times]));
  };
  requestAnimationFrame(tick);
})
"""


def dragged(talk: Talk, k: int) -> list[Any]:
    """The end of the crank taken by the mouse and led round to where position k has it."""
    point = next(
        p for p, (link, *_) in data("compressor")["mechanism"]["points"].items() if p == "A" and link == "1"
    )
    spot = f"""(() => {{
      const svg = document.querySelector('.scheme');
      const at = new DOMPoint(place('{point}')[0], -place('{point}')[1]).matrixTransform(svg.getScreenCTM());
      return [at.x, at.y];
    }})()"""
    run(talk, GO % 4)
    way = []
    for step in (4, 5, 6, k):
        way.append(run(talk, f"elsewhere(cycle.numbered[{step}], 0, () => {spot})"))
    mouse(talk, "mousePressed", way[0])
    for at in way[1:]:
        mouse(talk, "mouseMoved", [at[0] + 0.4, at[1] - 0.4])  # no hand is exact
    mouse(talk, "mouseReleased", way[-1])
    return [run(talk, "position()"), run(talk, f"cycle.numbered[{k}]"), run(talk, READINGS)]


def mouse(talk: Talk, kind: str, at: list[float]) -> None:
    talk.ask("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left", buttons=1, clickCount=1)


def keys(talk: Talk) -> list[int]:
    """The numbered positions after the arrow to the right, twice, and to the left."""
    run(talk, f"{GO % 2}; document.querySelector('.scheme').focus()")
    found = []
    for key in ("ArrowRight", "ArrowRight", "ArrowLeft"):
        for kind in ("keyDown", "keyUp"):
            talk.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key)
        found.append(run(talk, "numbered()"))
    return found


def narrow(talk: Talk) -> list[float]:
    size(talk, 390)
    return run(
        talk,
        "new Promise(done => setTimeout(() => done([document.documentElement.scrollWidth, innerWidth]), 200))",
    )


# ------------------------------------------------------------ what was seen


def test_the_crank_dragged_to_a_position_shows_its_numbers():
    position, wanted, readings = seen("compressor")["dragged"]
    assert position == wanted
    same_as_printed(readings)


def same_as_printed(readings: dict[str, str]) -> None:
    """What the dock shows against the cells of the note at the position, by the digits of the cells."""
    cells = re.findall(
        rf'<td data-q="([^"]+)" data-k="{POSITION}" data-t="(\w+)_table">([^<]*)</td>', page("compressor")
    )
    known = data("compressor")["cycle"]["columns"]
    checked = 0
    for key, table, text in cells:
        if key in readings and any(c["key"] == key for c in known.get(table, ())) and _alone(key, known):
            printed, shown = number(text), number(readings[key])
            digits = len(text.partition(",")[2])
            assert abs(printed - shown) <= 0.51 * 10**-digits + 1e-4 * abs(shown), (key, text, readings[key])
            checked += 1
    assert checked > 15


def _alone(key: str, columns: dict[str, Any]) -> bool:
    return sum(c["key"] == key for of in columns.values() for c in of) == 1


def number(text: str) -> float:
    return float(text.replace("\u2212", "-").replace(",", ".").replace("\u202f", "").replace("\xa0", ""))


@pytest.mark.parametrize("name", NAMES)
def test_links_keep_their_lengths_in_every_position(name):
    """By the marks of the joints and by the transforms of the links, against the lengths that the variant states."""
    mechanism, scale = solved(name).lever.given.mechanism.real, data(name)["mechanism"]["scale"]
    rows = seen(name)["lengths"]
    assert len(rows) == 4 * (len(data(name)["cycle"]["at"]) - 1)
    checked = 0
    for link, of in mechanism.links.items():
        names = list(of.points)
        for row in rows:
            for a, b in pairwise(names):
                if a in row and b in row:
                    long = abs(complex(of.points[a]) - complex(of.points[b])) / scale
                    assert math.dist(row[a], row[b]) == pytest.approx(long, abs=0.01), (link, a, b)
                    checked += 1
            if (matrix := row.get(f"link {link}")) is not None:
                for point, at in of.points.items():
                    local = complex(at) / scale
                    x = matrix[0] * local.real + matrix[2] * local.imag + matrix[4]
                    y = matrix[1] * local.real + matrix[3] * local.imag + matrix[5]
                    if point in row:
                        assert math.dist(row[point], (x, y)) < 0.01, (link, point)
    assert checked > len(rows)


@pytest.mark.parametrize("name", NAMES)
def test_the_page_asks_for_nothing_and_complains_of_nothing(name):
    assert seen(name)["asked"] == [] and seen(name)["said"] == []


@pytest.mark.parametrize("name", NAMES)
def test_rows_and_keys_follow(name):
    found = seen(name)
    count = len(data(name)["cycle"]["numbered"]) - 1
    assert str(POSITION % count) in found["lit"] or str(POSITION) in found["lit"]
    assert found["keys"] == [3, 4, 3]


@pytest.mark.parametrize("name", NAMES)
def test_plans_move_and_come_back_for_print(name):
    assert seen(name)["plans"] == [True, True, True]


def test_a_plan_of_another_position_says_of_which():
    """Its caption names the position in which it was constructed."""
    assert re.fullmatch(r"φ = [\d,.]+°(, 0[,.]\d+ : 1)?", seen("compressor")["said_on_plan"])


def test_a_click_tells_how_a_number_comes_about():
    formulas, number_there, scripts, *_ = seen("compressor")["explained"]
    assert formulas >= 1 and number_there and scripts == 0


def test_a_click_follows_formulas_to_what_they_begin_with():
    """From the page itself: what a formula needs stands before it, and what nothing defines is listed once."""
    *_, numbers, begins = seen("compressor")["explained"]
    assert numbers and begins and len(set(begins)) == len(begins)


def test_figures_have_names_and_the_side_has_the_contents():
    found = seen("compressor")
    assert all(found["titles"]) and not any("<" in one for one in found["titles"])
    assert found["side"][0] == found["side"][1] > 10


def test_a_table_copies_as_numbers():
    rows = [line.split("\t") for line in seen("compressor")["copied"].split("\r\n")]
    cells = [cell for row in rows[1:] for cell in row]
    assert len({len(row) for row in rows}) == 1 and any(cell.startswith("-") for cell in cells)
    assert all(
        float(cell.replace(",", ".")) is not None for cell in cells if cell and cell[0] in "-0123456789"
    )
    assert not any("\u2212" in cell for cell in cells)


def test_numbers_at_a_cursor_stand_apart():
    """Also where the curves of a diagram run together."""
    assert len(seen("compressor")["labels"]) > 30 and min(seen("compressor")["labels"]) > 2.9


def test_it_plays():
    moved, times = seen("compressor")["played"]
    assert moved and len(times) == 40


@pytest.mark.parametrize("name", NAMES)
def test_a_narrow_window_scrolls_sideways_nowhere(name):
    wide, window = seen(name)["narrow"]
    assert wide <= window == 390


def test_with_scripts_off_the_page_is_the_note():
    with opened(page("compressor"), scripts=False) as talk:
        talk.ask("Emulation.setScriptExecutionDisabled", value=False)
        found = run(
            talk,
            "[document.documentElement.className, document.querySelectorAll('.dock, .side, button').length, "
            "getComputedStyle(document.querySelector('main')).backgroundColor]",
        )
    assert found == ["", 0, "rgb(255, 255, 255)"]


def test_little_motion_steps_from_position_to_position():
    with opened(page("compressor")) as talk:
        talk.ask(
            "Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}]
        )
        run(talk, f"{GO % 1}; play()")
        found = run(
            talk,
            "new Promise(done => setTimeout(() => "
            "(stop(), done([position() === cycle.numbered[numbered()], numbered()])), 600))",
        )
    assert found[0] and found[1] in (1, 2)


def test_the_languages_have_their_decimal_sign():
    assert data("compressor")["decimal"] == ("," if read("compressor").language == "ru" else ".")
