"""The Glide texture unit: its model, mip maps for it, and what it is meant to draw."""
