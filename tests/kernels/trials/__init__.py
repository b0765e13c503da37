"""Input and expected output of the assembly routines, by subject. ``trials`` of each module makes
all of them, the same in every run."""
