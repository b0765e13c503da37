"""Meshes before scaling: OBJ files, lists of points and faces, billboards; faces cut into convex ones."""
