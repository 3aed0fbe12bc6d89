"""Wheels whose axes move, racks beside moving wheels and rolling on rails, on mechanisms at random, against a solver
that shares no code: all constraints and their rates at once, and all equations of equilibrium at once.

What rolls is told by the point of contact alone: there both bodies have one velocity.
"""

import numpy as np
import pytest
import yaml

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.quantities import wheels as wheel_quantities
from tmm_report.mechanics.lever.motion import solve as motion_at

G = 9.81


def mesh_planet(rng):
    """A planet on the crank, outside or inside a fixed wheel, with a rod from its pin to a slider."""
    a, k = 0.06 * rng.uniform(0.8, 1.3), int(rng.choice([1, 2, 3]))
    inside = bool(rng.integers(2)) and k > 1
    r2 = a / (k - 1) if inside else a / (k + 1)
    pin = r2 * rng.uniform(0.4, 1.2)
    links = {
        "1": {"O": 0, "A": a},
        "2": {"A": 0, "D": complex(pin, 0.3 * pin), "S2": 0.2 * pin},
        "3": {"D": 0, "E": 6 * (a + pin)},
        "4": {"E": 0},
    }
    mesh = {"links": ("0", "2"), "carrier": "1", "radii": (k * r2, r2), "inside": inside, "axes": ("O", "A")}
    return {"frame": {"O": 0j}, "links": links, "slides": {"4": ("E", 0j, rng.uniform(-0.5, 0.5))}, "wheels": [mesh],
            "assembly": {"E": "right"}}  # fmt: skip


def mesh_sun(rng):
    """A wheel fixed to the coupler turns one about the crank's pivot (Watt) or the rocker's; that drives a slider."""
    c, at_crank = 0.3, bool(rng.integers(2))
    links = {
        "1": {"O": 0, "A": 0.07 * rng.uniform(0.8, 1.2)},
        "2": {"A": 0, "B": 0.28 * rng.uniform(0.95, 1.05), "S2": 0.13 + 0.02j},
        "3": {"C": 0, "B": 0.2 * rng.uniform(0.95, 1.05)},
    }
    at, carrier, axis = ("O", "1", "A") if at_crank else ("C", "3", "B")
    links["4"] = {at: 0, "D": 0.05}
    links["5"] = {"D": 0, "E": 0.4}
    links["6"] = {"E": 0}
    apart = abs(links[carrier][axis])
    size = float(rng.choice([0.5, 1, 2])) if at_crank else rng.uniform(0.4, 2.5)
    radii = (apart * size / (1 + size), apart / (1 + size))
    mesh = {"links": ("2", "4"), "carrier": carrier, "radii": radii, "inside": False, "axes": (axis, at)}
    if at_crank and size == 0.5:  # a ring on the sun, and half a turn less of it
        mesh |= {"inside": True, "radii": (2 * apart, apart)}
    frame = {"O": 0j, "C": complex(c)}
    angle = rng.uniform(1.0, 2.0)
    return {"frame": frame, "links": links, "slides": {"6": ("E", frame[at], angle)}, "wheels": [mesh],
            "assembly": {"B": "left of A-C", "E": "up"}}  # fmt: skip


