"""The .toml beside each instrument: where it works and how it is held, in metres, in the frame of
its .iv file."""

from inventor import comment, number


def description_text(opening, entries):
    """`entries`: (key, value, comment) in order; a value is a string, a number, a point or a list
    of points."""
    text = comment(opening) + "\n"
    for key, value, remark in entries:
        if remark:
            text += comment(remark)
        text += f"{key} = {_value(value)}\n"
    return text


def instrument_entries(name, kind, sentence, tip):
    """The entries that every instrument has: its name, kind, model and sentence; where its tip is, at
    the origin (`tip` says what lies there), and that its handle points along +Z."""
    return [
        ("name", name, ""),
        ("kind", kind, ""),
        ("model", f"{kind}.iv", ""),
        ("description", sentence, ""),
        ("tip", (0.0, 0.0, 0.0), tip),
        ("axis", (0.0, 0.0, 1.0), "Unit vector from the tip to the handle."),
    ]


def _value(value):
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (int, float)):
        return _float(value)
    if isinstance(value[0], (int, float)):
        return f"[{', '.join(_float(x) for x in value)}]"
    return "[\n" + "".join(f"  {_value(point)},\n" for point in value) + "]"


def _float(x):
    text = number(x, 7)
    return text if "." in text else text + ".0"
