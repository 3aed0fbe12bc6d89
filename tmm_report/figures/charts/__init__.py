"""Curves over axes: over one axis in panels (`graphs`, `axes`, `sheet`, `peaks`), in a plane (`plane`), with axes that
are logarithmic (`logs`).
"""
