"""Results asked by name: what comes is what results.json has, with its unit; strange texts break out of nothing."""

from __future__ import annotations

import copy
import json
import math
import pickle
import re

import numpy as np
import pytest
import yaml
from conftest import solved as plainly_solved
from exhaustive import many
from notes import NAMES, VARIANTS

import tmm_report
from tmm_report import load, render, solve, sweep
from tmm_report.interactive import solved as room
from tmm_report.interactive.numbers import Numbers
from tmm_report.interactive.solved import NotFound, Solved
from tmm_report.problems import ProblemError
from tmm_report.results import sought, tables, values

SHAPER = VARIANTS / "shaper.yaml"


@pytest.fixture(scope="module")
def shaper() -> Solved:
    return solve(load(SHAPER))


def document(results) -> dict:
    return json.loads(render(results, "json", "en")["results.json"])


@pytest.mark.parametrize("name", many(["shaper", "hoist_drive", "valve_cam", *NAMES], 3))
def test_every_number_of_the_results_comes_by_its_name(name):
    results = Solved.of(plainly_solved(name))
    told = document(results)
    for value in told["values"]:
        found = results[value["key"]]
        assert found.unit == value["unit"] and (isinstance(value["value"], str) or found == value["value"])
    for table, one in told["tables"].items():
        for column in one["columns"]:
            found = results[table, column["key"]]
            assert found.unit == column["unit"] and len(found) == len(column["values"])
            if found.dtype.kind in "iuf":
                np.testing.assert_array_equal(found, [math.nan if x is None else x for x in column["values"]])
            else:
                assert [str(x) for x in found] == [str(x) for x in column["values"]]


def test_a_name_alone_is_of_the_positions_of_the_table(shaper):
    assert shaper["v_B"].shape == (13,) and shaper["outputs_diagram", "V_D"].shape == (37,)
    assert (shaper["v_B"].symbol, shaper["v_B"].unit, shaper["v_B"].key) == ("v_B", "m/s", "v_B")
    assert shaper["omega3"].key == "omega_3" and shaper["M_ур"].key == "M_bal"  # as in an answer
    speed = np.hypot(shaper["v_B_x"], shaper["v_B_y"])
    np.testing.assert_allclose(shaper["v_B"], speed, rtol=1e-12, atol=1e-12)


def test_numbers_are_arrays_that_know_their_unit(shaper):
    stroke, speed = shaper["H_D"], shaper["v_B"]
    assert repr(stroke) == "H_D = 0.396 m" and f"{stroke:.2f}" == "0.40" and float(stroke.to("mm")) == 396.0
    assert isinstance(speed[2:5], Numbers) and speed[2:5].unit == "m/s"
    for reckoned in (speed * 2, speed**2, np.abs(speed), speed.max(), speed @ speed):
        assert not hasattr(reckoned, "unit")  # it may be another one
    assert speed.max() == max(speed.tolist())
    with pytest.raises(ValueError, match="not in 'kg'"):
        speed.to("kg")
    with pytest.raises(ValueError, match="read-only"):
        speed[0] = 1
    for twin in (pickle.loads(pickle.dumps(speed)), copy.deepcopy(speed)):
        assert twin.unit == "m/s" and (twin == speed).all()


@pytest.mark.parametrize(
    ("name", "near"),
    [("v_Q", "v_T"), (("outputs", "V_Z"), "V_D"), (("outpts", "V_D"), "outputs_table"), ("", "no quantity")],
)
def test_what_is_not_there_is_a_key_error_that_says_what_is_near(shaper, name, near):
    assert name not in shaper
    with pytest.raises(KeyError, match=re.escape(near)) as error:
        shaper[name]
    assert isinstance(error.value, NotFound) and "\n" not in str(error.value)


def test_the_names_can_be_listed(shaper):
    assert {"H_D", "v_B", "M_bal"} <= set(shaper) and "outputs_table" in shaper.tables
    assert [name for name in shaper if name not in shaper] == []


# ---------------------------------------------------------------- tables


def test_a_table_is_a_data_frame(shaper):
    pytest.importorskip("pandas")
    frame = shaper.table("outputs")
    assert frame.index.name == "position" and list(frame.index) == list(range(13))
    np.testing.assert_array_equal(frame["V_D"], shaper["outputs_table", "V_D"])
    assert frame.attrs["units"]["V_D"] == "m/s" and "velocity" in frame.attrs["meanings"]["V_D"]
    assert list(shaper.table("pairs")["kind"]) == list(shaper["pairs", "kind"])


def test_without_pandas_a_table_says_what_to_do(shaper, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "pandas", None)
    with pytest.raises(ImportError, match=r"pip install pandas.*r\[table, key\]"):
        shaper.table("outputs")
    with pytest.raises(NotFound):
        shaper.table("nonesuch")


