"""The fuzzer: random polygons under all settings, held to model and bounds."""
