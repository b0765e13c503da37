"""Mip maps."""
