"""The integer model of the renderer: a scene file in, frames out."""
