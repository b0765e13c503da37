"""The Makefile's tools and readers of its products: structures, contract blocks, ELF and hunk
files, generated assembly."""
