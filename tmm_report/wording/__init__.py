"""A department's own words for the course's terms, in place of those of the note's texts."""
