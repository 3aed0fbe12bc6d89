"""Random mechanisms that a stroke drives, as texts of variants: every one is first put together in one position, which
is its sketch; lengths are those between its points there."""

import cmath
import math

import numpy as np
import yaml


class Made:
    """Points in one position -> the text of a variant. All numbers are SI without units."""

    def __init__(self, rng, places):
        self.rng, self.places = rng, places
        self.links, self.guides, self.frame = {}, {}, {}

    def fixed(self, *names):
        self.frame |= {name: [self.places[name].real, self.places[name].imag] for name in names}

    def link(self, name, *points, mass=True, **more):
        """In axes that begin at its first point and go through the second."""
        at = [self.places[point] for point in points]
        turn = cmath.exp(-1j * cmath.phase(at[1] - at[0])) if len(at) > 1 else 1
        own = {
            point: [z.real, z.imag] for point, z in zip(points, ((z - at[0]) * turn for z in at), strict=True)
        }
        if mass:
            centre = f"S{name}"
            where = complex(*self.rng.uniform(-0.1, 0.2, 2)) if len(at) > 1 else 0j
            own[centre] = [where.real, where.imag]
            more |= {"mass": float(self.rng.uniform(2, 30)), "mass_centre": centre}
            if len(at) > 1:
                more["inertia"] = float(self.rng.uniform(0.05, 2))
        self.links[name] = {"points": own, **more}

    def guide(self, name, through, angle=0.0, link="0"):
        self.guides[name] = {"through": through, "angle": f"{float(angle)!r} deg", "link": link}

    def text(self, drive, stroke, loaded, keys=None):
        share = self.rng.choice([-1, 1]) * self.rng.uniform(0.01, 0.03)
        time = float(self.rng.uniform(0.3, 1.0))
        law = {"from": float(stroke), "speed": float(stroke * share / time), "time": time}
        force = {
            "at": loaded,
            "direction": f"{float(self.rng.uniform(0, 360))!r} deg",
            "constant": float(self.rng.uniform(100, 2000)),
        }
        sketch = {p: [float(z.real), float(z.imag)] for p, z in self.places.items() if p not in self.frame}
        mechanism = {
            "frame": self.frame,
            "guides": self.guides,
            "links": self.links,
            "driver": {**drive, "stroke": law},
        }
        if keys is not None:
            mechanism["assembly"] = keys
        else:
            mechanism["sketch"] = sketch
        loads = {"gravity": 9.81, "forces": [force]}
        whole = {"language": "en", "mechanism": mechanism, "loads": loads, "positions": {"table": 6}}
        return yaml.safe_dump(whole, sort_keys=False)


def spread(rng, **places):
    """Places moved by up to a tenth of a metre."""
    return {name: z + complex(*rng.uniform(-0.1, 0.1, 2)) for name, z in places.items()}


def _four_bar(rng, **more):
    z = spread(rng, O=0j, A=0.1 + 0.4j, B=0.9 + 0.8j, D=1.1 + 0j, **more)
    made = Made(rng, z)
    made.fixed("O", "D")
    return made, z


def coupler(rng):
    """A cylinder from a fixed point to a point of a coupler."""
    made, z = _four_bar(rng, K=0.4 + 1.1j, G=-0.7 + 0.9j)
    made.fixed("G")
    made.link("1", "O", "A")
    made.link("2", "A", "B", "K")
    made.link("3", "D", "B")
    return made.text({"cylinder": ["G", "K"]}, abs(z["K"] - z["G"]), "K")


def between(rng):
    """A cylinder between a crank and the coupler of the rocker's side."""
    made, z = _four_bar(rng, P=-0.3 + 0.25j, K=0.6 + 1.2j)
    made.link("1", "O", "A", "P")
    made.link("2", "A", "B", "K")
    made.link("3", "D", "B")
    return made.text({"cylinder": ["P", "K"]}, abs(z["K"] - z["P"]), "S2")


def stated_cylinder(rng):
    """The same with barrel and rod as links."""
    made, z = _four_bar(rng, P=-0.3 + 0.25j, K=0.6 + 1.2j)
    made.link("1", "O", "A", "P")
    made.link("2", "A", "B", "K")
    made.link("3", "D", "B")
    made.guide("axis", "P", link="8")
    for name, own in (("8", "P"), ("9", "K")):
        side = 0.2 if name == "8" else -0.2
        made.links[name] = {
            "points": {own: [0.0, 0.0], f"S{name}": [side, 0.01]},
            "mass": 5.0,
            "mass_centre": f"S{name}",
            "inertia": 0.1,
        }
    made.links["9"]["slides"] = "axis"
    return made.text({"cylinder": ["P", "K"]}, abs(z["K"] - z["P"]), "S2")


