"""What was probably not meant: letters of another script, numbers that missed their unit, keys out of place."""
