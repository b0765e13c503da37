"""The integer model of the N64's texture engine, and the formats of its textures."""