# ---------------------------------------------------------------- figures


def test_a_figure_is_that_of_the_note(shaper, tmp_path):
    figure = shaper.figure("moment")
    assert figure.name == "balancing" and figure._repr_svg_().startswith("<svg")
    text = render(shaper, "html", depth="full")["note.html"].decode()
    assert len(shaper.figures) == text.count("<figcaption>") > 20
    drawn = re.sub("<title>.*?</title>", "", text)
    for name in ("moment", "scheme", "plans", "friction:moment"):
        own = re.sub("<title>.*?</title>", "", shaper.figure(name).svg)
        assert (
            own.partition("<path")[2].replace('"#000000"', '"#000"') in drawn
            and "<title>" in shaper.figure(name).svg
        )
    figure.save(tmp_path / "m.svg")
    assert (tmp_path / "m.svg").read_text("utf-8") == figure.svg
    figure.save(tmp_path / "m.png")
    assert (tmp_path / "m.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("scheme", "scheme"),
        ("plans", "v:2"),
        ("accelerations", "a:2"),
        (1, "one"),
        ("D", "travel:D"),
        ("xyz", None),
    ],
)
def test_a_figure_goes_by_its_name_number_or_caption(shaper, name, found):
    if found is None:
        with pytest.raises(NotFound, match="the note has no figure"):
            shaper.figure(name)
    else:
        assert shaper.figure(name).name == found


@pytest.mark.parametrize("name", many(NAMES, 4))
def test_every_note_gives_its_figures(name):
    results = Solved.of(plainly_solved(name))
    assert results.figures and all(results.figure(one).svg.startswith("<svg") for one in results.figures[:3])


# ---------------------------------------------------------------- in short


def test_reprs_are_short(shaper):
    for one in (
        shaper,
        shaper.variant,
        shaper["v_B"],
        shaper.figure("scheme"),
        sweep(SHAPER, {"positions.table": [12]}),
    ):
        assert len(repr(one)) < 250 and not re.search("object at|array\\(", repr(one))
    assert "I(0,1) → II2(2,3) → II2(4,5)" in repr(shaper)


def test_what_is_looked_for_first_agrees_with_the_whole_cycle():
    """The second way: of 720 positions the greatest, which the exact extreme passes by little and never falls below."""
    text = re.sub(r"positions: \{[^}]*\}", "positions: {table: 12, diagram: 720}", SHAPER.read_text("utf-8"))
    assert "720" in text
    results = solve(load(text))
    found = {value.key: value.value for value in sought(results)}
    seen = np.abs(results["outputs_diagram", "V_D"]).max()
    assert seen <= found["V_D_most"] * (1 + 1e-12) and found["V_D_most"] == pytest.approx(seen, rel=1e-4)
    moments = np.abs(results["balancing_diagram", "M_bal"]).max()
    assert moments <= found["M_bal_most"] * (1 + 1e-9) and found["M_bal_most"] == pytest.approx(
        moments, rel=2e-3
    )
    places = results["outputs_diagram", "S_D"]
    assert found["H_D"] == pytest.approx(places.max() - places.min(), rel=1e-5)


@pytest.mark.parametrize("name", many(["press_flywheel", *NAMES], 6))
def test_what_is_looked_for_first_is_short_and_of_the_results(name):
    results = plainly_solved(name)
    found, every = list(sought(results)), {value.key: value.value for value in values(results)}
    for table in tables(results):  # the numbers of a pair with friction are a table of one row
        every |= {f"{table.name}_{one.key}": one.values[0] for one in table.columns if len(one.values) == 1}
    assert len(found) <= 20 and all(math.isfinite(value.value) for value in found)
    assert [
        value.key for value in found if not value.key.endswith("_most") and every[value.key] != value.value
    ] == []
    assert {chapter.partition("_")[0] for chapter in every} - {"cam", "drive", "flywheel"} or found


@pytest.mark.parametrize(
    "hostile", ["<script>alert(1)</script>", "'\"><img src=x onerror=alert(1)>", "&lt;b&gt;"]
)
def test_a_hostile_name_breaks_out_of_no_notebook(hostile):
    data = yaml.safe_load(SHAPER.read_text("utf-8"))
    data["title"]["topic"] = hostile
    shown = solve(load(data))._repr_html_()
    inside = re.sub("</?(table|tr|td|caption)( style='text-align:left')?>", "", shown)
    assert not re.search("[<>]", inside) and "caption" in shown


# ---------------------------------------------------------------- load


