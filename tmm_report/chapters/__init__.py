"""One room a chapter of the note: its inputs (Given), its results (Found) and its solving (solve)."""
