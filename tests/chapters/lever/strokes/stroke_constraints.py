"""A solver of the tests' own for mechanisms that a stroke drives: the equations of all constraints, from the text of a
variant, solved together in 40 digits; rates by differences in time; the driving force by virtual power, and with all
reactions by the Newton–Euler equations of every link. It shares no code with the program.
"""

import math
from itertools import pairwise

import mpmath as mp
import numpy as np
import yaml

mp.mp.dps = 40
STEP = mp.mpf(10) ** -9  # of the differences in time, relative to the period


class Solver:
    """Of numbers in SI alone, places of points as [x, y]; the stroke is `start` + `speed` t."""

    def __init__(self, text):
        data = yaml.safe_load(text)
        of = data["mechanism"]
        self.loads = data["loads"]
        self.fixed = {name: complex(*at) for name, at in of["frame"].items()}
        self.links = {str(name): link for name, link in of["links"].items()}
        self.names = list(self.links)
        self.points = {
            name: {p: complex(*at) for p, at in link["points"].items()} for name, link in self.links.items()
        }
        self.guides = of.get("guides", {})
        self.drive = of["driver"]
        stroke = self.drive["stroke"]
        self.start, self.speed, self.period = stroke["from"], stroke["speed"], stroke["time"]

    # ------------------------------------------------------------ places

    def place(self, q, link, at):
        """Of a point in a link's axes, x and y."""
        if link == "0":
            return [mp.mpf(at.real), mp.mpf(at.imag)]
        x, y, angle = q[3 * self.names.index(link) :][:3]
        c, s = mp.cos(angle), mp.sin(angle)
        return [x + c * at.real - s * at.imag, y + s * at.real + c * at.imag]

    def pins(self):
        """Pairs of links at every revolute joint, with the point."""
        at = {}
        for point in self.fixed:
            at.setdefault(point, []).append("0")
        for name in self.names:
            for point in self.points[name]:
                at.setdefault(point, []).append(name)
        return [(point, one, other) for point, links in at.items() for one, other in pairwise(links)]

    def slides(self):
        """Sliding link, its point, the link of the guide, the guide's point and angle."""
        for name, link in self.links.items():
            if "slides" in link:
                guide = self.guides[link["slides"]]
                carrier = str(guide.get("link", "0"))
                own = self.fixed if carrier == "0" else self.points[carrier]
                point = next(iter(self.points[name].values()))
                yield (
                    name,
                    point,
                    carrier,
                    own[guide["through"]],
                    math.radians(float(str(guide.get("angle", "0")).split()[0])),
                )

    def at(self, point):
        """A link that has a point, and its place there: of several the last, as those of a cylinder are stated."""
        if point in self.fixed:
            return "0", self.fixed[point]
        return [(name, own[point]) for name, own in self.points.items() if point in own][-1]

    def stroke(self, q):
        if "slider" in self.drive:
            _, point, _, base, angle = next(
                one for one in self.slides() if one[0] == str(self.drive["slider"])
            )
            x, y = self.place(q, str(self.drive["slider"]), point)
            return (x - base.real) * mp.cos(angle) + (y - base.imag) * mp.sin(angle)
        (x, y), (u, v) = (self.place(q, *self.at(point)) for point in self.drive["cylinder"])
        return mp.sqrt((u - x) ** 2 + (v - y) ** 2)

    def residual(self, q, stroke):
        found = [self.stroke(q) - stroke]
        for point, one, other in self.pins():
            here, there = (
                self.place(q, link, self.fixed[point] if link == "0" else self.points[link][point])
                for link in (one, other)
            )
            found += [here[0] - there[0], here[1] - there[1]]
        for link, point, carrier, base, angle in self.slides():
            turn = (0 if carrier == "0" else q[3 * self.names.index(carrier) + 2]) + angle
            (x, y), (u, v) = self.place(q, link, point), self.place(q, carrier, base)
            found += [
                (y - v) * mp.cos(turn) - (x - u) * mp.sin(turn),
                mp.sin(q[3 * self.names.index(link) + 2] - turn),
            ]
        return found

    def jacobian(self, q):
        """In double accuracy: enough for a chord method, whose steps gain some eight digits each."""
        h = mp.mpf(10) ** -15
        columns = []
        for k in range(len(q)):
            ahead, behind = list(q), list(q)
            ahead[k], behind[k] = q[k] + h, q[k] - h
            rows = zip(self.residual(ahead, 0), self.residual(behind, 0), strict=True)
            columns.append([float((a - b) / (2 * h)) for a, b in rows])
        return np.array(columns).T

    def solved(self, t, guess):
        """All coordinates at a time."""
        q = [mp.mpf(float(x)) for x in guess]
        for _ in range(30):
            inverse = np.linalg.inv(self.jacobian(q))
            for _ in range(4):
                off = self.residual(q, self.start + self.speed * mp.mpf(t))
                step = [sum(mp.mpf(float(a)) * b for a, b in zip(row, off, strict=True)) for row in inverse]
                q = [a - b for a, b in zip(q, step, strict=True)]
            if max(map(abs, off)) < mp.mpf(10) ** -35:
                return q
        raise AssertionError("the constraints have no solution near the guess")

    def motion(self, t, guess):
        """Coordinates, their rates and accelerations, doubles."""
        h = STEP * self.period
        here, ahead, behind = (self.solved(mp.mpf(t) + k * h, guess) for k in (0, 1, -1))
        rate = [(a - b) / (2 * h) for a, b in zip(ahead, behind, strict=True)]
        second = [(a - 2 * c + b) / h**2 for a, b, c in zip(ahead, behind, here, strict=True)]
        return tuple(np.array([float(x) for x in part]) for part in (here, rate, second))

    # ------------------------------------------------------------ forces

    def of_point(self, motion, link, at):
        """Place, velocity and acceleration of a point of a link, complex."""
        if link == "0":
            return at, 0j, 0j
        k = 3 * self.names.index(link)
        (x, y, angle), (vx, vy, w), (ax, ay, e) = (part[k : k + 3] for part in motion)
        arm = at * np.exp(1j * angle)
        return complex(x, y) + arm, complex(vx, vy) + 1j * w * arm, complex(ax, ay) + (1j * e - w**2) * arm

    def loaded(self, motion):
        """Force and moment about the origin of the frame on every link: weight, inertia, stated forces."""
        found = {}
        for name, link in self.links.items():
            k = 3 * self.names.index(name)
            force, moment = 0j, -link.get("inertia", 0.0) * motion[2][k + 2]
            if link.get("mass"):
                place, _, a = self.of_point(motion, name, self.points[name][link["mass_centre"]])
                push = link["mass"] * (-1j * self.loads["gravity"] - a)
                force, moment = force + push, moment + (np.conj(place) * push).imag
            found[name] = [force, moment]
        for one in self.loads.get("forces", []):
            link, at = self.at(one["at"])
            angle = math.radians(float(str(one["direction"]).split()[0]))
            push = one["constant"] * np.exp(1j * angle)
            place = self.of_point(motion, link, at)[0]
            found[link][0] += push
            found[link][1] += (np.conj(place) * push).imag
        return found

    def by_power(self, motion):
        """The driving force by virtual power."""
        power = 0.0
        for name, (force, moment) in self.loaded(motion).items():
            k = 3 * self.names.index(name)
            v0 = complex(*motion[1][k : k + 2]) - 1j * motion[1][k + 2] * complex(*motion[0][k : k + 2])
            power += (np.conj(v0) * force).real + motion[1][
                k + 2
            ] * moment  # v of the link's point at the origin
        return -power / self.speed

    def by_equilibrium(self, motion):
        """The driving force and the forces in the joints, (point, link, link) -> of the first on the second."""
        loads, unknown = self.loaded(motion), []
        columns = []

        def column(pushes, key):
            row = np.zeros(3 * len(self.names))
            for link, force, place, couple in pushes:
                if link != "0":
                    k = 3 * self.names.index(link)
                    row[k] += force.real
                    row[k + 1] += force.imag
                    row[k + 2] += (np.conj(place) * force).imag + couple
            columns.append(row)
            unknown.append(key)

        for point, one, other in self.pins():
            at = self.fixed[point] if one == "0" else self.points[one][point]
            place = self.of_point(motion, one, at)[0]
            for e in (1 + 0j, 1j):
                column([(other, e, place, 0), (one, -e, place, 0)], (point, one, other))
        for link, point, carrier, _, angle in self.slides():
            turn = (0 if carrier == "0" else motion[0][3 * self.names.index(carrier) + 2]) + angle
            place, n = self.of_point(motion, link, point)[0], 1j * np.exp(1j * turn)
            column([(link, n, place, 0), (carrier, -n, place, 0)], "guide")
            column([(link, 0j, place, 1), (carrier, 0j, place, -1)], "guide")
        if "slider" in self.drive:
            slider = str(self.drive["slider"])
            _, point, _, _, angle = next(one for one in self.slides() if one[0] == slider)
            column([(slider, np.exp(1j * angle), self.of_point(motion, slider, point)[0], 0)], "drive")
        else:
            (one, at), (other, to) = (self.at(point) for point in self.drive["cylinder"])
            start, end = self.of_point(motion, one, at)[0], self.of_point(motion, other, to)[0]
            along = (end - start) / abs(end - start)
            column([(other, along, end, 0), (one, -along, start, 0)], "drive")
        right = np.concatenate([[-f.real, -f.imag, -m] for f, m in (loads[name] for name in self.names)])
        found = np.linalg.solve(np.array(columns).T, right)
        joints = {}
        for key, x in zip(unknown, found, strict=True):
            if isinstance(key, tuple):
                joints.setdefault(key, []).append(x)
        return found[unknown.index("drive")], {key: complex(*xy) for key, xy in joints.items()}
