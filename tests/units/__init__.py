"""What both texture units share."""
