"""`tmm-report check`: sample variants solved anew and held against their stored results.

`stored`: the file beside a variant; `numbers`: what is compared of the results, and how; `structure`: the note as
lines; `junit`: the outcome for CI services; `run`: the command.
"""
