"""Drawings of a cam: its profile with the follower about it, and the diagram by which it is sized."""
