"""`tmm-report batch`: many variants over processes or a cluster, each in a folder of its own, and what came of them.

`inputs` makes tasks of files, archives and tables; `work` does them, wherever that is; `record` is what is kept of each
in the journal; `run` holds them together; `progress`, `summary` and `page` tell of them.
"""
