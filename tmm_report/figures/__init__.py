"""Drawings in millimetres of paper (SVG, TikZ) and graphs with axes (matplotlib, only in `sheet`)."""
