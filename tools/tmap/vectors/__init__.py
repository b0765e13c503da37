"""Reference data of both texture units: reads them and asks the 68020."""
