"""Kit, disk, report and pages."""
