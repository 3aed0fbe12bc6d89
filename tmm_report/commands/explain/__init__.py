"""`tmm-report explain`: `target` (which number is meant), `listen` (what the note says), `derivation` (its formulas),
`way` (how it is found where the note has none), `stated` (where it is given), `text`; `run`: the command.
"""
