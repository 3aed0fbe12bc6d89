"""What the Russian reference says. Meanings come from templates/locale/ru/format.yaml, units from the catalogue."""

from __future__ import annotations

from format_reference import Words

from tmm_report.quantity.text import unit_text
from tmm_report.variant.editor import limits, meaning
from tmm_report.variant.russian import called

RUSSIAN = Words(
    head=("ключ", "что это", "единица", "по умолчанию", "пример"),
    one_of="одно из",
    list_of="список",
    required="*обязательно*",
    see="см.",
    language="ru",
    also="Те же ключи в",
    title="Все ключи формата",
    about="Составлено по схеме, которую печатает `tmm-report schema --lang ru`. Число без единицы понимается в единице "
    "столбца, то есть в СИ; текст с любой другой единицей того же рода пересчитывается "
    "([первый час](../first_hour.md)). *Курсивом* в столбце «по умолчанию» стоит не значение; «—» значит, что ключ "
    "можно опустить. `<имя>` — имя, которое даёте вы. Ключи пишутся по-английски: на русское слово из скобок "
    "программа подскажет ключ.",
    name="<имя>",
    meaning=lambda text: meaning(text, "ru"),
    limits=lambda text: limits(text, "ru"),
    unit=lambda unit: unit_text(unit, "ru"),
    called=called,
)
