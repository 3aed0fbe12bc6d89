"""Value words of the format and their Russian twins, and the English of keys that are written in Russian.

`направление: против движения` is read as `against motion`; keys stay English: a Russian one is answered with it.
"""

from __future__ import annotations

from collections.abc import Collection

from tmm_report.variant.russian.keys import MORE


def _plain(text: str) -> str:
    """As words are compared: no capitals, and ё as it is often typed."""
    return " ".join(text.casefold().replace("_", " ").replace("ё", "е").split())


_TWINS: dict[str, str] = {
    "AC generator": "генератор переменного тока",
    "DC generator": "генератор постоянного тока",
    "after bearings": "после подшипников",
    "above": "над, над рейкой, над колесом, верхний",
    "against": "против вращения, против",
    "against motion": "против движения",
    "along motion": "по движению, вдоль движения",
    "along": "вдоль",
    "any": "любой, любая, любое",
    "auto": "авто, автоматически",
    "V": "клиновой, клиновая",
    "belt": "ремень, ременная",
    "bottom centre": "внизу по центру, внизу посередине",
    "bottom right": "внизу справа",
    "before bearings": "до подшипников",
    "below": "под, под рейкой, под колесом, нижний",
    "belt drive": "ременная передача",
    "bevel": "коническая",
    "carrier": "водило",
    "bronze": "бронза",
    "cast iron": "чугун",
    "centre": "по центру",
    "chain": "цепь, цепная",
    "chebyshev": "чебышев, чебышёв",
    "clockwise": "по часовой стрелке, по часовой, по ходу часовой стрелки",
    "closed form": "в конечном виде",
    "comma": "запятая",
    "constraints": "уравнения связей",
    "constraints corrected": "уравнения связей с поправкой",
    "constraints dop853": "уравнения связей dop853",
    "cosine": "косинусоидальный",
    "decreasing": "убывающий, линейно убывающий",
    "counter-clockwise": "против часовой стрелки, против часовой, против хода часовой стрелки",
    "couples": "пары",
    "course": "обычная, курсовая",
    "crossed": "перекрёстный, перекрёстная, перекрестный, перекрестная",
    "crank": "кривошип",
    "crusher": "дробилка",
    "differences": "разности",
    "down": "вниз, снизу, внизу, нижнее, крайнее нижнее",
    "drawing 0.01": "чертёж 0.01",
    "drawing 0.1": "чертёж 0.1",
    "drawing 0.5": "чертёж 0.5",
    "drive": "привод",
    "driving": "ведущая",
    "dstu": "ДСТУ",
    "dry": "сухое, сухая",
    "either": "любая из двух",
    "ends": "концы",
    "equal": "поровну, равное, равные",
    "equal sliding": "равное скольжение",
    "exact": "точно",
    "external": "внешнее",
    "external-external": "внешнее-внешнее",
    "external-internal": "внешнее-внутреннее",
    "first": "первый, первое",
    "flat": "плоский, плоская, тарелка, тарельчатый",
    "fourier": "фурье",
    "gost": "ГОСТ",
    "greatest": "наибольший",
    "friction": "фрикционная",
    "chosen": "выбрать, выбирается, выбран",
    "free": "свободно, свободный, свободное",
    "full": "полное, полный, полная",
    "indent": "с абзаца, с абзацного отступа",
    "incline": "наклонная плоскость",
    "inertia": "инерция",
    "internal": "внутреннее",
    "internal combustion engine": "двигатель внутреннего сгорания",
    "internal-internal": "внутреннее-внутреннее",
    "journal": "цапфа",
    "kz": "Казахстан",
    "knife": "острие, остриё, острый",
    "largest": "наибольший, наибольшая",
    "last": "последний, последнее",
    "left": "влево, слева, левое, крайнее левое",
    "level": "уровень",
    "limit": "предел",
    "long": "длинное",
    "machine tool": "станок",
    "main": "главный, главная",
    "mate": "сопряжённого",
    "mean": "средний",
    "mertsalov": "Мерцалов, Мерцалова",
    "middle": "середина, средний",
    "modified_sine": "модифицированный синусоидальный",
    "modified_trapezoid": "модифицированный трапецеидальный",
    "motor": "двигатель",
    "moving": "подвижный, подвижная",
    "newton": "ньютон",
    "none": "никакого",
    "off": "выключен, выкл",
    "on": "включен, включён, вкл",
    "open": "открытый, открытая",
    "optimum": "оптимум",
    "other": "другой, другая",
    "own": "своя",
    "parabolic": "параболический",
    "parallelogram": "параллелограмм",
    "piston compressor": "поршневой компрессор",
    "pivot": "пята, шарнир",
    "pivoted": "с неподвижными осями",
    "planetary": "планетарная",
    "plain": "простой, простое",
    "point": "точка",
    "polynomial": "степенной",
    "polynomial_4567": "степенной 4-5-6-7",
    "pump": "насос",
    "rated": "номинальная, по номинальной",
    "required": "требуемая, по требуемой",
    "rerikh": "Рерих, Рериха",
    "rack": "рейка, исходный контур",
    "rest": "покой, остальное, остаток",
    "reversed": "обратный",
    "wittenbauer": "Виттенбауэр, Виттенбауэра",
    "worm": "червячная",
    "right": "вправо, справа, правое, крайнее правое",
    "ring": "эпицикл",
    "roller": "ролик, роликовый",
    "root finder": "поиск корней",
    "rotors": "роторы",
    "rule": "правило",
    "screw": "винт",
    "section": "по разделам, в пределах раздела",
    "semi-fluid": "полужидкостное",
    "shift": "смещение",
    "shoe": "колодка",
    "list": "списком",
    "short": "короткая, краткая, короткое",
    "sine": "синусоидальный",
    "size": "величина",
    "sliders": "ползуны",
    "force": "силовое, силами, силовой",
    "groove": "паз, пазом, пазовый",
    "smallest": "наименьший, наименьшая",
    "span": "общая нормаль, длина общей нормали",
    "spline": "сплайн",
    "spur": "цилиндрическая",
    "standard": "стандартный, стандартная",
    "stated": "заданные",
    "steel": "сталь",
    "substituted": "замещение",
    "sun": "солнце, солнечное",
    "sun-ring": "солнце-эпицикл",
    "teeth": "зубья",
    "train": "рядовая",
    "thickness": "толщина, толщина зуба",
    "trapezoid": "трапецеидальный",
    "trial": "подбор",
    "uniform": "равномерный, равномерная",
    "where": "под формулами",
    "up": "вверх, сверху, вверху, верхнее, крайнее верхнее",
    "wedge": "клин",
    "wheel": "колесо",
    "wheel1": "колесо1",
    "wheel3": "колесо3",
    "with": "по вращению, по",
    "through": "сквозная, сквозной",
    "top centre": "вверху по центру, вверху посередине",
    "top right": "вверху справа",
}
_ENGLISH: dict[str, set[str]] = {}
for _word, _twins in _TWINS.items():
    for _twin in _twins.split(", "):
        _ENGLISH.setdefault(_plain(_twin), set()).add(_word)

