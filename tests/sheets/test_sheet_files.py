"""The files of the sheets as other programs read them: DXF by ezdxf, PDF by its own objects."""

from __future__ import annotations

import io
import re
from zlib import decompress

import pytest
from conftest import path_of, solved
from drawn import SOME, files_of, sheets_of
from exhaustive import many
from test_drawing_sheets import A1, HOSTILE, stamped
from typer.testing import CliRunner

from tmm_report import sheets
from tmm_report.cli import app
from tmm_report.commands.files import translator
from tmm_report.figures.drawing import Arrow, Circle
from tmm_report.figures.sheets.pdf import pdf
from tmm_report.figures.sheets.sheet import Sheet


@pytest.fixture
def ezdxf():
    return pytest.importorskip("ezdxf")


def read(ezdxf, text: bytes):
    return ezdxf.read(io.StringIO(text.decode("utf-8")))


@pytest.mark.parametrize("name", many(SOME))
def test_dxf_is_whole_and_in_true_millimetres(ezdxf, name):
    for sheet in sheets_of(name):
        drawn = read(ezdxf, files_of(name)[f"sheets/{sheet.name}.dxf"])
        audit = drawn.audit()
        assert not audit.errors and not audit.fixes
        assert drawn.header["$INSUNITS"] == 4
        entities = drawn.modelspace()
        lengths = sorted((one.dxf.end - one.dxf.start).magnitude for one in entities.query("LINE"))
        arrows = [item for block in sheet.blocks for item in block.items if isinstance(item, Arrow)]
        for arrow in arrows:
            assert min(abs(abs(arrow.end - arrow.start) - one) for one in lengths) < 1e-6
        circles = [
            item for block in sheet.blocks for item in block.items if isinstance(item, Circle) and item.pen
        ]
        assert len(entities.query("CIRCLE")) == len(circles)


@pytest.mark.parametrize("name", many(("cam_press", "compressor")))
def test_dxf_has_layers_by_line_and_text_as_text(ezdxf, name):
    for sheet in sheets_of(name):
        drawn = read(ezdxf, files_of(name)[f"sheets/{sheet.name}.dxf"])
        texts = list(drawn.modelspace().query("TEXT"))
        runs = [(letters, run) for letters in sheet.letters for run in letters.runs]
        assert [one.dxf.text for one in texts] == [run.text for _, run in runs]
        for one, (letters, run) in zip(texts, runs, strict=True):  # as wide as its strokes in any face
            kind, start, end = one.get_placement()
            assert kind.name == "FIT"
            assert abs(end - start) == pytest.approx(letters.squeeze * run.wide, abs=1e-6)
        assert min(one.dxf.height for one in texts) >= 3.5
        types = {one.dxf.name: one.dxf.linetype for one in drawn.layers}
        assert (types["MAIN"], types["CENTRE"], types["DASHED"]) == (
            "CONTINUOUS",
            "GOST_CENTRE",
            "GOST_DASHED",
        )
        assert {one.dxf.layer for one in drawn.modelspace()} <= set(types)
        framed = [item for item in sheet.frame[0] if item.pen.width == 0.6]
        lines = sum(len(item.strokes) for item in framed)
        assert len(drawn.modelspace().query('*[layer=="FRAME"]')) == lines


def test_the_designation_of_a_dxf_stands_on_its_head(ezdxf):
    """It begins at its right end, under the line on which its letters would stand upright."""
    from tmm_report.figures.sheets.cad import dxf

    sheet = Sheet("1_x", A1, (), stamped("ТММ.01.12.000"))
    texts = list(read(ezdxf, dxf(sheet)).modelspace().query("TEXT"))
    (one,) = [text for text in texts if text.dxf.rotation == 180]
    assert one.dxf.text == "ТММ.01.12.000" and 20 + 35 < one.dxf.insert.x < 20 + 70
    assert one.dxf.insert.y == pytest.approx(594 - 5 - 7 + one.dxf.height / 2)
    assert {other.dxf.rotation for other in texts if other is not one} == {0}


def test_dxf_is_drawn_by_the_library_itself(ezdxf):
    from ezdxf.addons.drawing import Frontend, RenderContext, layout
    from ezdxf.addons.drawing.svg import SVGBackend

    drawn = read(ezdxf, files_of("cam_press")["sheets/4_cam.dxf"])
    backend = SVGBackend()
    Frontend(RenderContext(drawn), backend).draw_layout(drawn.modelspace())
    text = backend.get_string(layout.Page(0, 0, layout.Units.mm))
    assert text.count("<path") > 20


@pytest.mark.parametrize("text", HOSTILE)
def test_nothing_in_a_name_is_a_command_of_dxf(ezdxf, text):
    from tmm_report.figures.sheets.cad import dxf

    drawn = read(ezdxf, dxf(Sheet("1_x", A1, (), stamped(text))))
    assert not drawn.audit().errors
    for one in drawn.modelspace().query("TEXT"):
        found = one.plain_text()
        assert "⌀" not in found and "\t" not in found and not re.search(r"(?<!%)%%(?=[^%])", one.dxf.text)


@pytest.mark.parametrize("name", many(SOME))
def test_pdf_has_a_page_a_sheet_of_its_size(name):
    text = files_of(name)["sheets/sheets.pdf"]
    boxes = [tuple(map(float, one.split())) for one in re.findall(rb"/MediaBox\[([^\]]*)\]", text)]
    sizes = [(one.format.wide, one.format.tall) for one in sheets_of(name)]
    assert [(x * 25.4 / 72, y * 25.4 / 72) for _, _, x, y in boxes] == [
        pytest.approx(one, abs=0.01) for one in sizes
    ]
    for place in re.findall(rb"^(\d{10}) 00000 n", text, re.M):  # every object is where the table says
        assert re.match(rb"\d+ 0 obj", text[int(place) :])


def test_lines_of_the_pdf_are_those_of_the_sheet():
    text, [sheet] = files_of("hoist_drive")["sheets/sheets.pdf"], sheets_of("hoist_drive")
    page = decompress(re.search(rb"stream\n(.*?)\nendstream", text, re.S)[1]).decode()
    for block in sheet.blocks:
        for arrow in (item for item in block.items if isinstance(item, Arrow)):
            tip = arrow.parts[1].strokes[0][0]
            places = re.findall(r"(\S+) (\S+) m", page)
            assert min(abs(complex(float(x), float(y)) - tip) for x, y in places) < 0.001
    wide = re.search(r"(\S+) 0 0 \S+ \S+ \S+ cm", page)
    assert float(wide[1]) == pytest.approx(72 / 25.4)


def test_a_pdf_of_hostile_names_opens():
    sheet = Sheet("1_x", A1, (), stamped(HOSTILE[0]))
    text = pdf([sheet.drawing], HOSTILE[0])
    assert text.count(b"endobj") == 5 and b"<script" not in text


def test_the_same_bytes_twice():
    results = solved("hoist_drive")
    assert sheets.render(results, translator(results.variant)) == files_of("hoist_drive")


def test_the_command_writes_the_sheets_and_says_what_dxf_needs(tmp_path, monkeypatch):
    monkeypatch.setattr(sheets, "find_spec", lambda name: None)
    monkeypatch.chdir(tmp_path)
    ended = CliRunner().invoke(app, ["solve", str(path_of("rotor")), "--format", "sheets", "-o", "made"])
    assert ended.exit_code == 0
    names = sorted(one.name for one in (tmp_path / "made" / "sheets").iterdir())
    assert names == ["1_machine.svg", "sheets.pdf"]
    assert "tmm-report[sheets]" in ended.stderr
