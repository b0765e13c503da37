"""The integer model of Glide's texture unit, and the formats of its textures."""
