"""The books and standards that notes cite, by the names by which templates call them.

Their Russian form is that of GOST R 7.0.5: with its signs, spaces around them, a full stop and a dash between areas;
standards with their full designation.
"""

from __future__ import annotations

from tmm_report.problems import N_

SOURCES = {
    "artobolevsky": N_(
        "Artobolevsky I. I. Theory of Mechanisms and Machines. Moscow: Nauka, 1988. 640 p. (in Russian)."
    ),
    "frolov": N_(
        "Frolov K. V. (ed.), Popov S. A., Musatov A. K. et al. Theory of Mechanisms and Machines. Moscow: "
        "Vysshaya Shkola, 1987. 496 p. (in Russian)."
    ),
    "berkof": N_(
        "Berkof R. S. Complete Force and Moment Balancing of Inline Four-Bar Linkages. Mechanism and Machine Theory 8 "
        "(1973), pp. 397–410."
    ),
    "freudenstein": N_(
        "Freudenstein F. Approximate Synthesis of Four-Bar Linkages. Transactions of the ASME 77 (1955), pp. 853–861."
    ),
    "levitsky": N_(
        "Levitsky N. I. Theory of Mechanisms and Machines. Moscow: Nauka, 1990. 592 p. (in Russian)."
    ),
    "korenyako": N_(
        "Korenyako A. S. (ed.). Course Design in the Theory of Mechanisms and Machines. Kyiv: Vyshcha Shkola, "
        "1970. 332 p. (in Russian)."
    ),
    "rack": N_(
        "GOST 13755–2015 (ISO 53:1998). Basic norms of interchangeability. Cylindrical involute gears. Basic racks "
        "(in Russian)."
    ),
    "external": N_(
        "GOST 16532–70. Cylindrical involute gear pairs of external mesh. Calculation of geometry (in Russian)."
    ),
    "internal": N_(
        "GOST 19274–73. Cylindrical involute gear pairs of internal mesh. Calculation of geometry (in Russian)."
    ),
    "bolotovsky": N_(
        "Bolotovsky I. A. (ed.). Handbook of Geometrical Calculation of Involute and Worm Gears. Moscow: "
        "Mashinostroenie, 1986. 448 p. (in Russian)."
    ),
    "kudryavtsev": N_(
        "Kudryavtsev V. N. Planetary Gears. Moscow, Leningrad: Mashinostroenie, 1966. 307 p. (in Russian)."
    ),
    "dunaev": N_(
        "Dunaev P. F., Lelikov O. P. Design of Units and Machine Parts. Moscow: Academia, 2004. 496 p. (in Russian)."
    ),
    "balancing": N_(
        "ISO 21940-11:2016. Mechanical vibration. Rotor balancing. Part 11: Procedures and tolerances for rotors "
        "with rigid behaviour."
    ),
    "vibration": N_("Den Hartog J. P. Mechanical Vibrations. Moscow: Fizmatgiz, 1960. 580 p. (in Russian)."),
    "wear": N_("Kragelsky I. V. Friction and Wear. Moscow: Mashinostroenie, 1968. 480 p. (in Russian)."),
}
