"""The N64 texture engine: its model, its command words, and pictures in its formats."""
