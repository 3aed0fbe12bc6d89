"""The parts of a file for word processors: `tree` finishes the text that the macros write, `package` packs all."""
