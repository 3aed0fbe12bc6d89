"""The same quantity by every method a user might choose, each with one signature."""
