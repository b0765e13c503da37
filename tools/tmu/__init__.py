"""The Glide texture unit."""
