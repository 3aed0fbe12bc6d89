"""How the numbers of a compound gear train are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import PI
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

WILLIS = N_("From Willis' equations of all meshes, solved together with the stated speeds.")
ROW = N_("The product of the ratios of the meshes along the row, minus for every external one.")
EQUILIBRIUM = N_(
    "From the equilibrium of every member: in each mesh the driven wheel receives the efficiency's part of the power "
    "in the motion about the carrier."
)
LOSSES = N_("Of each mesh what its power in the motion about the carrier loses; summed.")
ETA = N_("The useful power by the supplied, with the losses of the meshes.")
BACK = N_(
    "The same equilibrium with the power going in at the output, every mesh with its own direction of it."
)
SHARES = N_("Of a shaft of several members what the meshes give to each, by the power of the shaft outside.")
MESH = N_(
    "Stated for meshes of the kind or for this one; of a differential with a locking factor K by its root."
)
DISTANCE = N_(
    "Half the module times the sum of the teeth, of an internal mesh their difference; without shift."
)
ASSEMBLY = N_(
    "Teeth of the driven and driving wheels along the row, by the planet gears and what a pitch is worth."
)
NEIGHBOURS = N_(
    "The chord between the axes of neighbouring planet gears less the tip diameter of their largest crown."
)
SEARCH = N_(
    "Every set in the ranges is looked at; coaxiality fixes some wheels, the conditions judge the rest."
)
TEETH = N_("Stated, or of the set of teeth that is taken.")
NUMBERS = N_("Stated, or one of the numbers from 2 to 6, which are all looked at.")
TEETH_FORCE = N_(
    "Twice the torque on the first wheel by its module and teeth, and by the planet gears that share it."
)
SCALE = N_("Chosen so that the drawing fits the paper, from the usual scales.")
FREEDOM = N_("The members that turn on their own less the independent equations of the meshes.")
BACK_LOOP = N_("What the branches at a shaft bring back against the others.")

WAYS = (
    Way(
        "train_*.member train_*.row train_*.carrier train_*.mesh train_*.other train_*.driving train_*.shaft "
        "train_*.satellite train_*.reason train_speeds.with",
        NAME,
    ),
    Way("train_cases.case train_solutions.place", COUNTED),
    Way("train_rows.u train_rows.u_loss", ROW, of="row carrier"),
    Way("train_ratios.u", WILLIS, of="member"),
    Way("train_speeds.z", TEETH, of="member"),
    Way("train_assembly.k", NUMBERS, of="row"),
    Way("train_neighbours.k", NUMBERS, of="satellite"),
    Way("train_speeds.n", by=lambda q: 30 * q("omega") / PI),
    Way("train_speeds.n_rel", by=lambda q: 30 * q("omega_rel") / PI),
    Way("train_speeds.*", WILLIS, of="member z"),
    Way("train_cases.n", by=lambda q: 30 * q("omega") / PI),
    Way("train_cases.*", WILLIS, of="case member"),
    Way("train_loads.F", by=lambda q: abs(q("T")) / (q("train_D_wheel") / 2)),
    Way("train_loads.F_free", by=lambda q: abs(q("T_free")) / (q("train_D_wheel") / 2)),
    Way("train_loads.* train_flow.*", EQUILIBRIUM, of="member"),
    Way("train_meshes.eta", MESH, of="mesh"),
    Way("train_meshes.F_t", TEETH_FORCE, of="mesh train_freedom"),
    Way("train_meshes.*", EQUILIBRIUM, of="mesh eta"),
    Way("train_branches.*", SHARES, of="shaft member"),
    Way("train_distances.*", DISTANCE, of="mesh other"),
    Way("train_assembly.C", ASSEMBLY, of="row k"),
    Way("train_neighbours.gap", NEIGHBOURS, of="satellite k"),
    Way("train_rejected.* train_solutions.* train_combinations train_solutions", SEARCH, of="train_u_wanted"),
    Way("train_u train_u_loss", WILLIS, of="train_freedom"),
    Way("train_eta", ETA, of="train_P_lost"),
    Way("train_eta_back", BACK, of="train_eta"),
    Way("train_T_in train_T_out train_P_in train_P_out train_P_supplied", EQUILIBRIUM, of="train_freedom"),
    Way("train_P_taken", by=lambda q: q("train_P_supplied") - q("train_P_lost")),
    Way("train_P_lost train_P_differential", LOSSES, of="train_freedom"),
    Way("train_P_circulating", BACK_LOOP, of="train_P_lost"),
    Way("train_freedom", FREEDOM, enough=True),
    Way("train_mu_l train_mu_v train_mu_omega", SCALE, of="train_freedom train_h"),
    Way("train_*", STATED),
)