_KEYS = {
    "mechanism": "механизм",
    "frame": "стойка",
    "links": "звенья",
    "guides": "направляющие",
    "driver": "ведущее звено, ведущее",
    "assembly": "сборка",
    "sketch": "эскиз",
    "points": "точки",
    "mass": "масса",
    "masses": "массы",
    "mass_centre": "центр масс",
    "inertia": "момент инерции, инерция",
    "slides": "ползёт, скользит",
    "through": "через",
    "angle": "угол",
    "link": "звено",
    "guide": "направляющая",
    "speed": "скорость, частота вращения, обороты",
    "period": "период",
    "rotation": "вращение",
    "zero": "ноль, начало, нулевое положение",
    "point": "точка",
    "extreme": "крайнее, крайнее положение",
    "loads": "нагрузки, нагрузка",
    "gravity": "тяжесть, сила тяжести",
    "forces": "силы",
    "moments": "моменты",
    "at": "в точке, приложена",
    "on": "на звене",
    "direction": "направление",
    "constant": "постоянная, постоянный",
    "components": "проекции",
    "stroke": "ход",
    "by_angle": "по углу",
    "by_time": "по времени",
    "by_position": "по положениям",
    "by_displacement": "по перемещению",
    "piston_diameter": "диаметр поршня",
    "positions": "положения",
    "table": "таблица",
    "diagram": "диаграмма",
    "plans": "планы",
    "friction": "трение",
    "flywheel": "маховик",
    "delta": "неравномерность, коэффициент неравномерности",
    "language": "язык",
    "title": "титул, титульный лист, заголовок",
    "student": "студент",
    "group": "группа",
    "teacher": "преподаватель, руководитель",
    "variant": "вариант",
    "department": "кафедра",
    "institution": "вуз, университет",
    "topic": "тема",
    "city": "город",
    "year": "год",
    "drive": "привод, передача",
    "stages": "ступени",
    "teeth": "зубья, числа зубьев",
    "module": "модуль",
    "ratio": "передаточное отношение",
    "kind": "вид, тип",
    "mesh": "зацепление",
    "shift": "смещение",
    "shoe": "колодка",
    "synthesis": "синтез",
    "cams": "кулачки",
    "follower": "толкатель",
    "drawing": "чертёж",
    "scales": "масштабы",
    "readings": "отсчёты",
    "length": "длина",
    "radius": "радиус",
    "diameter": "диаметр",
    "force": "сила",
    "moment": "момент",
    "name": "имя, название",
}
_KEYS |= dict(line.split(": ") for line in MORE.strip().splitlines())
_KEY: dict[str, set[str]] = {}
for _word, _twins in _KEYS.items():
    for _twin in _twins.split(", "):
        _KEY.setdefault(_plain(_twin), set()).add(_word)


def english(value: object, words: Collection[str]) -> object:
    """One of the words for its Russian twin; anything else as it is written."""
    if isinstance(value, list):
        return [english(one, words) for one in value]
    if not isinstance(value, str) or value.isascii():
        return value
    found = _ENGLISH.get(_plain(value), set()) & set(words)
    return next(iter(found)) if len(found) == 1 else value


def twin(word: str) -> str:
    """The first Russian twin of a word of the format; the word itself of one that has none."""
    return _TWINS.get(word, word).split(", ")[0]


def called(key: str) -> str:
    """What a key may be called in Russian; empty of one that has no twin."""
    return _KEYS.get(key, "")


def english_key(key: str, known: Collection[str]) -> str | None:
    """Of the keys that are known at a place the one that a Russian key stands for."""
    if key.isascii():
        return None
    found = _KEY.get(_plain(key), set()) & set(known)
    return next(iter(found)) if len(found) == 1 else None


def meant(key: str) -> bool:
    """Whether a Russian key stands for any of the format."""
    return not key.isascii() and _plain(key) in _KEY


def keys() -> frozenset[str]:
    """Those that have a Russian twin."""
    return frozenset(_KEYS)


def words() -> frozenset[str]:
    """Those that have a Russian twin."""
    return frozenset(_TWINS)
