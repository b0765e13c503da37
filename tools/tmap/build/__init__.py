"""What the Makefile runs and what reads its products: structures, contract blocks, ELF and hunk
files, written assembly."""
