"""`tmm-report methods`: `measured` (rivals run and timed), `page` and `data` (what is said of them); `run`: the
command.
"""
