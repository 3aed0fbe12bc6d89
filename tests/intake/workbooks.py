"""XLSX files written by hand, as programs other than ours write them, and as attackers do."""

from __future__ import annotations

from collections.abc import Mapping

from packing import packed

MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
RELATIONS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
HEAD = '<?xml version="1.0" encoding="UTF-8"?>'


def cells(*rows: str) -> str:
    """A worksheet of rows, each the text of its cells."""
    data = "".join(f'<row r="{number}">{row}</row>' for number, row in enumerate(rows, 1))
    return f'{HEAD}<worksheet xmlns="{MAIN}"><sheetData>{data}</sheetData></worksheet>'


def strings(*items: str) -> str:
    return f'{HEAD}<sst xmlns="{MAIN}">{"".join(f"<si>{item}</si>" for item in items)}</sst>'


def inline(text: str) -> str:
    return f'<c t="inlineStr"><is><t>{text}</t></is></c>'


def parts(
    sheet: str | bytes, shared: str = strings(), styles: str = "", *, names: tuple[str, ...] = ("S",)
) -> dict[str, bytes]:
    """The parts of a workbook; each of its sheets is the same."""
    listed = "".join(f'<sheet name="{name}" sheetId="{n}" r:id="rId1"/>' for n, name in enumerate(names, 1))
    related = "".join(
        f'<Relationship Id="rId{n}" Type="{RELATIONS}/{kind}" Target="{target}"/>'
        for n, (kind, target) in enumerate(
            [
                ("worksheet", "worksheets/sheet1.xml"),
                ("sharedStrings", "/xl/sharedStrings.xml"),
                ("styles", "styles.xml"),
            ],
            1,
        )
    )
    book = f'{HEAD}<workbook xmlns="{MAIN}" xmlns:r="{RELATIONS}"><sheets>{listed}</sheets></workbook>'
    first = f'<Relationship Id="r" Type="{RELATIONS}/officeDocument" Target="xl/workbook.xml"/>'
    made: Mapping[str, str | bytes] = {
        "[Content_Types].xml": "<Types/>", "_rels/.rels": f"<Relationships>{first}</Relationships>",
        "xl/workbook.xml": book,
        "xl/_rels/workbook.xml.rels": f"<Relationships>{related}</Relationships>", "xl/worksheets/sheet1.xml": sheet,
        "xl/sharedStrings.xml": shared, "xl/styles.xml": styles or f'<styleSheet xmlns="{MAIN}"/>',
    }  # fmt: skip
    return {name: text.encode() if isinstance(text, str) else text for name, text in made.items()}


def workbook(sheet: str | bytes, shared: str = strings(), styles: str = "", **options) -> bytes:
    return packed(parts(sheet, shared, styles, **options))
