"""Trees of planes that say in which order faces are drawn, and the faces that they split."""