def rolls(rng, teeth=None):
    """A wheel on the axle of a slider-crank rolls on a rail, or on a fixed rack and moves another one; a rod from its
    pin goes to a second slider."""
    radius, drawn = rng.uniform(0.04, 0.09), bool(rng.integers(2))
    teeth = drawn if teeth is None else teeth
    tilt, side = rng.uniform(-0.4, 0.4), rng.choice([-1, 1])
    links = {
        "1": {"O": 0, "A": 0.06},
        "2": {"A": 0, "B": 0.25, "S2": 0.1 - 0.02j},
        "3": {"B": 0},
        "4": {"B": 0, "D": complex(0.03, 0.01), "S4": 0.01j},
        "5": {"D": 0, "E": 0.3},
        "6": {"E": 0},
    }
    frame, slides = {"O": 0j}, {"3": ("B", 0j, tilt), "6": ("E", 0j, tilt)}
    normal = 1j * np.exp(1j * tilt)
    mesh = {"links": ("0", "4"), "carrier": "3", "radius": radius, "axis": "B", "toward": -side * normal,
            "along": np.exp(1j * tilt), "side": "above" if side > 0 else "below", "rolls": not teeth}  # fmt: skip
    racks = [mesh]
    if teeth:
        far = side * radius * normal
        frame["G"] = complex(far)
        links["7"] = {"K": 0}
        slides["7"] = ("K", far, tilt)
        racks.append(mesh | {"links": ("7", "4"), "toward": side * normal,
                             "side": "below" if side > 0 else "above"})  # fmt: skip
    return {"frame": frame, "links": links, "slides": slides, "racks": racks,
            "assembly": {"B": "right", "E": "right"}}  # fmt: skip


def finished(made, rng):
    """Masses, loads, phases, angles of engagement."""
    made["m"] = {name: rng.uniform(0.5, 4) for name in made["links"]}
    made["J"] = {name: rng.uniform(0.002, 0.02) for name in made["links"]}
    for name in made.get("slides", {}):
        made["J"][name] = 0.0
    for one in [*made.get("wheels", []), *made.get("racks", [])]:
        one["phase"] = rng.uniform(-3, 3) if one.get("links", ("",))[0] != "7" else 0.0
        one["alpha"] = np.radians(rng.choice([0, 20, 25])) if not one.get("rolls") else 0.0
        if one.get("rolls"):
            made["m"][one["carrier"]] = 0.0
    made["omega"] = rng.uniform(4, 15) * rng.choice([-1, 1])
    made["P"] = complex(*rng.uniform(-200, 200, 2))
    made["M"] = rng.uniform(-5, 5)
    return made


def centre(made, name):
    points = list(made["links"][name])
    return next((p for p in points if p.startswith("S")), points[0])


def plain(z):
    z = complex(z)
    return [z.real, z.imag]


def text(made):
    links = {}
    for name, points in made["links"].items():
        own = {"points": {p: plain(z) for p, z in points.items()}}
        if made["m"][name]:
            own |= {"mass": float(made["m"][name]), "mass_centre": centre(made, name)}
            own |= {"inertia": float(made["J"][name])} if made["J"][name] else {}
        if name in made["slides"]:
            own["slides"] = f"g{name}"
        links[int(name)] = own
    guides = {f"g{n}": {"through": next(k for k, z in made["frame"].items() if abs(z - at) < 1e-12),
                        "angle": float(angle)} for n, (_, at, angle) in made["slides"].items()}  # fmt: skip
    wheels = [
        {"links": [int(x) for x in w["links"]], "carrier": int(w["carrier"]), "radii": [float(r) for r in w["radii"]],
         "mesh": "internal" if w["inside"] else "external", "phase": float(w["phase"]),
         "pressure_angle": float(w["alpha"])}
        for w in made.get("wheels", [])
    ]  # fmt: skip
    racks, rolling = [], []
    for r in made.get("racks", []):
        own = {"wheel": int(r["links"][1]), "carrier": int(r["carrier"]), "radius": float(r["radius"]),
               "side": r["side"], "phase": float(r["phase"])}  # fmt: skip
        if r["rolls"]:
            rolling.append(own)
        else:
            racks.append(own | {"slider": int(r["links"][0]), "pressure_angle": float(r["alpha"])})
    last = max(made["slides"])
    last = "6" if "6" in made["slides"] else last
    point, turns = made["slides"][last][0], "4" if "4" in made["links"] and "4" not in made["slides"] else "2"
    made["loaded"], made["turned"] = (last, point), turns
    return yaml.safe_dump({
        "language": "en",
        "mechanism": {"frame": {k: plain(z) for k, z in made["frame"].items()}, "guides": guides, "links": links,
                      "wheels": wheels, "racks": racks, "rolling": rolling,
                      "driver": {"link": 1, "speed": abs(float(made["omega"])),
                                 "rotation": "clockwise" if made["omega"] < 0 else "counter-clockwise"},
                      "assembly": made["assembly"]},
        "loads": {"gravity": G,
                  "forces": [{"at": point, "on": last, "constant": abs(made["P"]),
                              "direction": f"{np.degrees(np.angle(made['P']))} deg"}],
                  "moments": [{"on": turns, "constant": float(made["M"]), "direction": "counter-clockwise"}]},
        "positions": {"table": 12},
    }, sort_keys=False)  # fmt: skip


