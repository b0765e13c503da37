"""The integer model of a polygon: edges, gradient set-up, spans, perspective. Bit for bit what the
68020 does."""
