"""Polygons: coverage, texels, perspective, lowering."""
