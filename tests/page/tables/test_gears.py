"""Tables of gears: what is a quotient, product or difference of other cells is so; speeds obey Willis."""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterator
from typing import Any

import pytest
from note import Note, Table
from pages import rows_of
from printed import Printed, unit
from reading import CHOSEN, LEVERS, html, results, wrong

GEARS = [name for name in CHOSEN if name not in LEVERS or name == "compressor"]


def at(table: Table, symbol: str) -> int:
    return next(j for j, head in enumerate(table.heads) if head.symbol == symbol)


def cells(table: Table, *symbols: str) -> Iterator[tuple[str, list[Printed]]]:
    """Of each row the name and the numbers under these symbols, where all are numbers."""
    for row in table.rows:
        found = [row[at(table, symbol)].printed for symbol in symbols]
        if all(x is not None and math.isfinite(x.value) for x in found):
            yield row[0].text, [x for x in found if x is not None]


def differs(one: float, other: float, *off: float) -> bool:
    return abs(one - other) > sum(off) + 1e-9


def wrong_speeds(note: Note, document: dict[str, Any]) -> Iterator[str]:
    for table in rows_of(note, "ω", "n"):
        for name, (omega, n) in cells(table, "ω", "n"):
            if differs(n.value, omega.value * 30 / math.pi, n.half, omega.half * 10):
                yield f"n of {name} is {n.value}, 30 ω/π is {omega.value * 30 / math.pi:.6g}"
    for table in rows_of(note, "T", "ω", "N"):
        total = rounded = 0.0
        for name, (torque, omega, power) in cells(table, "T", "ω", "N"):
            total, rounded = total + power.value, rounded + power.half
            off = torque.half * abs(omega.value) + omega.half * abs(torque.value) + power.half
            if differs(power.value, torque.value * omega.value, off):
                yield f"N of {name} is {power.value}, T ω is {torque.value * omega.value:.6g}"
        letter = next((one for one in ("N_тр", "N_fr") if any(rows_of(note, one))), "")
        lost = [n for t in rows_of(note, letter) for _, (n,) in cells(t, letter)] if letter else []
        losses = sum(n.value for n in lost)
        if lost and differs(total, losses, rounded, *(n.half for n in lost)):
            yield f"supplied powers add up to {total:.5g} W, {losses:.5g} W are lost"


def wrong_meshes(note: Note, document: dict[str, Any]) -> Iterator[str]:
    for table in note.tables:
        symbols = [head.symbol for head in table.heads]
        if symbols[-3:] not in (["N", "N_тр", "η"], ["N", "N_fr", "η"]):
            continue
        of = next(cell.mark.table for cell in table.rows[0] if cell.mark)
        flows = {c["key"]: c["values"] for c in document["tables"][of]["columns"]}
        for row, flow in zip(table.rows, flows["N"], strict=True):
            power, lost, eta = (cell.printed for cell in row[-3:])
            assert power and lost and eta
            if differs(eta.value, 1 - lost.value / power.value, eta.half, lost.half / power.value + 1e-4):
                yield f"η of {row[0].text} is {eta.value}, by the powers {1 - lost.value / power.value:.5g}"
            one, other = row[0].text.split("–")
            if row[-4].text != (one if flow > 0 else other):
                yield f"{row[0].text} is driven by {row[-4].text}, its power is {flow}"


def wrong_wheels(note: Note) -> Iterator[str]:
    """Diameters in proportion to teeth; tips beyond pitch circles beyond roots, a ring's the other way round."""
    for table in rows_of(note, "z", "d", "d_b"):
        rows = list(cells(table, "z", "d", "d_b", "d_a", "d_f"))
        for (one, a), (other, b) in itertools.pairwise(rows):
            for symbol, i in (("d", 1), ("d_b", 2)):
                off = a[i].off / a[0].value + b[i].off / b[0].value
                if differs(a[i].value / a[0].value, b[i].value / b[0].value, off):
                    yield f"{symbol} of {one} and {other} are not as their teeth"


def wrong_family(note: Note) -> Iterator[str]:
    """Willis: the speeds about the carrier keep their ratio, whichever member is stopped."""
    for table in note.tables:
        symbols = [head.symbol for head in table.heads]
        if not {"ω_H", "ω_1"} <= {symbol.split("/")[0] for symbol in symbols} and "ω_H" not in symbols:
            continue
        members = [s for s in symbols if s.startswith("ω_") and not s.startswith("ω_H")]
        carrier = next((s for s in symbols if s.startswith("ω_H")), None)
        if carrier is None or len(members) < 2:
            continue
        rows = [numbers for _, numbers in cells(table, carrier, *members)]
        for i in range(2, len(members) + 1):
            found = {}
            for k, (held, first, *others) in enumerate(rows):
                about, other = first.value - held.value, others[i - 2].value - held.value
                found[k] = (other, about, held.half + others[i - 2].half, held.half + first.half)
            (a, b, da, db), *rest = found.values()
            for c, d, dc, dd in rest:
                off = abs(a) * dd + abs(d) * da + abs(b) * dc + abs(c) * db
                if abs(a * d - b * c) > off * 1.01 + 1e-9:
                    yield f"{table.caption}: {members[i - 1]} and {members[0]} about the carrier"


