"""The .toml beside each instrument: where it works and how it is held, in metres, in the frame of its .iv file."""

from inventor import number


def description_text(opening, entries):
    """`entries`: (key, value, comment) in order; a value is a string, a number, a point or a list of points."""
    text = "".join(f"# {line}".rstrip() + "\n" for line in opening.strip().split("\n")) + "\n"
    for key, value, remark in entries:
        if remark:
            text += f"# {remark}\n"
        text += f"{key} = {_value(value)}\n"
    return text


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
