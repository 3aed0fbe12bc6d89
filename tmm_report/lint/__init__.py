"""The norm control of a note: what was made is read and held against what an inspector of norms looks for.

`made`: the files of a note; `page`, `source`: what its HTML and its LaTeX say; then a room for each kind of check, and
`checks`, the list of them.
"""
