"""What accuracy costs: errors and cycles of all settings, side by side."""
