"""Assembly routines against their contract blocks."""
