"""The numbers of every kind of ordinary stage, a sheet each. A key that ends in 1 or 2 is of the driving or of the
driven wheel, whose number in the drive is the index of its letter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, both

PUT, SET, SLIDE = NP_("index", "put"), NP_("index", "set"), NP_("index", "slide")
MAX, MIN = NP_("index", "max"), NP_("index", "min")
MESH, BACK = NP_("index", "mesh"), NP_("index", "back")
BELT, CHAIN = NP_("index", "belt"), NP_("index", "chain")  # of what a drive has of both
SLIP, LOST = NP_("index", "slip"), NP_("index", "lost")
RATIO = N_("ratio of the stage")


class Numbers(Sheet):
    """Of a stage whose wheels are `wheels`; its names in the results begin with `label`."""

    def __init__(self, wheels: Sequence[str], label: str):
        super().__init__({key: self._called(one, wheels) for key, one in self.DECLARED.items()}, label)

    @staticmethod
    def _called(one: Q, wheels: Sequence[str]) -> Q:
        symbol, ends = one.symbol, (wheels[0], wheels[-1])
        if symbol is None:
            return one
        if one.key in ("u", "u_required"):
            return one.called(replace(symbol, sub=both(*ends)))
        last = one.key[-1]
        return one.called(replace(symbol, sub=symbol.sub + ends[int(last) - 1])) if last in "12" else one


class Belt(Numbers):
    d1 = Q("d", "m", N_("diameter of the driving pulley"), "mm")
    d2 = Q("d", "m", N_("diameter of the driven pulley"), "mm")
    d_exact = Q(Symbol("d", "", "′"), "m", N_("diameter of the driven pulley required by the ratio"), "mm")
    epsilon = Q(
        Symbol("epsilon", SLIP),
        "",
        N_("slip coefficient (fraction of the velocity that the driven pulley loses)"),
    )
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    a_about = Q(Symbol("a", BELT, "′"), "m", N_("centre distance before the belt is chosen"), "mm")
    L_about = Q(Symbol("L", BELT, "′"), "m", N_("length of the belt at this distance"), "mm")
    a = Q(Symbol("a", BELT), "m", N_("centre distance"), "mm")
    theta = Q("theta", "rad", N_("angle of a strand with the line of centres"))
    alpha1 = Q("alpha", "rad", N_("angle of wrap of the driving pulley"))
    alpha2 = Q("alpha", "rad", N_("angle of wrap of the driven pulley"))
    L = Q(Symbol("L", BELT), "m", N_("length of the belt"), "mm")
    omega1 = Q(Symbol("omega", f"{BELT},"), "rad/s", N_("angular velocity of the driving pulley"))
    v = Q(Symbol("v", BELT), "m/s", N_("velocity of the belt"))
    runs = Q("i", "1/s", N_("passes of the belt per second"))
    T1 = Q("T", "N·m", N_("torque on the driving pulley"))
    F_t = Q(Symbol("F", f"t,{BELT}"), "N", N_("circumferential force"))
    phi = Q("phi", "deg", N_("angle between the sides of a groove"))
    f = Q("f", "", N_("coefficient of friction"))
    f_red = Q(Symbol("f", "", "′"), "", N_("reduced coefficient of friction in the groove"))
    k = Q(Symbol("k", BELT), "", N_("safety factor of the belt against slipping"))
    m = Q(Symbol("m", BELT), "", N_("greatest ratio of the tensions of the tight and the slack strand"))
    F_0 = Q("F_0", "N", N_("least tension of a strand at rest, centrifugal forces left out"))
    F_tight = Q("F_1", "N", N_("tension of the tight strand"))
    F_slack = Q("F_2", "N", N_("tension of the slack strand"))
    q = Q(Symbol("q", BELT), "kg/m", N_("mass of a metre of the belt"))
    F_c = Q("F_c", "N", N_("centrifugal tension"))
    F_put = Q(Symbol("F", PUT), "N", N_("tension with which the belt is put on"))
    F_shaft = Q("R", "N", N_("force with which the strands pull a shaft"))


class Chain(Numbers):
    z1 = Q("z", "", N_("number of teeth of the driving sprocket"), digits=9)
    z2 = Q("z", "", N_("number of teeth of the driven sprocket"), digits=9)
    z_exact = Q(Symbol("z", "", "′"), "", N_("number of teeth of the driven sprocket required by the ratio"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    p = Q("p", "m", N_("pitch of the chain"), "mm")
    d1 = Q("d", "m", N_("pitch diameter of the driving sprocket"), "mm")
    d2 = Q("d", "m", N_("pitch diameter of the driven sprocket"), "mm")
    a_about = Q(Symbol("a", CHAIN, "′"), "m", N_("centre distance before the links are counted"), "mm")
    links_about = Q(Symbol("W", "", "′"), "", N_("number of links at this distance"))
    links = Q("W", "", N_("number of links of the chain"), digits=9)
    a = Q(Symbol("a", CHAIN), "m", N_("centre distance of a taut chain"), "mm")
    slack = Q("epsilon", "", N_("part by which the distance is made shorter, so that the chain sags"))
    a_put = Q(Symbol("a", f"{CHAIN},{SET}"), "m", N_("distance at which the sprockets are set"), "mm")
    L = Q(Symbol("L", CHAIN), "m", N_("length of the chain"), "mm")
    omega1 = Q("omega", "rad/s", N_("angular velocity of the driving sprocket"))
    v = Q(Symbol("v", CHAIN), "m/s", N_("mean velocity of the chain"))
    v_max = Q(Symbol("v", f"{CHAIN},{MAX}"), "m/s", N_("greatest velocity of the chain along itself"))
    v_min = Q(Symbol("v", f"{CHAIN},{MIN}"), "m/s", N_("least velocity of the chain along itself"))
    delta = Q("delta", "", N_("unevenness of the chain's velocity, as it runs on a polygon"))
    T1 = Q("T", "N·m", N_("torque on the driving sprocket"))
    F_t = Q(Symbol("F", f"t,{CHAIN}"), "N", N_("circumferential force"))
    q = Q(Symbol("q", CHAIN), "kg/m", N_("mass of a metre of the chain"))
    F_c = Q(Symbol("F", f"c,{CHAIN}"), "N", N_("centrifugal tension"))
    F_tight = Q(Symbol("F", f"1,{CHAIN}"), "N", N_("tension of the driving strand"))


class Friction(Numbers):
    d1 = Q("d", "m", N_("diameter of the driving wheel"), "mm")
    d2 = Q("d", "m", N_("diameter of the driven wheel"), "mm")
    epsilon = Q(
        Symbol("epsilon", SLIP),
        "",
        N_("slip coefficient (fraction of the velocity that the driven wheel loses)"),
    )
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    a = Q("a", "m", N_("centre distance"), "mm")
    sigma = Q("Sigma", "deg", N_("angle between the axes"))
    delta1 = Q("delta", "deg", N_("cone angle of the driving wheel"))
    delta2 = Q("delta", "deg", N_("cone angle of the driven wheel"))
    omega1 = Q("omega", "rad/s", N_("angular velocity of the driving wheel"))
    v = Q("v", "m/s", N_("velocity of the circumference of the driving wheel"))
    v_slip = Q(Symbol("v", SLIDE), "m/s", N_("velocity of slipping"))
    T1 = Q("T", "N·m", N_("torque on the driving wheel"))
    F_t = Q("F_t", "N", N_("circumferential force"))
    f = Q("f", "", N_("coefficient of friction"))
    k = Q("k", "", N_("reserve against slipping"))
    F_n = Q("F_n", "N", N_("force that presses the wheels together"))
    F_a1 = Q("F_a", "N", N_("axial force that presses the driving cone"))
    F_a2 = Q("F_a", "N", N_("axial force that presses the driven cone"))
    b = Q("b", "m", N_("length of the line of contact"), "mm")
    q_n = Q("q_n", "N/m", N_("pressing force on a metre of the line of contact"), "N/mm", formed="N/m")


class PairOfWheels(Numbers):
    z1 = Q("z", "", N_("number of teeth of the driving wheel"), digits=9)
    z2 = Q("z", "", N_("number of teeth of the driven wheel"), digits=9)
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    omega1 = Q("omega", "rad/s", N_("angular velocity of the driving wheel"))
    T1 = Q("T", "N·m", N_("torque on the driving wheel"))


class Train(Numbers):
    """`rows`: of its wheels, in their order."""

    rows: tuple[TrainWheel, ...] = ()
    m = Q("m", "m", N_("module"), "mm")
    z_exact = Q(Symbol("z", "", "′"), "", N_("number of teeth of the driven wheel required by the ratio"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    a = Q(
        "a",
        "m",
        N_("distance between the axes of the driving and the driven wheel, all axes in a plane"),
        "mm",
    )
    eta_mesh = Q("eta", "", N_("efficiency of a mesh"))
    omega1 = Q("omega", "rad/s", N_("angular velocity of the driving wheel"))
    T1 = Q("T", "N·m", N_("torque on the driving wheel"))


class TrainWheel(Row):
    """Of a wheel; its forces with the wheel after it."""

    z = Q("z", "", N_("number of teeth"), digits=9)
    d = Q("d", "m", N_("pitch diameter"), "mm")
    a = Q("a", "m", N_("distance from the axis of the next wheel"), "mm")
    F_t = Q("F_t", "N", N_("circumferential force on the next wheel"))
    F_r = Q("F_r", "N", N_("radial force on the next wheel"))
    F_axis = Q("R", "N", N_("force of both meshes on the axis of an idler"))


class Bevel(Numbers):
    z1 = Q("z", "", N_("number of teeth of the driving wheel"), digits=9)
    z2 = Q("z", "", N_("number of teeth of the driven wheel"), digits=9)
    z_exact = Q(Symbol("z", "", "′"), "", N_("number of teeth of the driven wheel required by the ratio"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    sigma = Q("Sigma", "deg", N_("angle between the axes"))
    delta1 = Q("delta", "deg", N_("pitch cone angle of the driving wheel"))
    delta2 = Q("delta", "deg", N_("pitch cone angle of the driven wheel"))
    m_e = Q("m_e", "m", N_("outer module"), "mm")
    m_m = Q("m_m", "m", N_("mean module"), "mm")
    psi = Q("psi", "", N_("ratio of the facewidth to the outer cone distance"))
    b = Q("b", "m", N_("facewidth"), "mm")
    R_e = Q("R_e", "m", N_("outer cone distance"), "mm")
    R_m = Q("R_m", "m", N_("mean cone distance"), "mm")
    d_e1 = Q("d_e", "m", N_("outer pitch diameter of the driving wheel"), "mm")
    d_e2 = Q("d_e", "m", N_("outer pitch diameter of the driven wheel"), "mm")
    d_m1 = Q("d_m", "m", N_("mean pitch diameter of the driving wheel"), "mm")
    d_m2 = Q("d_m", "m", N_("mean pitch diameter of the driven wheel"), "mm")
    z_v1 = Q("z_v", "", N_("number of teeth of the equivalent spur gear of the driving one"))
    z_v2 = Q("z_v", "", N_("number of teeth of the equivalent spur gear of the driven one"))
    alpha = Q("alpha", "deg", N_("profile angle of the basic rack"))
    omega1 = Q("omega", "rad/s", N_("angular velocity of the driving wheel"))
    v = Q("v_m", "m/s", N_("velocity at the mean pitch circles"))
    T1 = Q("T", "N·m", N_("torque on the driving wheel"))
    F_t = Q("F_mt", "N", N_("circumferential force at the mean pitch circles"))
    F_r1 = Q("F_r", "N", N_("radial force on the driving wheel"))
    F_a1 = Q("F_a", "N", N_("axial force on the driving wheel"))
    F_r2 = Q("F_r", "N", N_("radial force on the driven wheel"))
    F_a2 = Q("F_a", "N", N_("axial force on the driven wheel"))


class Worm(Numbers):
    z1 = Q("z", "", N_("number of starts of the worm"), digits=9)
    z2 = Q("z", "", N_("number of teeth of the wheel"), digits=9)
    z_exact = Q(Symbol("z", "", "′"), "", N_("number of teeth of the driven wheel required by the ratio"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    u = Q("u", "", RATIO)
    m = Q("m", "m", N_("module"), "mm")
    q = Q("q", "", N_("diameter quotient of the worm"))
    gamma = Q("gamma", "deg", N_("lead angle of the thread"))
    d1 = Q("d", "m", N_("pitch diameter of the worm"), "mm")
    d2 = Q("d", "m", N_("pitch diameter of the wheel"), "mm")
    a = Q("a_w", "m", N_("centre distance"), "mm")
    f = Q(Symbol("f", "", "′"), "", N_("reduced coefficient of friction"))
    phi = Q(Symbol("phi", "", "′"), "deg", N_("reduced angle of friction"))
    k = Q(Symbol("k", LOST), "", N_("factor of the losses outside the mesh"))
    eta_mesh = Q(Symbol("eta", MESH), "", N_("efficiency of the mesh"))
    eta = Q("eta", "", N_("efficiency of the stage"))
    eta_back = Q(Symbol("eta", BACK), "", N_("efficiency of the mesh where the wheel drives"))
    omega1 = Q("omega", "rad/s", N_("angular velocity of the worm"))
    omega2 = Q("omega", "rad/s", N_("angular velocity of the wheel"))
    v1 = Q("v", "m/s", N_("velocity at the pitch circle of the worm"))
    v2 = Q("v", "m/s", N_("velocity at the pitch circle of the wheel"))
    v_slip = Q(Symbol("v", SLIDE), "m/s", N_("velocity of sliding"))
    T1 = Q("T", "N·m", N_("torque on the worm"))
    T2 = Q("T", "N·m", N_("torque on the wheel"))
    F_t2 = Q("F_t", "N", N_("circumferential force on the wheel, equal to the axial one on the worm"))
    F_t1 = Q("F_t", "N", N_("circumferential force on the worm, equal to the axial one on the wheel"))
    alpha = Q("alpha", "deg", N_("profile angle of the basic rack"))
    F_r = Q("F_r", "N", N_("radial force, which parts the worm and the wheel"))
