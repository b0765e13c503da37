"""Reference data of both texture units: reads it and compares the 68020's answers with it."""
