"""Drawings in millimetres of paper (SVG, TikZ) and graphs with axes (matplotlib, imported only by `graphs`)."""
