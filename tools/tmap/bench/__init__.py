"""The bench: what it measures, in which cases."""
