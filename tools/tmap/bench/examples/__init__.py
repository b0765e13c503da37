"""Input of the texture units' passes, for bench and tests."""
