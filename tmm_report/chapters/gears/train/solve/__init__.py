"""A compound gear train solved: what it is built of, its conditions, the teeth that are sought, powers."""
