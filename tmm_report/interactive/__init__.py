"""Results at a Python prompt and in a notebook: `solved`, what `tmm_report.solve` returns; `sweeps`, many variants.

numbers   arrays with unit, symbol and meaning        source    a variant from a path, a text or a dict
figures   pictures of the note, shown by themselves   brief     a few lines on a result
"""