def wrong_motions(document: dict[str, Any]) -> Iterator[str]:
    """The ratio of a motion is the input's speed to the output's."""
    for name, table in document["tables"].items():
        columns = {c["key"]: c["values"] for c in table["columns"]}
        if not name.endswith("_motions") or not {"input", "output", "u"} <= columns.keys():
            continue
        for k, (one, other, u) in enumerate(
            zip(columns["input"], columns["output"], columns["u"], strict=True)
        ):
            out = columns[f"omega_{other}"][k]
            if u is not None and abs(u * out - columns[f"omega_{one}"][k]) > 1e-9 * abs(u * out):
                yield f"{name} row {k}: u is {u}, the output turns at {out}"


def wrong_teeth(document: dict[str, Any]) -> Iterator[str]:
    """About the axes of an eccentric mechanism all wheels roll: satellites and ring against the sun."""
    if "eccentric_speeds" not in document["tables"]:
        return
    teeth = {c["key"]: c["values"] for c in document["tables"]["eccentric_satellites"]["columns"]}
    count = dict(zip(teeth["wheel"], teeth["z"], strict=True))
    whole = {entry["key"]: entry["value"] for entry in document["values"]}
    speeds = {c["key"]: c["values"] for c in document["tables"]["eccentric_speeds"]["columns"]}
    for wheel, z in {**count, "3": whole["eccentric_z3"]}.items():
        for k, held in enumerate(speeds["omega_H"]):
            about, sun = speeds[f"omega_{wheel}"][k] - held, speeds["omega_1"][k] - held
            if abs(about * z + sun * whole["eccentric_z1"]) > 1e-9 * abs(about * z):
                yield f"wheel {wheel}, row {k}: {about:.6g} about the axes, the sun {sun:.6g}"


def wrong_loads(document: dict[str, Any]) -> Iterator[str]:
    """Forces of an eccentric mechanism: on each satellite no moment about its centre; on the wheels the moments."""
    if "eccentric_loads" not in document["tables"]:
        return
    whole = {entry["key"].removeprefix("eccentric_"): entry["value"] for entry in document["values"]}
    loads, places = (
        {c["key"]: c["values"] for c in document["tables"][f"eccentric_{name}"]["columns"]}
        for name in ("loads", "satellites")
    )
    tan, sense = math.tan(math.radians(whole["alpha"])), math.copysign(1, whole["M_1"])
    one, other = 0j, 0j
    for k, force in enumerate(loads["F_t"]):
        n1, n3 = (cmath.exp(1j * math.radians(places[key][k])) for key in ("phi1", "phi3"))
        on_sun, on_ring = -force * (sense * 1j + tan) * n1, -force * (sense * 1j - tan) * n3
        one, other = one + on_sun, other + on_ring
        for what, number, right in (
            ("F_n", loads["F_n"][k], abs(on_sun)),
            ("Q", loads["Q"][k], abs(on_sun + on_ring)),
        ):
            if abs(number - right) > 1e-9 * right:
                yield f"{what} of satellite {loads['wheel'][k]}: {number:.8g}, should be {right:.8g}"
    total = sum(loads["F_t"]) * sense
    rights = {"R_1": abs(one), "R_3": abs(other), "M_1": total * whole["r_1"], "M_3": total * whole["r_3"]}
    for key, right in (rights | {"M_H": -rights["M_1"] - rights["M_3"]}).items():
        if abs(whole[key] - right) > 1e-9 * abs(total) * (1 if key.startswith("R") else whole["r_3"]):
            yield f"{key}: {whole[key]:.8g}, should be {right:.8g}"


def wrong_margins(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """What is in hand is the difference of value and limit."""
    for name, table in document["tables"].items():
        columns = {c["key"]: c["values"] for c in table["columns"]}
        hand = columns.get("margin", columns.get("in_hand"))
        if hand is None or "limit" not in columns or "value" not in columns:
            continue
        for k, (value, limit, margin) in enumerate(
            zip(columns["value"], columns["limit"], hand, strict=True)
        ):
            if None not in (value, limit, margin) and differs(
                abs(margin), abs(value - limit), 1e-9 * abs(limit)
            ):
                yield f"{name} row {k}: {value} and {limit} leave {margin}"
            met = columns.get("met")
            if met and margin is not None and bool(met[k]) != (margin >= -1e-9):
                yield f"{name} row {k}: met is {met[k]}, in hand {margin}"


@pytest.mark.parametrize("name", GEARS)
def test_tables_of_gears_agree_with_themselves(name):
    note, document = html(name), results(name)
    found = [*wrong_speeds(note, document), *wrong_meshes(note, document), *wrong_wheels(note)]
    found += [*wrong_motions(document), *wrong_teeth(document), *wrong_loads(document)]
    wrong([*found, *wrong_family(note), *wrong_margins(note, document)])


@pytest.mark.parametrize("name", GEARS)
def test_ratio_is_the_product_of_the_stages(name):
    document = results(name)
    if "drive_stages" in document["tables"]:
        columns = {c["key"]: c["values"] for c in document["tables"]["drive_stages"]["columns"]}
        whole = {entry["key"]: entry["value"] for entry in document["values"]}
        assert math.isclose(whole["drive_u_teeth"], math.prod(columns["u"]), rel_tol=1e-9)
        assert math.isclose(whole["drive_eta"], math.prod(columns["eta"]), rel_tol=1e-9)


def test_units_of_the_gears_are_known():
    for name in GEARS[:1]:
        for table in html(name).tables:
            for head in table.heads:
                assert not head.unit_text or unit(head.unit_text) is not None
