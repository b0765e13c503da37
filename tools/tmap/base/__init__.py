"""Shared by all rooms: errors, paths, 16.16 numbers, sums that are the same on every processor,
text tables."""
