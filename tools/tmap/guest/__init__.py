"""The emulated Amiga: runs programs, calls routines, compares frames, keeps measurements."""
