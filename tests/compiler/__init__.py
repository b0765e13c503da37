"""Scene compiler and scene file."""
