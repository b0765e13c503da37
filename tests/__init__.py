"""Tests, in rooms like those of tools/tmap."""
