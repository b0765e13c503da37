"""Settings by the clock: the most exact ones of a scene that hold a frame rate on the screen."""
