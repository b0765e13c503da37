"""Model, ideal, bounds, hard cases, fuzzer, bench."""
