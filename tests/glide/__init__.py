"""Glide's texture unit."""
