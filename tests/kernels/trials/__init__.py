"""Input and expected output of the assembly routines, by subject."""
