"""What textbooks have and the program lacks, by its names in both languages: each with the nearest thing that there is.

A name is looked for among the words of a key that is unknown, or of a `kind` that there is not.
"""

from __future__ import annotations

import re

from tmm_report.problems import N_, Message

_NEAREST = {
    "worm, worms, worm_gear, червяк, червячный": N_("a worm is a stage of the block drive, kind: worm"),
    "hypoid, spiroid, гипоидная, гипоидный, спироидная": N_(
        "hypoid and spiroid gears are not offered: the nearest stages of the block drive are kind: bevel and kind: worm"
    ),
    "bevel, conical, mitre, bevels, bevel_gear, конический": N_(
        "bevel gears are a stage of the block drive, kind: bevel"
    ),
    "belt, belts, v_belt, timing, клиноременная": N_(
        "a belt drive is a stage of the block drive, kind: belt; its friction alone is in contacts, kind: belt drive"
    ),
    "chain, chains, roller_chain, sprocket, sprockets, звёздочка, звездочка": N_(
        "a chain is a stage of the block drive, kind: chain"
    ),
    "idler, idlers, parasitic, паразитное, паразитные": N_(
        "wheels between two others are the idlers of a stage of the block drive, kind: train"
    ),
    "harmonic_drive, harmonic, wave, strain_wave, cycloidal, cyclo, волновая, волновой, циклоидальная": N_(
        "wave and cycloidal gears are not offered: the nearest are kind: planetary and the block eccentric"
    ),
    "rack, rack_and_pinion, реечная, рейка": N_("a rack moves a link of the mechanism: mechanism.racks"),
    "differential, дифференциал, дифференциальная, epicyclic, эпициклическая": N_(
        "it is a stage of kind: planetary; one with bevel gears, closed, or with two outputs is the block train"
    ),
    "3k, 3к, compound, closed_differential, замкнутый, car_axle, final_drive": N_(
        "gear trains of any scheme are the block train"
    ),
    "radius_of_gyration, gyration, gd2, радиус_инерции, маховой_момент": N_(
        "a moment of inertia may be written by mass and radius of gyration: inertia: 60 kg * (200 mm)^2"
    ),
    "gyroscope, gyroscopic, precession, гироскоп, гироскопический": N_(
        "gyroscopic moments are not offered: shafts of dynamics and rotor keep their direction"
    ),
    "torsional, two_rotor, three_rotor, holzer, крутильные": N_(
        "torsional vibration of one disc on a shaft is in vibration, by its inertia; a row of discs is not offered"
    ),
    "variator, cvt, вариатор, лобовая": N_(
        "a variator is not offered: at one of its ratios it is a stage of the block drive, kind: friction"
    ),
    "friction_drive, friction_gear, friction_wheels": N_(
        "friction wheels are a stage of the block drive, kind: friction"
    ),
    "geneva, maltese, maltese_cross, indexing, мальтийский, мальтийская, крест": N_(
        "Geneva wheels are not offered: a cam (cam, or cams) has dwells, and a linkage by synthesis: {dwell: {…}}"
    ),
    "ratchet, pawl, храповой, храповик, храповая, собачка": N_(
        "ratchets are not offered: the rocker that drives one is analysed by itself"
    ),
    "clutch, coupling, муфта, сцепление, фрикцион": N_(
        "clutches and couplings are not offered: the moment of friction of a disc is that of contacts, kind: pivot; a "
        "motor is switched by motor: on and off of a regime of dynamics"
    ),
    "band_brake, band, ленточный": N_("a band about a drum is in contacts, kind: belt"),
    "brake, disc_brake, drum_brake, shoe, тормоз, колодочный, дисковый": N_(
        "the shapes of brakes are not offered: a braking moment is stated, coast: {brake: 90 N*m} of dynamics; a band "
        "about a drum is in contacts, kind: belt"
    ),
    "cardan, hooke, universal_joint, universal, cv_joint, кардан, карданная, карданный, гука": N_(
        "universal joints are not offered: an uneven turning is stated as the law of the driving link, law: {speed: "
        "10 rad/s, harmonic: {amplitude: 2 deg}}"
    ),
    "spatial, spherical, three_dimensional, 3d, robot, manipulator, пространственный, сферический, манипулятор": N_(
        "spatial linkages are not offered: all links move in one plane"
    ),
    "screw_jack, jack, lead_screw, screw, домкрат, винтовая, винтовой": N_(
        "screws are in contacts, kind: screw"
    ),
    "cone, conical_pivot, collar, thrust, коническая_пята, упорный": N_(
        "kind: pivot, with its radii, is the nearest"
    ),
    "linear, linear_motor, stepper, stepping, servomotor, diesel, petrol, turbine, compound, шаговый, дизель, "
    "турбина, компаундный": N_(
        "such a motor is not offered by itself: state its moment by_speed, by_angle or by_time"
    ),
    "synchronous_motor, синхронный": N_(
        "a synchronous motor keeps its speed: state it as the speed of the driving link; induction is the nearest"
    ),
    "asynchronous, асинхронный": N_("it is called induction"),
    "hartnell, гартнель, гартнеля, hartung, pickering": N_(
        "governors with a spring or bell cranks are bell_crank, others of this kind are not offered"
    ),
    "watt, porter, proell, уатт, уатта, портер, портера, прелль, прелля": N_(
        "governors of arms, with a load or without one, are arms (of Proell's the balls have an extension)"
    ),
    "shaft_governor, flat_governor, inertia_governor, electronic, плоский": N_(
        "flat and electronic governors are not offered: arms and bell_crank are"
    ),
    "six_bar, sixbar, six_link, шестизвенник, watt_linkage, stephenson": N_(
        "six links are found as slotted_link, turning_guide and dwell only: others are analysed as a mechanism"
    ),
    "scotch_yoke, yoke, sine_mechanism, синусный, кулисный_камень": N_(
        "its crank is half the stroke, nothing is to be found: state the mechanism"
    ),
    "motor, двигатель": N_("the motor stands in dynamics: {motor: {…}}, what it is to overcome beside it"),
    "cam, cams, кулачок, кулачковый": N_(
        "a cam is found where it is stated: the block cam, or mechanism.cams"
    ),
    "path, trajectory, coupler_curve, straight_line, траектория, прямило": N_(
        "linkages along a path are not offered: an arc of a coupler point (dwell) and positions of a body are"
    ),
    "knife, knife_edge, pointed, остриё, игольчатый": N_("a knife edge is a roller with radius: 0"),
    "mushroom, flat_face, тарельчатый, плоский_толкатель": N_("a flat follower is stated by flat: {at: B}"),
    "groove, grooved, desmodromic, паз, пазовый": N_(
        "the roller of mechanism.cams runs outside; a groove is stated of a cam alone: cam: {closure: groove}"
    ),
    "solenoid, electromagnet, pneumatic, pneumocylinder, hydraulic, пневмоцилиндр, гидроцилиндр, электромагнит": N_(
        "a cylinder of any kind is stated by its stroke: cylinder: [A, B], stroke: {…}; what moves it is not modelled"
    ),
}
_WORDS = {word: text for words, text in _NEAREST.items() for word in words.split(", ")}


def nearest(name: str) -> Message | None:
    """What is offered in place of a thing that is known by name alone: by the whole name, else by its first word that
    is in the list."""
    plain = re.sub(r"[\W_]+", "_", name.casefold()).strip("_")
    for word in (plain, *plain.split("_")):
        for one in (word, word.removesuffix("s"), word.removesuffix("es")):
            if one in _WORDS:
                return Message(_WORDS[one])
    return None


def known(name: str) -> bool:
    """Whether the whole name is in the list, as it is written."""
    return name.casefold() in _WORDS
