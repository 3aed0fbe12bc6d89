"""mujoco: a tree of hinges and slides, loops closed by soft `connect` equalities, integrated in time.

Its documentation (XML reference, equality/connect; Computation, "Solver parameters"): solref's time constant is at
least two time steps; solimp is at most 0.9999, so the constraint is soft by 1e-4 of the acceleration. The crank keeps
its speed by a great `armature` (inertia of a rotor on its joint), and the moment of the drive is what that inertia
gives. Sensors framepos, framelinvel, framelinacc; accelerations of sensors have gravity's in them.
"""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Rod, Scene, Slider, starts

ROTOR = 1e9  # kg·m², so great that the crank's speed stays


def prepare(scene: Scene, phi: Array, steps: int = 100, integrator: str = "Euler") -> Call:
    """`integrator`: "Euler" is semi-implicit, MuJoCo's default; "RK4" has better velocities, worse accelerations."""
    import mujoco

    step = float(abs((phi[1] - phi[0]) / scene.omega)) / steps
    model = mujoco.MjModel.from_xml_string(_xml(scene, step, integrator))
    data = mujoco.MjData(model)
    qpos, qvel = _start(scene, float(phi[0]))
    bodies = {p: mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, f"at {p}") for p in scene.forces}
    names = [model.sensor(k).name for k in range(model.nsensor)]

    said: list[str] = []
    mujoco.set_mju_user_warning(said.append)  # else they go to a file in the folder where one stands

    def run() -> Found:
        said.clear()
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = qpos, qvel
        rows, moments = [], []
        for k in range(len(phi)):
            for point, body in bodies.items():
                data.xfrc_applied[body, 0] = scene.forces[point][k]
            if k:
                mujoco.mj_step(model, data, nstep=steps)
            mujoco.mj_forward(model, data)
            rows.append(data.sensordata.copy())
            moments.append(-ROTOR * data.qacc[0])
        if said:
            raise Refused(said[0])
        return _named(scene, names, np.array(rows), np.array(moments))

    return run


def _named(scene: Scene, names: list[str], rows: Array, moments: Array) -> Found:
    found: Found = {"moment": moments}
    for k, name in enumerate(names):
        found[name] = rows[:, 3 * k] + 1j * rows[:, 3 * k + 1]
        if name.startswith("a_"):
            found[name] += 1j * scene.gravity
    return found


def _start(scene: Scene, phi: float) -> tuple[Array, Array]:
    """Joint coordinates and rates: the crank; of every rod the angle to its parent, then slider or rocker."""
    at = starts(scene, phi)
    turns, speeds, q, v = {"A": phi}, {"A": scene.omega}, [phi], [scene.omega]
    for rod in scene.rods:
        total, w = float(np.angle(at[rod.end] - at[rod.start])), at[f"w_{rod.end}"].real
        q.append(total - turns[rod.start])
        v.append(w - speeds[rod.start])
        for point in (rod.end, *rod.points):
            turns[point], speeds[point] = total, w
        if isinstance(rod.out, Slider):
            q.append(at[rod.end].real)
            v.append(at[f"v_{rod.end}"].real)
        else:
            arm = at[rod.end] - rod.out.pivot
            q.append(float(np.angle(arm)))
            v.append(float((at[f"v_{rod.end}"] / (1j * arm)).real))
    order = _order(scene)
    return np.array(q)[order], np.array(v)[order]


def _order(scene: Scene) -> list[int]:
    """Coordinates stand in the order of the tree: the crank with its rods, nested, then sliders and rockers."""
    nested: list[int] = [0]

    def walk(parent: str) -> None:
        for k, rod in enumerate(scene.rods):
            if rod.start in _points_of(scene, parent):
                nested.append(1 + 2 * k)
                walk(rod.end)

    walk("A")
    return nested + [2 + 2 * k for k in range(len(scene.rods))]


def _points_of(scene: Scene, end: str) -> tuple[str, ...]:
    rod = next((rod for rod in scene.rods if rod.end == end), None)
    return ("A",) if rod is None else (rod.end, *rod.points)


def _xml(scene: Scene, step: float, integrator: str) -> str:
    outs = "".join(_out(rod) for rod in scene.rods)
    joins = "".join(
        f'<connect site1="{r.end}" site2="end of {r.end}"'
        f' solref="{2 * step!r} 1" solimp="0.9999 0.9999 0.001"/>'
        for r in scene.rods
    )
    kinds = (("", "framepos"), ("v_", "framelinvel"), ("a_", "framelinacc"))
    sensors = "".join(
        f"<{tag} name={quoteattr(kind + p)} objtype='site' objname={quoteattr(p)}/>"
        for p in scene.points
        for kind, tag in kinds
    )
    return f"""<mujoco><compiler angle="radian" boundmass="1e-9" boundinertia="1e-12" balanceinertia="true"/>
<option timestep="{step!r}" integrator="{integrator}" gravity="0 {scene.gravity!r} 0" iterations="200"
 tolerance="1e-14"><flag contact="disable"/></option>
<worldbody><body name="crank"><joint type="hinge" axis="0 0 1" armature="{ROTOR!r}"/>
<inertial pos="0 0 0" mass="1e-9" diaginertia="1e-12 1e-12 1e-12"/>{_site("A", scene.crank)}
{_rods(scene, "A")}</body>{outs}</worldbody><equality>{joins}</equality><sensor>{sensors}</sensor></mujoco>"""


def _site(point: str, at: float) -> str:
    return f'<site name="{point}" pos="{at!r} 0 0"/>'


def _inertial(mass: float, inertia: float, at: float = 0.0) -> str:
    """Only the inertia about z is felt; the others are what MuJoCo asks of a body: no less than half of it each."""
    m, J = max(mass, 1e-9), max(inertia, 1e-12)
    return f'<inertial pos="{at!r} 0 0" mass="{m!r}" diaginertia="{J!r} {J!r} {J!r}"/>'


def _rods(scene: Scene, parent: str) -> str:
    text = ""
    for rod in scene.rods:
        if rod.start in _points_of(scene, parent):
            above = scene.carrier(rod.start)
            at = scene.crank if above is None else above.at(rod.start)
            sites = "".join(_site(p, rod.at(p)) for p in (rod.end, *rod.points))
            text += f'<body name="to {rod.end}" pos="{at!r} 0 0"><joint type="hinge" axis="0 0 1"/>'
            text += (
                _inertial(rod.mass, rod.inertia, rod.at(rod.centre))
                + sites
                + _rods(scene, rod.end)
                + "</body>"
            )
    return text


def _out(rod: Rod) -> str:
    """The loop is closed between sites: between bodies it would be closed as they lie at first, all rods along x."""
    site = _site(f"end of {rod.end}", rod.out.length if not isinstance(rod.out, Slider) else 0.0)
    if isinstance(rod.out, Slider):
        joint = f'pos="0 {rod.out.offset!r} 0"><joint type="slide" axis="1 0 0"/>'
        return f'<body name="at {rod.end}" {joint}{_inertial(rod.out.mass, 0.0)}{site}</body>'
    place = f"{rod.out.pivot.real!r} {rod.out.pivot.imag!r} 0"
    joint = f'pos="{place}"><joint type="hinge" axis="0 0 1"/>'
    return f'<body name="at {rod.end}" {joint}{_inertial(0.0, rod.out.inertia)}{site}</body>'


PEER = Peer(
    "mujoco",
    "mujoco",
    prepare,
    {f"{n} steps a position": {"steps": n} for n in (100, 10, 1000)}
    | {"RK4, 100 steps a position": {"steps": 100, "integrator": "RK4"}},
)
