"""The scene compiler: TOML, pictures and meshes in, a scene file out."""
