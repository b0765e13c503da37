"""The integer model of a polygon, bit for bit the 68020's: edges, gradient set-up, spans,
perspective."""
