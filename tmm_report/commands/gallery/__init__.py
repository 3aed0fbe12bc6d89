"""`tmm-report gallery`: `page`, an entry for every variant; `run`: the command."""
