"""The emulated machine: programs, crashes, system state."""
