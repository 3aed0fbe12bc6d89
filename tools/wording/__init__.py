"""The texts of the program: where they stand, and how translations of them are taken in."""
