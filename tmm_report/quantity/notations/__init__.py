"""Formulas in the formats that few notes have: a room each, which is read when its format is asked for."""