def test_a_path_a_text_and_a_dict_are_one_variant():
    text = SHAPER.read_text("utf-8")
    data = yaml.safe_load(text)
    data["mechanism"]["links"][1]["mass"] = np.float64(0)  # numbers of numpy are numbers
    one = render(solve(load(SHAPER)), "json")["results.json"]
    for source in (text, text.encode(), data, json.dumps(data, default=float), str(SHAPER)):
        assert render(solve(load(source)), "json")["results.json"] == one


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"title": {"topic": object()}}, "title.topic: a object is no value of a variant"),
        ({"mechanism": {"links": {1: {"points": {"O": 0, "A": {1, 2}}}}}}, "a set is no value"),
        ({"drawing": {"accuracy": math.inf}}, "inf"),
        ({}, "mechanism"),
    ],
)
def test_a_dict_with_mistakes_says_them(data, said):
    with pytest.raises(ProblemError, match=re.escape(said)):
        load(data)


def test_a_dict_without_end_is_refused():
    endless: dict = {}
    endless["mechanism"] = endless
    wide = {"mechanism": {"links": [0] * 30_000}}
    for data in (endless, wide):
        with pytest.raises(ProblemError):
            load(data)


# ---------------------------------------------------------------- sweep


def test_a_sweep_is_a_loop_of_single_variants():
    speeds, lengths = ["50 rpm", 6.0, "70 rpm"], ["100 mm", "90 mm"]
    found = sweep(load(SHAPER), {"mechanism.driver.speed": speeds, "mechanism.links.1.points.A": lengths})
    assert len(found) == 6 and found["v_B"].shape == (6, 13) and found["v_B"].unit == "m/s"
    for k, (speed, length) in enumerate((s, one) for s in speeds for one in lengths):
        data = yaml.safe_load(SHAPER.read_text("utf-8"))
        del data["mechanism"]["driver"]["speed" if "speed" in data["mechanism"]["driver"] else "period"]
        data["mechanism"]["driver"]["speed"], data["mechanism"]["links"][1]["points"]["A"] = speed, length
        alone = solve(load(data))
        for key in ("v_B", "M_bal", "H_D", "M_bal_max"):
            np.testing.assert_array_equal(found[key][k], alone[key])


def test_a_sweep_is_solved_over_the_stack(monkeypatch):
    from tmm_report.interactive import sweeps

    asked, each = [], sweeps.stack.solve_each
    monkeypatch.setattr(sweeps.stack, "solve_each", lambda them: asked.append(len(them)) or each(them))
    sweep(SHAPER, {"mechanism.driver.speed": ["50 rpm", "60 rpm", "70 rpm"]})
    assert asked == [3]


def test_one_value_that_may_not_stand_there_spoils_none_beside_it():
    found = sweep(SHAPER, {"mechanism.driver.speed": ["60 rpm", "fast", "1 kg"]})
    assert list(found.failed) == [1, 2] and "2 not solved" in repr(found)
    assert "mechanism.driver.speed" in str(found.failed[1]) and np.isnan(found["H_D"][1:]).all()
    assert found["H_D"][0] == solve(load(SHAPER))["H_D"]


@pytest.mark.parametrize(
    "path", ["mechanism.drivr.speed", "mechanism.driver.speed.x", "", "loads.forces.9.at"]
)
def test_a_path_that_the_file_has_not(path):
    with pytest.raises(ProblemError, match="there is no"):
        sweep(SHAPER, {path: [1]})


def test_the_size_of_a_sweep_is_bounded():
    for values_of in (
        {},
        {"positions.table": []},
        {"positions.table": range(200), "positions.diagram": range(200)},
    ):
        with pytest.raises(ValueError, match="combinations"):
            sweep(SHAPER, values_of)


def test_a_swept_table(monkeypatch):
    found = sweep(SHAPER, {"mechanism.driver.speed": ["60 rpm", "70 rpm"]})
    with pytest.raises(NotFound, match="goes by positions"):
        found.table("v_B")
    pandas = pytest.importorskip("pandas")
    frame = found.table("n_1", "H_D")
    assert isinstance(frame, pandas.DataFrame) and list(frame["n_1"].round(9)) == [60.0, 70.0]
    assert list(frame["mechanism.driver.speed"]) == ["60 rpm", "70 rpm"]


def test_the_rooms_say_what_they_do():
    assert tmm_report.__all__ == ["load", "render", "solve", "sweep"]
    assert "r[table, key]" in room.NO_PANDAS and all(
        getattr(tmm_report, name).__doc__ for name in tmm_report.__all__
    )


def test_what_is_reckoned_of_numbers_is_plain_and_has_no_unit(shaper):
    """A product is of another quantity: the name and the unit of its factor would be wrong of it."""
    numbers = next(one for one in map(shaper.__getitem__, ("omega_3", "phi_3")) if isinstance(one, Numbers))
    assert numbers.unit and type(numbers * 2) is np.ndarray and type(numbers**2 + numbers) is np.ndarray
