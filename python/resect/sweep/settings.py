"""Changes settings of a scenario, each named by a path such as "tissue.young" or "tool.baton.shift_y"."""

import copy

import resect

AXES = {"shift_x": 0, "shift_y": 1, "shift_z": 2}


def _element(found, part, where, key):
    """The entry of a list of tables: by number, or an instrument by its model, an organ by its name."""
    if part.isdigit() and int(part) < len(found):
        return found[int(part)]
    for one in found:
        if isinstance(one, dict) and part in (one.get("model"), one.get("name")):
            return one
    raise resect.Error(f"{where}: {key} names \"{part}\", and there are {len(found)} entries; give a number from 0, "
                       "or the model of an instrument")


def _move_path(tool, name, value, where, key):
    """A shift of an instrument's whole path, m; or its speed, a factor."""
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        raise resect.Error(f"{where}: {key} must be a number")
    keys = tool.get("keys", [])
    if name == "speed" and value <= 0:
        raise resect.Error(f"{where}: {key} must be above 0")
    on_organ = tool.get("frame") == "organ"
    for k in keys:
        if on_organ and name == "speed":
            for part, factor in (("speed", value), ("wait", 1 / value)):
                if part in k:
                    k[part] *= factor
        elif on_organ:
            if {"over", "position", "at"} & k.keys():  # a key without a place stays where the one before is
                k["offset"] = list(map(float, k.get("offset", (0, 0, 0))))
                k["offset"][AXES[name]] += value
        elif name == "speed":
            k["time"] = keys[0]["time"] + (k["time"] - keys[0]["time"]) / value if k is not keys[0] else k["time"]
        else:
            k["position"] = list(map(float, k["position"]))
            k["position"][AXES[name]] += value


def changed(scenario, settings, where):
    """A copy of the scenario with these settings. A setting that is a table again is a path's beginning."""
    scenario = copy.deepcopy(scenario)
    for key, value in settings.items():
        if isinstance(value, dict):  # [fixed.tissue] young = ... in TOML
            scenario = changed(scenario, {f"{key}.{k}": v for k, v in value.items()}, where)
            continue
        *parts, last = key.split(".")
        at = scenario
        for part in parts:
            if isinstance(at, dict) and part not in at:
                at[part] = {}
            at = at[part] if isinstance(at, dict) else _element(at, part, where, key)
            if not isinstance(at, (dict, list)):
                raise resect.Error(f"{where}: {key} goes through \"{part}\", which holds a value")
        if isinstance(at, list):
            if not last.isdigit() or int(last) >= len(at):
                raise resect.Error(f"{where}: {key} ends in \"{last}\"; give a number from 0 to {len(at) - 1}")
            at[int(last)] = value
        elif parts and parts[0] == "tool" and len(parts) == 2 and (last in AXES or last == "speed"):
            _move_path(at, last, value, where, key)
        else:
            at[last] = value
            other = {"duration": "after", "after": "duration"}.get(last)  # each says when the scenario ends
            if at is scenario and other:
                at.pop(other, None)
    return scenario
