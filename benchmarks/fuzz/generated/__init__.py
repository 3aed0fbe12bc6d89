"""Variants generated from the schema of the format: every block and key there or not, every enum value, kinds mixed.

`schema` walks the schema beside data and says which keys, alternatives and enum values it has; `walk` draws data from
it; `rules` says which keys go together, `numbers` what size they have, `levers` draws mechanisms that close, `whole`
puts blocks together. What a rule forgets is drawn all the same: a new key of the schema needs no line here.
"""
