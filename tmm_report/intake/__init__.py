"""Files from outside and what is written for spreadsheets: opened under limits, read as data, never obeyed."""
