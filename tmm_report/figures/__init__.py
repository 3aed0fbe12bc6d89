"""Drawings and graphs in millimetres of paper, written as SVG, as TikZ and as PNG."""