class Alone:
    """The mechanism at one pose, {link: (place of its origin, angle)}; rows of constraints in (x, y, θ) of all."""

    def __init__(self, made, pose):
        self.made, self.pose, self.names = made, pose, list(made["links"])

    def place(self, link, point):
        if link == "0":
            return self.made["frame"][point]
        r, angle = self.pose[link]
        return r + np.exp(1j * angle) * self.made["links"][link][point]

    def row(self, parts):
        """Σ direction · velocity of a body's material point at a place."""
        row = np.zeros(3 * len(self.names))
        for link, at, direction, turn in parts:
            if link != "0":
                k, r = 3 * self.names.index(link), self.pose[link][0]
                row[k : k + 3] += direction.real, direction.imag, (np.conj(at - r) * direction).imag + turn
        return row

    def joints(self):
        owners = {}
        for link in ("0", *self.names):
            for point in self.made["frame"] if link == "0" else self.made["links"][link]:
                owners.setdefault(point, []).append(link)
        for point, (first, *others) in owners.items():
            for other in others:
                yield point, first, other

    def contact(self, one):
        """Place of contact, unit tangent, and the way from the second wheel's axis to it."""
        if "toward" in one:
            axis = self.place(one["links"][1], one["axis"])
            return axis + one["radius"] * one["toward"], one["along"], one["toward"]
        p, q = (self.place(one["carrier"], x) for x in one["axes"])
        e = (q - p) / abs(q - p)
        r1, r2 = one["radii"]
        at = p + r1 * e if not one["inside"] or r1 > r2 else p - r1 * e
        out = (at - q) / abs(at - q)
        return at, 1j * out, out

    def meshes(self):
        return [*self.made.get("wheels", []), *self.made.get("racks", [])]

    def lines(self, flanks):
        """What each constraint bears as unit wrenches: (key, row), in the order of `rates`."""
        for point, first, other in self.joints():
            at = self.place(other, point)
            for n, e in enumerate((1 + 0j, 1j)):
                yield (first, other, n), self.row([(other, at, e, 0.0), (first, at, -e, 0.0)])
        for link, (point, _, angle) in self.made["slides"].items():
            at = self.place(link, point)
            yield ("0", link, "N"), self.row([(link, at, 1j * np.exp(1j * angle), 0.0)])
            yield ("0", link, "M"), self.row([(link, at, 0j, 1.0)])
        for one, flank in zip(self.meshes(), flanks, strict=True):
            at, t, out = self.contact(one)
            rings = one.get("inside") and one["radii"][1] > one["radii"][0]
            push = -out if not rings else out
            line = t + flank * np.tan(one["alpha"]) * push
            first, second = one["links"]
            yield (first, second, "F"), self.row([(second, at, line, 0.0), (first, at, -line, 0.0)])

    def driver(self):
        row = np.zeros(3 * len(self.names))
        row[2] = 1.0
        return row

    def rates(self):
        """Velocities of all links for ω of the driver: no slip along the tangent, whatever the teeth press."""
        rows, driver = [], self.driver()
        bare = [0] * len(self.meshes())
        rows = [row for _, row in self.lines(bare)]
        J = np.array([*rows, driver])
        b = np.zeros(len(J))
        b[-1] = self.made["omega"]
        return np.linalg.solve(J, b)

    def statics(self, acc, more=0.0):
        """Multipliers by the transpose, M_bal last; the flank of each mesh is that which its own force presses. `more`:
        wrenches beside the loads, as rows are."""
        made, load = self.made, np.zeros(3 * len(self.names))
        for name in self.names:
            S = self.place(name, centre(made, name)) if made["m"][name] else self.pose[name][0]
            force = made["m"][name] * (-1j * G - acc["S"][name])
            wrench = [(name, S, force, -made["J"][name] * acc["e"][name])]
            if name == made["turned"]:
                wrench.append((name, S, 0j, made["M"]))
            load += self.row(wrench)
        link, point = made["loaded"]
        load += self.row([(link, self.place(link, point), made["P"], 0.0)]) + more
        flanks = [1] * len(self.meshes())
        for _ in range(8):
            keys, rows = zip(*self.lines(flanks), strict=True)
            x = np.linalg.solve(np.array([*rows, self.driver()]).T, -load)
            found = dict(zip((*keys, "bal"), x, strict=True))
            forces = [found[(*one["links"], "F")] for one in self.meshes()]
            wanted = [1 if force >= 0 else -1 for force in forces]
            if wanted == flanks:
                return found, load
            flanks = wanted
        raise AssertionError("the flanks do not settle")


