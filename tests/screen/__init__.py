"""Chunky to planar, display, demo, windows."""
