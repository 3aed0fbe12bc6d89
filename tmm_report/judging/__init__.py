"""A person's own numbers against the solution: compared, and their mistakes named. Numbers alone, no page, no file."""
