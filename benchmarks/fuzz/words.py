"""What mutations put into a variant: hostile texts, odd numbers, units, letters that look like others."""

from __future__ import annotations

from tmm_report.quantity.units import DIMENSIONS

HOSTILE = (
    "<script>alert(1)</script>", '" onmouseover="alert(1)', "</text><script/>", "\\input{/etc/passwd}",
    "^^5cinput{x}", "\\end{document}", "50% & #1 _x^ {~} $5 \\", "{{ 7*7 }}{% for i in x %}", "%(name)s %s %d",
    "{x.__class__}", '=HYPERLINK("http://x")', "Ivanov $\\frac{1}{", "\u202eabc", "a\u0301\u0301", "\x7f", "\ud7ff",
    "\U0001f600", "é" * 12, "0", "00", "-", "'", "''", "A-B", "1-2", "__init__", "None", "nan", "a" * 300, "ß" * 12,
    "../../x", "x/y", "%", "%%", "{", "}", "#", ",", "yes", "on", "~", "null", "!!python/object", "&a", "*a", "<<",
    "12:30", "0x1f", "1e3", "١٢", "＋", "\u00a0", "\u200b", "\ufeff", "ⅷ", "Å", "İ", "ς",
)  # fmt: skip

NUMBERS = (
    "0", "-0.0", "1", "-1", "2", "3", "0.5", "1e-300", "1e-12", "1e-9", "1e-6", "1e6", "1e12", "1e300", "-1e300",
    "1e400", "nan", ".nan", ".inf", "-.inf", "0x10", "1_000", "017", "1,5", "1.5.5", "٣", "9" * 400, "1/3", "7/0",
    "0/0", "3.141592653589793", "1e", "+5", "--5", "5-", "1e-400", "179.99999999 deg", "90 deg", "360 deg", "2.5 %",
)  # fmt: skip

UNITS = (
    "mm", "cm", "m", "km", "um", "rad", "deg", "°", "rad/s", "rpm", "об/мин", "мм", "м", "kg", "кг", "t", "g", "N",
    "kN", "Н", "кН", "N*m", "Н·м", "Pa", "MPa", "МПа", "s", "ms", "kg*m^2", "m/s", "m/s^2", "%", "W", "kW", "J", "1/s",
    "N/m", "N*s/m", "mm^2", "kg*m^9", "m^-1", "m^999999", "kg/kg", "m/0", "kg**m", "·", "N/m/s", "unit", "Å",
    *(dimension.unit for dimension in DIMENSIONS.values()),
)  # fmt: skip

ALIKE = {
    **dict(zip("ABCEHKMOPTXaceopxy", "АВСЕНКМОРТХасеорху", strict=True)),
    **dict(zip("АВСЕНКМОРТХасеорху", "ABCEHKMOPTXaceopxy", strict=True)),
    "'": "’", "-": "−", ":": "：", ",": "‚", "0": "О", "1": "l", ".": "․", " ": "\u00a0", '"': "“",
}  # fmt: skip
"""A letter -> one that looks like it."""

MARKS = ":,.-'\"{}[]#&*!|>%@`?~\\\t\n \r\0\x85\u2028()=+/^"
