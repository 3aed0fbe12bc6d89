"""`tmm-report verify`: the ready variants solved on this machine and held against references of 40 digits."""
