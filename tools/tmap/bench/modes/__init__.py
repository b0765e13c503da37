"""The modes of both texture units that are priced."""
