"""The binary scene file that the Amiga loads: its tables, written and checked."""