def six_bar(rng):
    """A cylinder between links of two loops."""
    made, z = _four_bar(rng, E=1.6 + 0.9j, H=1.9 + 0.05j, C=1.0 + 0.45j, P=-0.2 + 0.5j, K=1.4 + 1.3j)
    made.fixed("H")
    made.link("1", "O", "A", "P")
    made.link("2", "A", "B")
    made.link("3", "D", "B", "C")
    made.link("4", "C", "E", "K")
    made.link("5", "H", "E")
    return made.text({"cylinder": ["P", "K"]}, abs(z["K"] - z["P"]), "K")


def scissor(rng):
    """A lift table, its cylinder between the arms."""
    arm, angle = rng.uniform(0.6, 1.2), rng.uniform(0.3, 0.7)
    reach = 2 * arm * cmath.exp(1j * angle)
    z = {"O": 0j, "C": reach / 2, "F": reach, "D": complex(reach.real, 0), "E": complex(0, reach.imag)}
    z |= spread(rng, P=0.65 * reach, Q=0.8 * z["D"] + 0.2 * z["E"], S4=z["E"] + 0.4 + 0.1j)
    made = Made(rng, z)
    made.fixed("O")
    made.guide("floor", "O")
    made.link("1", "O", "F", "C", "P")
    made.link("2", "D", "E", "C", "Q")
    made.link("3", "D", slides="floor")
    made.links["4"] = {
        "points": {"E": [0.0, 0.0], "S4": [0.5, 0.1]},
        "mass": 60.0,
        "mass_centre": "S4",
        "inertia": 5.0,
    }
    made.link("5", "F", mass=False, slides="table")
    made.guide("table", "E", link="4")
    return made.text(
        {"cylinder": ["Q", "P"]}, abs(z["P"] - z["Q"]), "S4", {"C": "up", "D": "right", "4-5": "+"}
    )


def slot(rng):
    """A slider with a pin in the slot of a rocker."""
    made = Made(rng, z := spread(rng, O=0j, P=0.5 + 0.7j, U=0.1 + 0.7j))
    made.fixed("O", "U")
    angle = math.degrees(cmath.phase(z["P"] - z["U"]))
    made.guide("x", "U", angle)
    made.link("1", "P", slides="x")
    made.links["2"] = {
        "points": {"O": [0.0, 0.0], "S2": [0.4, 0.05]},
        "mass": 8.0,
        "mass_centre": "S2",
        "inertia": 0.4,
    }
    made.places["S2"] = (z["P"] - z["O"]) / abs(z["P"] - z["O"]) * (0.4 + 0.05j) + z["O"]
    made.guide("slot", "O", link="2")
    made.link("3", "P", mass=False, slides="slot")
    return made.text({"slider": "1"}, abs(z["P"] - z["U"]), "S2")


def two_sliders(rng):
    """A slider whose rod leads to another slider, and this one's to a crank."""
    z = spread(rng, O=0j, A=0.35 + 0.1j, B=0.6 + 0.75j, V=0.6 - 0.4j, U=-0.9 + 0.3j, C=-0.4 + 0.3j)
    made = Made(rng, z)
    made.fixed("O", "U", "V")
    made.guide("one", "U", math.degrees(cmath.phase(z["C"] - z["U"])))
    made.guide("two", "V", math.degrees(cmath.phase(z["B"] - z["V"])))
    made.link("1", "C", slides="one")
    made.link("2", "C", "B")
    made.link("3", "B", slides="two")
    made.link("4", "B", "A")
    made.link("5", "O", "A")
    return made.text({"slider": "1"}, abs(z["C"] - z["U"]), "B")


def rocking(lengths, angle, base, speed):
    """A four-bar linkage put together at an angle of its first link, a cylinder from a fixed point to its coupler."""
    one, two, three = lengths
    z = {"O": 0j, "D": 1 + 0j, "A": one * cmath.exp(1j * angle), "G": base}
    way = z["D"] - z["A"]
    corner = math.acos((two**2 + abs(way) ** 2 - three**2) / (2 * two * abs(way)))
    along = way / abs(way) * cmath.exp(1j * corner)
    z |= {"B": z["A"] + two * along, "K": z["A"] + (0.3 + 0.2j) * along}
    made = Made(np.random.default_rng(1), z)
    made.fixed("O", "D", "G")
    made.link("1", "O", "A")
    made.link("2", "A", "B", "K")
    made.link("3", "D", "B")
    whole = yaml.safe_load(made.text({"cylinder": ["G", "K"]}, abs(z["K"] - base), "K"))
    whole["mechanism"]["driver"]["stroke"] |= {"speed": speed, "time": 1.0}
    return yaml.safe_dump(whole, sort_keys=False)


KINDS = {of.__name__: of for of in (coupler, between, stated_cylinder, six_bar, scissor, slot, two_sliders)}


def made(kind, seed):
    return KINDS[kind](np.random.default_rng(seed))
