"""Students' own numbers against the solution: read, judged, their mistakes named, marks; no page and no file."""
