"""Meshes, cameras, light."""
