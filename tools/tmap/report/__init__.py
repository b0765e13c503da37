"""The HTML report and the pages' tables."""
