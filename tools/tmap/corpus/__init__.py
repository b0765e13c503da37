"""Polygons and meshes to try: hard cases by name, random ones, those that people write."""
