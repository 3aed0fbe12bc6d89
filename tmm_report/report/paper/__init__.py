"""What fits on paper: widths by the metrics of the faces, where formulas and tables break, sheets of paper."""
