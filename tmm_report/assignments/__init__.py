"""Variants of a class: drawn from ranges by a seed and proven, or filled in from a table, a row a student."""
