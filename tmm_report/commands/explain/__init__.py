"""`tmm-report explain`: `target` (which number is meant), `derivation` (its formulas), `way` (how it is found else), `stated`,
`text`; `run`: the command.
"""
