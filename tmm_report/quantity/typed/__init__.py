"""Letters and numbers as people type them: what looks alike, and slips of the pen."""
