"""Words and symbols that several chapters use: directions, gears, wheels."""
