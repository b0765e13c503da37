"""Commands that draw: run, show, demo, diff, convert."""
