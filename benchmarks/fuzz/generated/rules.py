"""Which keys go together, by the parts of the schema: what a chapter would refuse otherwise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmm_report.chapters.lever.synthesis.given import KINDS

Keys = Sequence[str]

PAIRS = ("steel–steel", "steel–bronze", "cast iron–steel", "cast iron–bronze", "сталь–чугун")
RUBBING = (
    "Incline",
    "Wedge",
    "Sliders",
    "Screw",
    "Pivot",
    "Belt",
    "BeltDrive",
    "contacts.Wheel",
    "Journal",
    "Crank",
    "PivotFriction",
    "GuideFriction",
    "JointFriction",
    "CamFriction",
)

# exactly one key of each of these sets
ONE: Mapping[str, Sequence[Keys]] = {
    "Synthesis": [KINDS],
    "Material": [("speed", "stress")],
    "Force": [("constant", "by_position", "by_angle", "by_time", "by_displacement")],
    "Piston": [("constant", "by_position", "by_angle", "by_time", "by_displacement")],
    "kinetostatics.Moment": [("constant", "by_position", "by_angle", "by_time", "by_displacement")],
    "LawModel": [("acceleration", "harmonic", "polynomial", "angles", "phases")],
    "MotorModel": [("constant", "shunt", "series", "induction", "by_speed", "by_angle", "by_time")],
    "ResistanceModel": [("friction", "viscous", "fan", "by_speed", "by_angle", "by_time")],
    "SpeedModel": [("by_speed", "stribeck")],
    "TorsionSpring": [("preload", "free_angle")],
    "ChooseBrake": [("mass", "spring")],
    "Engine": [("cylinders", "inline", "vee", "opposed", "radial")],
    "governor.Given": [("arms", "bell_crank")],
    "Plane": [("radius", "mass")],
    "EfficiencyModel": [("series", "parallel"), ("input", "output")],
    "PlanetaryModel": [("fixed", "second")],
    "BevelStage": [("module", "mean_module")],
    "WormStage": [("friction_angle", "coefficient", "efficiency")],
    "DriverModel": [("speed", "period", "law")],
    "Linear": [("force", "unbalance", "base")],
    "Choose": [("spring", "balls", "sleeve")],
    "Turning": [("moment", "base")],
    "Absorber": [("mass", "clear")],
    "TurningAbsorber": [("inertia", "clear")],
    "balancing.Counterweight": [("distance", "mass")],
    **{name: [("coefficient", "materials")] for name in RUBBING},
}

_SHAPES = (
    ("ratio",),
    ("ratio", "offset"),
    ("ratio", "offset_ratio"),
    ("pressure_angle",),
    ("K",),
    ("K", "offset"),
    ("K", "ratio"),
    ("K", "pressure_angle"),
)
# all keys of one of these sets, none of the others
SETS: Mapping[str, Sequence[Keys]] = {
    "SliderCrank": [
        (*demand, *shape) for demand in (("stroke",), ("mean_speed", "speed")) for shape in _SHAPES
    ],
    "CrankRocker": [("crank",), ("rod",), ("frame",), ()],
    **{
        name: [
            (size, *rod)
            for size in ("frame", "crank")
            for rod in (("rod",), ("rod_ratio",), ("pressure_angle",), ("rod_ratio", "pressure_angle"))
        ]
        for name in ("SlottedLink", "TurningGuide")
    },
    "ShuntModel": [
        ("moment", "speed", "no_load"),
        ("power", "speed", "no_load"),
        ("voltage", "resistance", "constant"),
    ],
    "dynamics.SeriesModel": [
        ("moment", "speed", "stall"),
        ("power", "speed", "stall"),
        ("voltage", "resistance", "constant"),
    ],
    "InductionModel": [
        ("synchronous", "max_moment", "critical_slip"),
        ("moment", "synchronous", "speed", "overload"),
        ("power", "synchronous", "speed", "overload"),
    ],
    "dynamics.Start": [("speed",), ("time",), ("angle",), ("within",), ()],
    "PartModel": [
        ("inertia",),
        ("inertia", "moment"),
        ("mass", "radius"),
        ("mass", "radius", "force"),
        ("mass", "offset"),
        ("inertia", "mass", "radius"),
        ("mass", "velocity"),
    ],
    "flywheel.Moment": [("constant",), ("table",), ("mean", "harmonics"), ("harmonics",)],
    "Inertia": [("constant",), ("table",), ("mean", "harmonics")],
    "flywheel.Wheel": [("inertia",), ("mass", "radius_of_gyration")],
    "Flywheel": [
        (*unevenness, *load, *shape)
        for unevenness in (("delta", "speed"), ("speeds",), ("wheel", "speed"))
        for load in (("resisting",), ("driving",), ("driving", "resisting"), ("areas",), ("punch", "motor"))
        for shape in ((), ("disc",), ("rim",), ("radius_of_gyration",))
    ],
    "Heavy": [("mass", "radius"), ("unbalance",)],
    "engine.Counterweight": [("share", "radius"), ("share", "mass"), ("mass", "radius")],
    "BeltStage": [
        ("driving", "driven"),
        ("driving", "ratio"),
        ("driven", "ratio"),
        ("driving", "driven", "ratio"),
    ],
    "FrictionStage": [("driving", "driven"), ("driving", "ratio"), ("driven", "ratio")],
    "BeltDrive": [("driving", "driven"), ("driving", "driven_speed"), ("driven", "driven_speed")],
    "Disc": [("width",), ("diameter",), ()],
    "Rim": [("height", "width"), ("diameter", "width"), ()],
    "Eccentric": [("ratio", "eccentricity"), ("ratio", "eccentricity", "t"), ("teeth",)],
    "MeshLoad": [("meshes", "axes"), ()],
    "Machine": [
        *(("force", *of) for of in (("diameter",), ("teeth", "pitch"))),
        ("torque",),
        ("power",),
        ("power", "diameter"),
        ("diameter",),
    ],
    "Split": [("slow",), ("fast",), ("step",)],
    "Spur": [("teeth",), ("centre_distance",), ("teeth", "centre_distance")],
    "PhaseModel": [
        ("rise", "law"),
        ("rise",),
        ("dwell",),
        ("return", "law"),
        ("rise", "acceleration"),
        ("return", "velocity"),
        ("rise", "displacement"),
    ],
    "PieceModel": [("constant",), ("line",), ("width", "sine")],
    "vibration.Start": [("displacement",), ("velocity",), ("displacement", "velocity")],
    "ProfileModel": [("circle",), ("points",), ("polar",), ("tangent",), ("arcs",)],
    "TangentModel": [("nose", "lift"), ("nose", "half_angle"), ("lift", "half_angle"), ("nose", "distance")],
    "ArcsModel": [
        ("nose", "lift", "flank"),
        ("nose", "lift", "half_angle"),
        ("half_angle", "distance", "flank"),
    ],
    "Radius": [("highest",), ()],
    "ModuleModel": [()],
    "efficiency.SeriesModel": [()],
    "ParallelModel": [()],
    "ZeroModel": [("angle",), ("point", "extreme"), ("link", "extreme")],
}

# where the first is there, the others are not, or are there too
APART: Mapping[str, Sequence[tuple[str, Keys]]] = {
    "Flywheel": [
        ("areas", ("inertia", "turns")),
        ("punch", ("turns", "inertia")),
        ("shaft", ("ratio",)),
        ("rim", ("radius_of_gyration",)),
        ("wheel", ("delta", "speeds", "machine", "methods")),
    ],
    "rotor.Body": [("tilt", ("products",))],
    **{
        name: [(law, ("stroke",)) for law in ("by_position", "by_angle", "by_time", "by_displacement")]
        for name in ("Force", "Piston", "kinetostatics.Moment")
    },
    "Screw": [("arm", ("hand_force",))],
    "contacts.Wheel": [("pull", ("moment",))],
    "Brake": [("choose", ("mass",))],
    "Linear": [
        ("friction", ("damping", "damping_ratio")),
        ("damping", ("damping_ratio",)),
        ("absorber", ("transmissibility",)),
        ("transmissibility", ("damping", "stiffness", "deflection")),
        ("deflection", ("stiffness",)),
    ],
    **{
        name: [("transmission", ("pressure_angle",))]
        for name in ("SliderCrank", "SlottedLink", "TurningGuide")
    },
    "PartModel": [
        ("on", ("ratio", "offset")),
        ("radius_of_gyration", ("inertia", "moment", "velocity", "radius", "moves", "offset")),
    ],
    "Turning": [
        ("friction", ("damping", "damping_ratio")),
        ("damping", ("damping_ratio",)),
        ("absorber", ("transmissibility",)),
        ("transmissibility", ("damping", "stiffness")),
    ],
    "Balls": [("extension", ("distance",))],
    "governor.Given": [("bell_crank", ("brake",)), ("choose", ("servo",))],
    "PlanetaryModel": [("second", ("fixed",)), ("shift", ("coaxiality",))],
}
NEEDS: Mapping[str, Sequence[tuple[str, Keys]]] = {
    "Linear": [("unbalance", ("speed",)), ("base", ("speed",)), ("force", ("speed",))],
    "Turning": [("moment", ("speed",)), ("base", ("speed",))],
    "governor.Given": [
        ("servo", ("machine",)),
        ("arms", ("lift", "radius", "sleeve", "balls")),
        ("bell_crank", ("lift", "radius", "balls", "spring")),
    ],
    "PartModel": [("radius_of_gyration", ("mass",))],
    "Backlash": [("tolerance", ("thinning",))],
    "Press": [("rated", ("torque",))],
    "rotor.Given": [("grade", ("speed", "mass")), ("width", ("diameter",)), ("diameter", ("width",))],
}

RARE: Mapping[str, float] = {
    "PlanetaryModel.teeth": 0.3,
    "Spur.tip_diameters": 0.3,
    "Spur.coaxial": 0.1,
    "DriverModel.range": 0.3,
    "DriverModel.gear": 0.3,
    "DriverModel.turns": 0.4,
    "PlanetaryModel.centre_distance": 0.1,
    "dynamics.Start.motor": 0.2,
    "Linear.mechanism": 1.5,
    "WearModel.guides": 3.0,
    "governor.Given.brake": 0.3,
    "rotor.Body.tilt": 0.5,
    "Synthesis.output": 0.1,
    "CrankRocker.transmission": 0.3,
    "CrankRocker.beyond": 0.5,
    "Brake.choose": 0.2,
    "Brake.arm": 0.4,
    "LoadsModel.torsion_springs": 0.3,
    "DynamicsModel.torsion_springs": 0.2,
    "PartModel.radius_of_gyration": 0.3,
}

NAMED: Mapping[str, Sequence[Any]] = {
    "DriverModel.speed": (*("1200 rpm", "90 rpm", "12 rad/s", 9.4) * 6, "synthesis.speed"),
    "Generator.y": ("x^2", "sqrt x", "log10 x", "exp x", "sin x", "1/x"),
    **{f"{name}.materials": PAIRS for name in RUBBING},
    "Backlash.grade": ("8-B", "7-C", "9-8-8-A", "7-6-6-Ba"),
    "Flywheel.delta": ("1/30", 0.05, "1/80", 0.1, "4 %"),
    "Eccentric.ratio": (3, 4, "5/2", 2.5, "7/2"),
    "Heavy.unbalance": ("12 g*mm", "0.02 kg*m", "300 g*mm"),
    "Force.direction": (
        "right",
        "left",
        "up",
        "down",
        "30 deg",
        "along motion",
        "against motion",
        "-120 deg",
    ),
    "Piston.direction": ("right", "left", "up", "down", "against motion"),
    "GravityModel.direction": ("down", "up", "right", "-60 deg"),
    "Linear.mechanism": ("right", "up", "30 deg"),
    "RollerModel.at": ("B",),
    "FlatModel.at": ("B",),
    "CamModel.cam": ("1",),
    "CamModel.centre": ("K", "W"),
    "Variant.decimal_sign": ("comma", "point"),
    "Note.body": ("kinematics.contours", "plans"),
    "Note.appendix": ("kinematics", "balancing.left"),
    "Note.omit": ("structure.driving_links", "flywheel"),
    "Variant.words": ("slider", "crank", "follower"),
    "NoteProfileModel.language": ("ru", "en"),
    "NoteProfileModel.words": ("ru", "kk", "en"),
}

SIZED: Mapping[str, tuple[int, int]] = {
    **dict.fromkeys(("Note.body", "Note.appendix", "Note.omit"), (1, 1)),
    "DynamicsModel.parts": (1, 3),
    "DynamicsModel.resistance": (1, 2),
    "DynamicsModel.springs": (1, 2),
    "Variant.contacts": (1, 4),
    "rotor.Given.masses": (1, 4),
    "rotor.Given.planes": (1, 2),
    "Engine.cylinders": (1, 6),
    "Inline.cranks": (1, 6),
    "Vee.cranks": (1, 4),
    "Opposed.cranks": (1, 6),
    "DriveModel.stages": (1, 3),
    "Areas.values": (2, 6),
    "Balancing.methods": (1, 4),
    "Flywheel.methods": (1, 3),
}
