"""Sentences on what is balanced in an engine and what balances the rest."""

from __future__ import annotations

from tmm_report.problems import N_

BALANCED = {
    ("force", 1): N_("Forces of order 1 balance each other."),
    ("force", 2): N_("Forces of order 2 balance each other."),
    ("couple", 1): N_("Moments of order 1 balance each other."),
    ("couple", 2): N_("Moments of order 2 balance each other."),
}

REMEDIES = {
    ("force", 1, "none"): N_("Nothing is left of the forces of order 1."),
    ("force", 1, "forward"): N_(
        "The force of order 1 turns with the crankshaft as one vector: counterweights on the crankshaft with this "
        "product balance it."
    ),
    ("force", 1, "backward"): N_(
        "The force of order 1 turns against the crankshaft: a shaft that turns against it at its speed balances the "
        "force by a weight with this product."
    ),
    ("force", 1, "pair"): N_(
        "The force of order 1 swings along a line: two shafts that turn in opposite senses at the speed of the "
        "crankshaft (Lanchester) balance it, each by a weight with this product."
    ),
    ("force", 1, "unequal"): N_(
        "The end of the force of order 1 runs round an ellipse: a weight that turns with the crankshaft and one that "
        "turns against it at its speed balance it, with these products."
    ),
    ("force", 2, "none"): N_("Nothing is left of the forces of order 2."),
    ("force", 2, "forward"): N_(
        "The force of order 2 turns as one vector at twice the speed in the sense of the crankshaft: a shaft that "
        "turns so balances it by a weight with this product."
    ),
    ("force", 2, "backward"): N_(
        "The force of order 2 turns as one vector at twice the speed against the crankshaft: a shaft that turns so "
        "balances it by a weight with this product."
    ),
    ("force", 2, "pair"): N_(
        "The force of order 2 swings along a line: two shafts that turn in opposite senses at twice the speed of the "
        "crankshaft (Lanchester) balance it, each by a weight with this product."
    ),
    ("force", 2, "unequal"): N_(
        "The end of the force of order 2 runs round an ellipse: two shafts at twice the speed, one in the sense of the "
        "crankshaft and one against it, balance it by weights with these products."
    ),
    ("couple", 1, "none"): N_("Nothing is left of the moments of order 1."),
    ("couple", 1, "forward"): N_(
        "The moment of order 1 turns with the crankshaft: two opposite weights at the ends of the crankshaft balance "
        "it, with this product of mass, radius and distance from each other."
    ),
    ("couple", 1, "backward"): N_(
        "The moment of order 1 turns against the crankshaft: a shaft that turns against it at its speed with two "
        "opposite weights balances it, with this product of mass, radius and distance from each other."
    ),
    ("couple", 1, "pair"): N_(
        "The moment of order 1 swings in a plane: two shafts that turn in opposite senses at the speed of the "
        "crankshaft balance it, each by two opposite weights with this product of mass, radius and distance."
    ),
    ("couple", 1, "unequal"): N_(
        "The moment of order 1 runs round an ellipse: opposite weights that turn with the crankshaft and others that "
        "turn against it at its speed balance it, with these products of mass, radius and distance."
    ),
    ("couple", 2, "none"): N_("Nothing is left of the moments of order 2."),
    ("couple", 2, "forward"): N_(
        "The moment of order 2 turns at twice the speed in the sense of the crankshaft: a shaft that turns so with two "
        "opposite weights balances it, with this product of mass, radius and distance."
    ),
    ("couple", 2, "backward"): N_(
        "The moment of order 2 turns at twice the speed against the crankshaft: a shaft that turns so with two "
        "opposite weights balances it, with this product of mass, radius and distance."
    ),
    ("couple", 2, "pair"): N_(
        "The moment of order 2 swings in a plane: two shafts that turn in opposite senses at twice the speed of the "
        "crankshaft balance it, each by two opposite weights with this product of mass, radius and distance."
    ),
    ("couple", 2, "unequal"): N_(
        "The moment of order 2 runs round an ellipse: two shafts at twice the speed, one with the crankshaft "
        "and one against it, balance it by opposite weights with these products of mass, radius and distance."
    ),
}
