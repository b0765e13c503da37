"""The bench: the calls that it measures, the baseline they are compared with."""
