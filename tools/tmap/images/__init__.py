"""Pictures: reading them, palettes, mip maps."""
