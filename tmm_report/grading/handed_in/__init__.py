"""What students hand in: the sheet they fill in, their files, which attempt counts."""