def poses(made, motion):
    """Of the program's motion: places of origins, angles, (P,)."""
    found = {}
    for name, points in made["links"].items():
        point, at = next(iter(points.items()))
        u = motion.turn(name)
        found[name] = motion.place(point) - u * at, np.angle(u)
    return found


def at(found, k):
    return {name: (r[k], angle[k]) for name, (r, angle) in found.items()}


KINDS = [mesh_planet, mesh_sun, rolls]
CASES = [(kind, seed) for kind in KINDS for seed in range(8)]


@pytest.mark.parametrize(("kind", "seed"), CASES, ids=lambda x: getattr(x, "__name__", str(x)))
def test_at_random(kind, seed):
    rng = np.random.default_rng(1000 + seed)
    made = finished(kind(rng), rng)
    found = course.solve(loading.loads(text(made))).lever
    motion, forces = found.kinematics.table, found.kinetostatics
    assert forces.worst_lever < 1e-9 and forces.worst_power < 1e-9
    for one in (
        each for plan in found.plans.drawn for each in plan.comparison
    ):  # the plans read what is computed
        room = max(0.01 * abs(one.analytic), 20 * one.floor, 1e-12)
        assert abs(one.graph - one.analytic) <= room, one.key
    phi, h = np.asarray(motion.phi), 1e-4
    there = poses(made, motion)
    near = {way: motion_at(motion.linkage, phi + way * h) for way in (-2, -1, 1, 2)}
    near_poses = {way: poses(made, one) for way, one in near.items()}
    for k in (0, 2, 5, 9):
        alone = Alone(made, at(there, k))
        for point, first, other in alone.joints():  # every pivot is one place
            assert alone.place(first, point) == pytest.approx(alone.place(other, point), abs=1e-12)
        for link, (point, through, angle) in made["slides"].items():
            off = np.conj(np.exp(1j * angle)) * (alone.place(link, point) - through)
            assert off.imag == pytest.approx(0, abs=1e-12)
        q = alone.rates()
        around = {way: Alone(made, at(one, k)).rates() for way, one in near_poses.items()}
        per = made["omega"] / (12 * h)
        acc = per * (around[-2] - 8 * around[-1] + 8 * around[1] - around[2])
        size = np.abs(q[2::3]).max()
        S, e = {}, {}
        for n, name in enumerate(made["links"]):
            x, y, w = q[3 * n : 3 * n + 3]
            assert motion.angular_velocity(name)[k] == pytest.approx(w, abs=1e-9 * size)
            ax, ay, e[name] = acc[3 * n : 3 * n + 3]
            assert motion.angular_acceleration(name)[k] == pytest.approx(e[name], abs=1e-5 * size**2)
            # the same velocity by differences of positions, not by any rule of rolling
            ends = [near_poses[way][name][0][k] for way in (-2, -1, 1, 2)]
            moved = per * (ends[0] - 8 * ends[1] + 8 * ends[2] - ends[3])
            assert moved == pytest.approx(complex(x, y), abs=1e-8)
            turns = np.unwrap([near_poses[way][name][1][k] for way in (-2, -1, 1, 2)])
            assert per * (turns[0] - 8 * turns[1] + 8 * turns[2] - turns[3]) == pytest.approx(
                w, abs=1e-7 * size
            )
            arm = alone.place(name, centre(made, name)) - alone.pose[name][0]
            S[name] = complex(ax, ay) + (1j * e[name] - w * w) * arm
        alone_found, load = alone.statics({"S": S, "e": e})
        scale = max(abs(one) for key, one in alone_found.items() if key != "bal" and key[2] != "M")
        statics = forces.table.statics
        for point, first, other in alone.joints():
            force = complex(alone_found[first, other, 0], alone_found[first, other, 1])
            if len(motion.linkage.mechanism.links_at(point)) > 2:
                continue  # of three links at one pivot who bears whom is a choice
            mine = np.ravel(statics.force(other, first) + 0 * phi)[k]
            assert mine == pytest.approx(force, abs=1e-5 * scale)
        for one in alone.meshes():
            first, second = one["links"]
            mine = np.ravel(statics.force(second, first) + 0 * phi)[k]
            _, t, _ = alone.contact(one)
            assert (np.conj(t) * mine).real == pytest.approx(
                alone_found[first, second, "F"], abs=1e-5 * scale
            )
        balancing = float(np.ravel(forces.table.balancing)[k])
        assert balancing == pytest.approx(alone_found["bal"], abs=1e-5 * float(forces.table.scale[k]))
        assert balancing * made["omega"] == pytest.approx(
            -float(q @ load), rel=1e-5, abs=1e-4 * scale
        )  # powers


