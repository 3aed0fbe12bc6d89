"""A year's works together: whose they are, gradebooks, marks set by hand, copies, statistics."""
