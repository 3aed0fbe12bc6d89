"""What the parts of a compound train say wrong of one another: names, kinds of meshes, how many speeds are stated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.train.given import LOADS, GearTrain, Pair
from tmm_report.chapters.gears.train.solve.built import build, carried, shafts
from tmm_report.mechanics.gears.compound.rows import rows_of
from tmm_report.problems import N_, Message, Problem, mistake

Path = tuple[str | int, ...]
HERE = "train"


def mistakes_of(given: GearTrain) -> Iterator[Problem]:
    """All of them; what cannot be judged while names are wrong is left for later."""
    wrong = [
        *_names(given),
        *_carriers(given),
        *_meshes(given),
        *_loads(given),
        *_roads(given),
        *_twice(given),
    ]
    yield from wrong
    if not wrong:
        yield from _speeds(given)
        yield from _sought(given)


def _names(given: GearTrain) -> Iterator[Problem]:
    """Names of members that the train has not."""
    known = {*given.wheels, *given.carriers}
    for name in given.carriers:
        if name in given.wheels:
            right = Message(N_("a name of its own for the carrier"))
            yield mistake(N_("%(name)s is a wheel and a carrier"), (HERE, "carriers", name), right, name=name)
    places: list[tuple[str, Path]] = [
        (name, (HERE, "meshes", k)) for k, pair in enumerate(given.meshes) for name in pair[:2]
    ]
    places += [(name, (HERE, "carriers", of)) for of, wheels in given.carriers.items() for name in wheels]
    for key in ("input", "output", "fixed"):
        places += [(name, (HERE, key)) for name in getattr(given, key)]
    places += [(name, (HERE, "joined", k)) for k, group in enumerate(given.joined) for name in group]
    places += [(name, (HERE, key, name)) for key in ("speeds", "modules") for name in getattr(given, key)]
    places += [(name, (HERE, "cases", k, name)) for k, case in enumerate(given.cases) for name in case]
    for name, path in places:
        if name not in known:
            right = Message(N_("one of: %(words)s"), {"words": ", ".join(sorted(known))})
            yield mistake(N_("the train has no member %(name)s"), path, right, name=name)
    stated = {pair.name for pair in given.meshes}
    for name in given.efficiency.meshes if given.efficiency else ():
        if name not in stated:
            right = Message(N_("one of: %(words)s"), {"words": ", ".join(sorted(stated))})
            place: Path = (HERE, "efficiency", "meshes", name)
            yield mistake(N_("the train has no mesh %(name)s"), place, right, name=name)


def _carriers(given: GearTrain) -> Iterator[Problem]:
    seen: dict[str, str] = {}
    for carrier, wheels in given.carriers.items():
        for wheel in wheels:
            if wheel in given.carriers:
                wrong = N_("the carrier %(carrier)s cannot carry another carrier")
                right = Message(N_("the wheels whose axes it carries"))
                yield mistake(wrong, (HERE, "carriers", carrier), right, carrier=carrier)
            elif seen.setdefault(wheel, carrier) != carrier:
                right = Message(N_("one carrier for each planet gear"))
                yield mistake(
                    N_("wheel %(wheel)s is carried by two carriers"),
                    (HERE, "carriers", carrier),
                    right,
                    wheel=wheel,
                )
    of = carried(given)
    for name in (*given.input, *given.output, *given.fixed):
        if name in of:
            wrong = N_(
                "planet gear %(name)s goes round with its carrier: it is neither driven, taken from nor held"
            )
            yield mistake(wrong, (HERE,), Message(N_("a wheel on the main axis, or a carrier")), name=name)
    for group in given.joined:
        if len({of.get(name, "") for name in group}) > 1:
            right = Message(N_("wheels on one carrier, or none of them"))
            yield mistake(
                N_("a planet gear is joined to what its carrier does not carry"), (HERE, "joined"), right
            )


def _meshes(given: GearTrain) -> Iterator[Problem]:
    of = carried(given)
    for k, pair in enumerate(given.meshes):
        path: Path = (HERE, "meshes", k)
        ends = (pair.i, pair.j)
        if any(name in given.carriers for name in ends):
            yield mistake(N_("a carrier has no teeth to mesh"), path, Message(N_("two wheels")))
        elif pair.i == pair.j or _one_shaft(given, pair):
            right = Message(N_("two wheels that turn on their own"))
            yield mistake(N_("the wheels %(mesh)s turn as one"), path, right, mesh=pair.name)
        elif of.get(pair.i) and of.get(pair.j) and of[pair.i] != of[pair.j]:
            right = Message(N_("planet gears of one carrier, or a planet gear and a central wheel"))
            yield mistake(N_("the planet gears %(mesh)s have two carriers"), path, right, mesh=pair.name)
        elif pair.kind == "internal" and _not_larger(given, pair):
            wrong = N_("the ring %(ring)s has no more teeth than wheel %(wheel)s inside it")
            right = Message(N_("the ring second, with more teeth"))
            yield mistake(wrong, path, right, ring=pair.j, wheel=pair.i)
    yield from _modules(given)
    meshed = {name for pair in given.meshes for name in pair[:2]}
    for name in given.wheels:
        if name not in meshed:
            right = Message(N_("its mesh in meshes, or leave the wheel out"))
            yield mistake(N_("wheel %(name)s meshes with nothing"), (HERE, "wheels", name), right, name=name)


def _modules(given: GearTrain) -> Iterator[Problem]:
    """Wheels in mesh of two modules, or one of them without."""
    for pair in given.meshes:
        named = [name for name in pair[:2] if name in given.modules]
        if not named:
            continue
        path: Path = (HERE, "modules", named[0])
        one, other = (given.modules.get(name, given.module) for name in pair[:2])
        if one is None or other is None:
            wrong = N_("wheel %(wheel)s has a module, and its mate %(mate)s has none")
            right = Message(N_("modules of both, or module of all"))
            mate = pair.j if named[0] == pair.i else pair.i
            yield mistake(wrong, path, right, wheel=named[0], mate=mate)
        elif not math.isclose(one, other, rel_tol=1e-9):
            wrong = N_("the wheels of the mesh %(mesh)s have modules of %(one)s and %(other)s mm")
            values = {"mesh": pair.name, "one": f"{1e3 * one:.4g}", "other": f"{1e3 * other:.4g}"}
            yield mistake(wrong, path, Message(N_("one module of both wheels in mesh")), **values)


def _one_shaft(given: GearTrain, pair: Pair) -> bool:
    of = shafts(given)
    return pair.i in of and pair.j in of and of[pair.i] == of[pair.j]


def _not_larger(given: GearTrain, pair: Pair) -> bool:
    if pair.i not in given.wheels or pair.j not in given.wheels:
        return False
    return given.wheels[pair.j].high <= given.wheels[pair.i].low


def _loads(given: GearTrain) -> Iterator[Problem]:
    stated = [key for key in LOADS if getattr(given, key) is not None]
    if len(stated) > 1:
        wrong = N_("the load is stated %(count)s times: %(keys)s")
        right = Message(N_("one of them: the others follow"))
        yield mistake(wrong, (HERE, stated[1]), right, count=len(stated), keys=", ".join(stated))
    if given.rope is not None and not given.rope.force:
        yield mistake(
            N_("a rope without force loads nothing"),
            (HERE, "rope", "force"),
            Message(N_("for example, 9 kN")),
        )


def _roads(given: GearTrain) -> Iterator[Problem]:
    for key in ("road", "locking"):
        if getattr(given, key) is not None and len(given.output) != 2:
            wrong = N_("%(key)s is stated of a train with two outputs, and this one has %(count)s")
            right = Message(N_("output: [3, 5], the outer wheel first"))
            yield mistake(wrong, (HERE, key), right, key=key, count=len(given.output))
    road = given.road
    if road and road.radius is not None and road.track >= 2 * road.radius:
        right = Message(N_("a radius of more than half the track"))
        yield mistake(N_("the curve turns about a point between the wheels"), (HERE, "road", "radius"), right)


def _twice(given: GearTrain) -> Iterator[Problem]:
    """Speeds of one member, or of two that turn as one, in two places, of which one would be passed over."""
    of = shafts(given)
    elsewhere = dict.fromkeys(given.fixed, "fixed")
    if given.road is not None:
        elsewhere |= dict.fromkeys(given.output, "road")
    if given.speed is not None:
        elsewhere |= dict.fromkeys(given.input[:1], "speed")
    elsewhere = {of.get(name, name): key for name, key in elsewhere.items()}
    for name in given.speeds:
        shaft = of.get(name, name)
        if shaft in elsewhere:
            wrong = N_("the speed of member %(name)s is stated twice, by speeds and by %(key)s")
            right = Message(N_("leave out one of the two"))
            yield mistake(wrong, (HERE, "speeds", name), right, name=name, key=elsewhere[shaft])


def _speeds(given: GearTrain) -> Iterator[Problem]:
    """As many speeds as the train has degrees of freedom, those of held members with them."""
    built = build(given, {name: one.low for name, one in given.wheels.items()})
    freedom, known = built.train.freedom, known_names(given)
    bodies = {built.body(name) for name in known}
    held = [name for name in given.fixed if name in (*given.input, *given.output)]
    if held:
        right = Message(N_("either fixed or turning"))
        yield mistake(N_("member %(name)s is held and turns"), (HERE, "fixed"), right, name=held[0])
    elif len(bodies) != freedom:
        wrong = N_(
            "the train has %(freedom)s degrees of freedom, and %(count)s speeds are known: of %(names)s"
        )
        right = Message(
            N_(
                "as many as the degrees of freedom: fixed (0), speed of the input, speeds of others; or join members"
            )
        )
        names = ", ".join(known) or "—"
        yield mistake(wrong, (HERE,), right, freedom=freedom, count=len(bodies), names=names)
    else:
        outer = {built.body(name) for name in built.outer}
        if len(outer) != freedom + 1:
            wrong = N_("torques act on %(count)s members from outside, and equilibrium needs %(needed)s")
            right = Message(
                N_("every member that is driven, held or gives power in input, fixed or output, and no other")
            )
            yield mistake(wrong, (HERE, "output"), right, count=len(outer), needed=freedom + 1)
        elif given.locking is not None and not _joins_outputs(given):
            right = Message(N_("outputs of one differential: both mesh with planet gears of one carrier"))
            yield mistake(N_("no planet gears join the two outputs"), (HERE, "locking"), right)


def _joins_outputs(given: GearTrain) -> bool:
    built = build(given, {name: one.low for name, one in given.wheels.items()})
    ends = {built.body(name) for name in given.output}
    return any({row.a, row.b} == ends for row in rows_of(built.train, built.outer) if row.carrier)


def known_names(given: GearTrain) -> list[str]:
    """Of the members whose speeds are stated."""
    road = given.output if given.road is not None else ()
    found: list[str] = [*given.fixed, *given.speeds, *road]
    if given.speed is not None or (not road and (not given.speeds or _only_second(given))):
        found.append(given.input[0])
    return list(dict.fromkeys(found))


def _only_second(given: GearTrain) -> bool:
    """Whether the other inputs' speeds are stated, and neither the first one's nor an output's."""
    others = set(given.input[1:])
    return bool(others) and set(given.speeds) <= others


def _sought(given: GearTrain) -> Iterator[Problem]:
    if given.sought and given.find is None:
        names = ", ".join(name for name, one in given.wheels.items() if not one.stated)
        right = Message(N_("find: {ratio: 40}, or the teeth of all wheels"))
        yield mistake(
            N_("the teeth of %(names)s are sought for no ratio"), (HERE, "wheels"), right, names=names
        )
    if given.find is not None and not given.sought:
        right = Message(N_("teeth of some wheels as [20, 60], or no find"))
        yield mistake(N_("all the teeth are stated, and nothing is left to find"), (HERE, "find"), right)
    if given.find is not None and not single(given):
        right = Message(N_("one input and one output, the others fixed"))
        yield mistake(N_("teeth are sought of a train with one input and one output"), (HERE, "find"), right)


def single(given: GearTrain) -> bool:
    """Whether one member is driven, one gives power, and no other is stated to turn."""
    of, ends = shafts(given), (*given.input, *given.output)
    others = [speed for name, speed in given.speeds.items() if of[name] not in {of[end] for end in ends}]
    return len(ends) == 2 and not any(others)
