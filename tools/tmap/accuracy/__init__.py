"""Errors and cycles of all settings, side by side."""
