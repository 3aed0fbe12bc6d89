"""The branch of a group above class II: its curve in (q, φ), followed by arc length, its ends and crossings exactly."""
