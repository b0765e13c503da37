"""The N64's texture engine."""
