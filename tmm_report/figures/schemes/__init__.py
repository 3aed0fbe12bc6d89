"""Schemes of a mechanism: one position, all of them, its groups taken apart, a detail drawn larger."""
