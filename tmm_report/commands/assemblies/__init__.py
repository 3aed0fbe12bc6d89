"""`tmm-report assemblies`: `ways` (all of them), their `page`; `run`: the command."""
