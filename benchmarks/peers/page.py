"""The page of the documentation: what was compared, how, and what came out."""

from __future__ import annotations

from collections.abc import Mapping

from benchmarks.measuring import stored

TEXT = """# Other programs, side by side

What this program finds, and how fast, beside other programs that find the same. Errors are against 40 digits of mpmath,
relative to the largest value of the quantity. Times are ratios to ours, of CPU time in the same run, the programs
taking turns; seconds would say more of the machine. The whole page, its chart and `benchmarks/results/peers.json` are
made by

    python -m venv peers && peers/bin/pip install -e . -r benchmarks/peers/requirements.txt
    peers/bin/python -m benchmarks.peers -o docs --store --gears GEARS

where GEARS is the interpreter of another environment with py_gearworks, whose dependencies are many. What is not
installed is left out.

The figures are of one run on one machine: {machine}.

Versions: {versions}.

## The compressor, 36 positions with all masses and gas forces

{levers}

"not offered": the program does not find it. The time is that of the whole table with the model built before: against
our "motion and forces" where a moment is found, against our "motion" where it is not.

![Errors against times](charts/peers.svg)

How each was used:

{uses}

What can be read from it:

- Those that solve every position for itself to rounding and its rates by linear equations (ours, pylinkage, pinocchio)
  are at rounding in everything they offer. pylinkage's loop compiled by numba takes little longer than our arrays
  for the motion alone; its loop in Python, and pinocchio's calls from Python, take tens of times longer.
- kinepy solves positions by arrays as well, but takes rates from differences of samples: ten times the samples, a
  hundredth of the error.
- mechanism solves each position and each rate by `fsolve` at its default tolerance, hundreds of times longer than a
  closed form.
- exudyn and mujoco integrate motion in time, which is not what a table of positions needs: they are made for motion
  that follows from forces. Their errors fall with the step; mujoco's loops are soft by intent, which its accelerations
  and moments show. Steps are named in the table.

## Cold start

A fresh process that imports the program, builds the compressor and solves it once:

{cold}

pylinkage's first call compiles by numba; without numba it was asked for "step_with_derivatives".

## Gears

A spur pair by the standard rack, module 2 mm, no backlash: 25 and 40 teeth without shifts, 22 and 41 with shifts 0.3
and 0.2. "profile": distance of {points} points of a flank from the exact involute, over the module; "thickness" at the
reference circle; "distance" of the axes; "contact ratio" with tips that are not shortened.

{gears}

{gear_uses}
"""

USES = {
    "ours": "`mechanics.motion.solve`, every point asked for; `mechanics.statics.solve`, all reactions "
    "with the moment.",
    "pylinkage": "components, `Linkage`, `set_input_velocity`; `step_fast_with_kinematics` compiled by numba, "
    "`step_with_derivatives` from Python (its inner functions compiled).",
    "kinepy": "`System` in SI, `pilot`, `solve_dynamics`; one sample more on either side, which differences leave "
    "without a value.",
    "mechanism": "two loops of vectors, `Mechanism.iterate`; a new object for every run, for it keeps its state.",
    "pinocchio": "a tree of joints, `PointAnchorConstraintModel` for each loop, Newton with its `jacobian`, as in its "
    "four-bar example; moment by `rnea` less the constraints' forces.",
    "exudyn": "`ObjectRigidBody2D`, `ObjectJointRevolute2D`, the crank's angle a symbolic function of time in "
    "`ObjectConnectorCoordinate`, whose multiplier is the moment; generalized-alpha (index 3) and the trapezoidal rule "
    "(index 2) of its example; the build without checks of ranges.",
    "mujoco": "hinges and slides, `connect` between sites with solref at two steps and solimp at 0.9999; the crank "
    "kept at its speed by a great `armature`; the semi-implicit Euler rule and RK4.",
}

GEAR_USES = {
    "mechanism": "`SpurGear`; it has no shifts and no pairs, and says nothing of the flank below the base circle.",
    "py_gearworks": "`SpurGear`, `mesh_to`, `get_contact_ratio`; it finds the contact ratio by minimising distances.",
    "FreeCAD": "`fcgear.involute.CreateExternalGear` of PartDesign, two Bézier curves of third degree a flank, all "
    "teeth; no shifts.",
}

ABSENT = {
    "freecad.gears": "its `pygears` stands in no package registry (that of PyPI is another project): not compared; "
    "FreeCAD's own gear stands here instead."
}


def text(tables: Mapping[str, str], versions: Mapping[str, str], points: int) -> str:
    """The page; programs that were not there are not described."""
    uses = "\n".join(f"- **{key}**: {words}" for key, words in USES.items() if key in versions)
    gear_uses = "\n".join(f"- **{key}**: {words}" for key, words in (GEAR_USES | ABSENT).items())
    said = ", ".join(f"{key} {version}" for key, version in versions.items() if key != "ours")
    where = stored.machine()
    machine = f"{where['processor']}, Python {where['python']}, numpy {where['numpy']}, {where['system']}"
    return TEXT.format(
        machine=machine, versions=said, uses=uses, gear_uses=gear_uses, points=points, **tables
    )
