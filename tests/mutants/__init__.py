"""Mutants: small changes of meaning in assembly, C and the model, of which each must be noticed."""
