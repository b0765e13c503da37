"""The exact rational ideal, and the derived bounds of how far the renderer may be from it."""
