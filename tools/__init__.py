"""tmap020's host side: scene compiler, references, emulator runner, reports."""
