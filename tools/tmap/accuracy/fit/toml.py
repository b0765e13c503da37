"""Lines for a scene's file: values as TOML writes them."""

import json
import re


def key(name: str) -> str:
    """Returns a key, in quotes if it needs them."""
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)


def value(found) -> str:
    """Returns a value in one line."""
    if isinstance(found, dict):
        return "{ " + ", ".join(f"{key(name)} = {value(each)}" for name, each in found.items()) + " }"
    if isinstance(found, list):
        return "[" + ", ".join(map(value, found)) + "]"
    if isinstance(found, bool):
        return "true" if found else "false"
    return json.dumps(found, ensure_ascii=False) if isinstance(found, str) else str(found)


def lines(pixel: str | None, materials: dict[str, dict]) -> str:
    """Returns the lines that set a size of pixels and materials."""
    made = [f'pixel = {value(pixel)}'] if pixel else []
    if materials:
        made += [""] * bool(made) + ["[materials]"]
        made += [f"{key(name)} = {value(each)}" for name, each in materials.items()]
    return "\n".join(made)