@pytest.mark.parametrize("seed", range(6))
def test_the_rail_bears_what_the_guide_of_the_axle_does(seed):
    rng = np.random.default_rng(seed)
    made = finished(rolls(rng, teeth=False), rng)
    found = course.solve(loading.loads(text(made))).lever.kinetostatics
    (wheel,) = wheel_quantities.rolling(found)
    solved = found.table
    normal, friction = (
        wheel_quantities.normal_of(wheel, solved),
        wheel_quantities.tangential_of(wheel, solved),
    )
    own = made["racks"][0]
    outside = [
        (on, by)
        for one in solved.statics.reactions.values()
        for by, on in (one.pair.links, one.pair.links[::-1])
        if on in ("3", "4") and by in ("1", "2", "5")
    ]
    for k in range(12):  # the wheel and its axle together, free: the rods and the rail hold them
        rods = (solved.statics.force(on, by) for on, by in outside)
        on_both = sum(np.ravel(one + 0 * np.asarray(solved.motion.phi))[k] for one in rods)
        m, S = made["m"]["4"], solved.motion.acceleration(centre(made, "4"))[k]
        rail = m * (S + 1j * G) - on_both
        assert normal[k] == pytest.approx((np.conj(-own["toward"]) * rail).real, abs=1e-8 * abs(rail))
        assert abs(friction[k]) == pytest.approx(
            abs((np.conj(own["along"]) * rail).real), abs=1e-8 * abs(rail)
        )
        needs = wheel_quantities.friction_of(friction, normal)[k]
        assert np.isnan(needs) if normal[k] <= 0 else needs == pytest.approx(abs(friction[k]) / normal[k])
