"""Writes a TOML document from dictionaries, lists, texts, numbers and booleans, as tomllib reads them."""

import json
import math


def value_text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        if math.isfinite(value):
            text = repr(value)
            return text if any(c in text for c in ".en") else text + ".0"
        return "nan" if math.isnan(value) else ("inf" if value > 0 else "-inf")
    if isinstance(value, int):
        return str(value)
    if isinstance(value, str):
        # A JSON text is a TOML text, but for the character DEL.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return "[" + ", ".join(map(value_text, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {value_text(v)}" for k, v in value.items()) + "}"
    raise TypeError(f"{value!r} has no form in TOML")


def toml_text(document):
    """Tables inside are written in one line each, since the order of what stands below is then of no matter."""
    return "".join(f"{json.dumps(key)} = {value_text(value)}\n" for key, value in document.items())
