"""English keys of the format and what they may be called in Russian, beside those of `variant.russian`."""

from __future__ import annotations

from tmm_report.languages import LANGUAGES

MORE = """
about: относительно
absorber: гаситель, поглотитель
acceleration: ускорение
accelerations: ускорения
accuracy: точность
across: поперёк
after: после
ahead: впереди
align: выравнивание
allow_partial: допускать неполный цикл
alpha: угол профиля
alpha_w: угол зацепления
amplitude: амплитуда
angles: углы
angular: угловой, угловое
apart: раздельно
appendix: приложение, приложения
approved: утверждаю, утвердил
arc: дуга
arcs: из дуг
area: площадь
areas: площади
arm: рычаг, плечо
arms: рычаги, плечи
assignment: задание
at_length: при длине
at_position: в положении
axes: оси
axial: осевой, осевая
back: назад, обратно
backlash: боковой зазор
balancing: уравновешивание
ball_arm: плечо шара
balls: шары
bank: ряд цилиндров
base: основание
bearings: подшипники, опоры
before: до
begin: начало
bell_crank: угловой рычаг
belt: ремень
between: между
bevel: коническое
beyond: за хордой
bodies: тела
body: тело, в тексте
bottom: нижнее, снизу
brake: тормоз
bushing: втулка
by: по
by_place: по месту
by_speed: по скорости
cam: кулачок
capitals: прописные, прописными
captions: надписи, подписи рисунков и таблиц
carrier: водило
carriers: водила
cases: случаи
centre: центр
centre_distance: межосевое расстояние
centre_distances: межосевые расстояния
choose: выбрать
chords: хорды
circle: окружность
clear: просвет
clearance: радиальный зазор
closure: замыкание
coast: выбег
coaxial: соосная, соосно
coaxiality: соосность
coefficient: коэффициент
collar: буртик
collars: гребни
compression: сжатие
conclusions: заключение
contact: контакт
contacts: контакты, пары трения
contents: содержание
continued: продолжение
corrected: исправлено
count: число, количество
counterweights: противовесы
couple: пара сил
coupler: шатунная плоскость
couples: пары сил
coupling: муфта, муфты
course: курс
crank: кривошип
crank_angles: углы кривошипа
crank_at: сторона кривошипа
crank_from: начальный угол кривошипа
crank_pin: палец кривошипа
crank_pivot: ось кривошипа
crank_radius: радиус кривошипа
crank_rocker: кривошипно-коромысловый механизм, кривошипно-коромысловый
crank_turn: поворот кривошипа
cranks: кривошипы
critical_slip: критическое скольжение
curve: кривая
curves: кривые
cutter: инструмент, долбяк
cycles: циклы
cylinder: цилиндр, гидроцилиндр
cylinders: цилиндры
dampers: демпферы
damping: демпфирование
damping_ratio: относительное демпфирование
dash: тире
data: данные, дано
dead_zone: зона нечувствительности
decimal_sign: десятичный знак
deflection: осадка
density: плотность
depth: подробность
designation: обозначение, шифр
disc: диск
displacement: перемещение
distance: расстояние
divisions: деления
drawing_tables: таблицы чертежей
driver: привод, ведущее звено
driven: ведомая, ведомый
driven_speed: скорость ведомого
driving: ведущий
drum: барабан
due: срок сдачи, срок
dwell: выстой
dynamics: динамика
eccentric: эксцентриковый механизм, эксцентрик
eccentricity: эксцентриситет
efficiency: кпд
effort: усилие
ends: концы
engine: двигатель внутреннего сгорания
exponent: показатель
extension: продолжение
external: внешнее
external_teeth: наружные зубья
face: торец
face_friction: трение по кулачку
face_offset: смещение плоскости
fan: вентилятор
fast: быстроходная
feedback: обратная связь
figure: рисунок
figures: рисунки
find: найти, искать
firing: порядок работы
first: первый
fixed: неподвижный
flank: боковая поверхность
flat: плоский
force_plan: план сил
formulas: формулы
forward: вперёд, прямой ход
foundation: фундамент
free: свободно
free_angle: свободный угол
free_length: свободная длина, длина без нагрузки
frequency: частота
friction_angle: угол трения
from: от, из
fulcrum: точка опоры
full: полный
function: функция
gap: зазор
gear: зубчатое колесо
governor: регулятор
grade: степень точности
greatest: наибольшее
groove: канавка
guaranteed: гарантированный зазор
half_angle: половинный угол
half_cone: половина угла конуса
hand: направление витка
hand_force: сила руки
hands: руки
harmonic: гармоника
harmonics: гармоники
headings: заголовки
height: высота
helix: угол наклона зубьев
here: здесь
highest: наивысший
idlers: паразитные колёса
indent: отступ, абзацный отступ
induction: асинхронный
inline: рядный
inner: внутренний
input: вход
insensitivity: нечувствительность
inspection: контрольные размеры, контроль
internal: внутреннее
introduction: введение
isodrome: изодром
isolators: виброизоляторы
issued: выдано, дата выдачи
joined: соединены, одно целое
joints: шарниры
journal: цапфа
journals: цапфы
kinetic: кинетический
last: окончание
law: закон
least: наименьшее
least_contact: наименьший коэффициент перекрытия
least_curvature: наименьший радиус кривизны
least_tip: наименьшая толщина вершины
left: левое, слева
length: длина
lengths: длины
level: уровень, ровно
lift: подъём, ход толкателя
lifts: подъёмы
limit: предел
line: прямая, отрезок прямой
lines: строки, с новой строки
load: нагрузка
locking: коэффициент блокировки, блокировка
losses_of_acceleration: потери ускорения
lower: нижний
lower_offset: смещение нижнего
lowest: наинизший
lubrication: смазка
machine: машина
margins: поля
material: материал
materials: материалы
max_moment: наибольший момент
mean: средний
mean_module: средний модуль
mean_speed: средняя скорость
member: звено передачи
meshes: зацепления
method: метод
methods: методы
middle: середина
ministry: министерство
modules: модули
motor: мотор, двигатель
motors: двигатели
moves: движет
needed: требуется
new_page: с новой страницы
no_load: холостой ход
nose: радиус вершины
note: записка
numbers: нумерация
of: от наибольшего
offset: смещение направляющей, дезаксиал
offset_ratio: относительное смещение
omit: опустить, без
opposed: оппозитный
order: порядок
outer: наружный
output: выход
output_power: мощность на выходе
output_share: доля выхода
output_torque: момент на выходе
overhang: вылет
overload: перегрузка
own: собственный
page_number: номер страницы
pairs: пары
parallel: параллельно
part: часть
parts: части
permitted: допускаемое
phase: фаза
phases: фазы
pin: ось ролика
pins: ролики, шарики
pitch: шаг
pitch_base: радиус центрового профиля
pivot: пята
pivots: оси
places: положения ползуна, места
planes: плоскости
poisson: коэффициент пуассона
polar: полярный
polynomial: полином, многочлен
power: мощность
preload: предварительный натяг, натяг
press: пресс
pressure_angle: угол давления
pressure_angle_limit: допускаемый угол давления
products: центробежные моменты
profile: профиль
pull: тянуть
punch: пуансон
push: толкать
quality: качество, качественные показатели
rack: рейка
racks: рейки
radial: радиальный
radii: радиусы
radius_of_gyration: радиус инерции
ramp: скос
range: диапазон
rate: жёсткость пружины
rated: номинальный, номинальная
ratio_range: диапазон передаточных отношений, пределы передаточного отношения
ratio_weight: вес отношения
reciprocating: возвратно-поступательный
reduction: приведение
references: источники, список источников
remove: убрать
reserve: запас
resistance: сопротивление
resisting: сопротивляющийся
return: возвращение
return_angle_limit: допускаемый угол давления при возвращении
right: правое, справа
rim: обод
ring_teeth: зубья эпицикла
ring_up_to: эпицикл до
rise: удаление
road: дорога
rocker: коромысло
rocker_from: начальный угол коромысла
rocker_joint: шарнир коромысла
rocker_pivot: ось коромысла
rocker_positions: положения коромысла
rocker_turn: поворот коромысла
rod: шатун
rod_length: длина шатуна
rod_ratio: относительная длина шатуна
role: должность, кто
roller: ролик
rolling: качение
rope: канат
rotating: вращающийся
rotor: ротор
rotors: роторы
round: округлить, округление
run_down: торможение
run_up: разгон
running_in: приработка
satellites: сателлиты
scale: масштаб
scheme: схема
second: второй
section: раздел
sectors: секторы
series: последовательно
servo: сервомотор
shaft: вал
shaft_angle: угол между осями
shafts: валы
share: доля
sheets: листы
shifted: сдвиг
shortens: укорачивается
shunt: шунтовой, параллельного возбуждения
side: сторона
signatures: подписи
frames: рамки
signed: подписали, подписывают
sine: четверть синусоиды
size: размер, кегль
slack: провисание
sleeve: муфта регулятора
sleeve_arm: плечо муфты
slider: ползун
slider_crank: кривошипно-ползунный механизм, кривошипно-ползунный
slider_positions: два положения ползуна
sliding: скольжение
sliding_limit: предел скольжения
slip: проскальзывание
slope: наклон
slotted_link: кулиса, качающаяся кулиса, кулисный механизм
slow: тихоходная
so_that: чтобы, так чтобы
spacing: расположение
span: число зубьев в общей нормали
speeds: скорости
splash: разбрызгивание
split: разбивка, разбивка передаточного отношения
spokes: спицы
spring: пружина
springs: пружины
square: квадрат
stall: момент при пуске
start: пуск, разгон
starts: заходы
state: состояние
stated: задано
static: статический
stator: статор
steady: установившееся движение
step: отношение соседних
steps: шаги
stiffness: жёсткость
stress: напряжение
stribeck: штрибек
strokes: ходы
structural: структурные
subsection: подраздел
surfaces: поверхности
swing: размах, угол размаха
swings: размахи
symbols: обозначения
synchronous: синхронная скорость
tables: таблицы
tangent: с прямыми боками
text: текст
thickness: толщина
thinning: утонение, утонение зубьев
throttle: дроссель
tight: натянутая ветвь
tilt: наклон ряда
time: время
tip_diameters: диаметры вершин
tip_shortening: укорочение головки
to: до какого
tolerance: допуск
top: верхнее, сверху
torque: крутящий момент
torsion: пружина кручения
torsion_springs: пружины кручения
towards: к
track: колея
train: зубчатый механизм, зацепления
transmissibility: коэффициент передачи силы
transmission: угол передачи, углы передачи
travel: движение по направляющей
turned: закручивание
turning_guide: вращающаяся кулиса, механизм витворта
turns: обороты
unbalance: дисбаланс
unknown: неизвестное
upper: верхний
upper_offset: смещение верхнего
value: значение
values: значения
varying_inertia: переменный момент инерции
vee: развал
velocity: линейная скорость
vibration: колебания, вибрация
viscosity: вязкость, коэффициент вязкого сопротивления
viscous: вязкое сопротивление
voltage: напряжение сети
wear: износ, изнашивание
wheel: колесо
wheels: колёса
where: где, пояснения
width: ширина
within: в пределах
words: слова
work: работа
working: рабочий участок
working_speed: скорость рабочего хода, средняя скорость рабочего хода
worm: червяк
wrap: угол обхвата
wrist_pin: поршневой палец
young: модуль упругости
"""
SYMBOLS = frozenset(
    ["K", "c*", "cos", *LANGUAGES, "ha*", "q", "sin", "t", "x", "x0", "x1", "xz", "y", "yz", "z0"]
)
"""Keys that are letters in any language."""
