"""Cases: folders, files, or dicts."""
import json
import math
import os

from . import _cosurge


def toml_value(value):
    """A Python value as TOML. Raises TypeError for values that TOML cannot represent."""
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value))
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(toml_value(entry) for entry in value)}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml_value(entry)}" for key, entry in value.items() if entry is not None) + " }"
    raise TypeError(f"a case cannot hold {value!r}, a {type(value).__name__}")


def toml_of(case):
    """The text of a case file for a nested dict: one table per dict, one line per key. Keys with the value None are omitted."""
    plain = {key: value for key, value in case.items() if not isinstance(value, dict) and value is not None}
    lines = [f"{key} = {toml_value(value)}" for key, value in plain.items()]
    for name, table in case.items():
        if isinstance(table, dict):
            lines += ["", f"[{name}]", *(f"{key} = {toml_value(value)}" for key, value in table.items() if value is not None)]
    return "\n".join(lines) + "\n"


def settings_of(values):
    """{"key.path": value} as arguments of --set; None removes a key, so that its default holds."""
    return [f"{key}={'none' if value is None else toml_value(value)}" for key, value in (values or {}).items()]


def source_of(case, folder="."):
    """Path, text and folder of a case, as the functions of _cosurge expect them."""
    if isinstance(case, dict):
        return "", toml_of(case), os.fspath(folder)
    return os.fspath(case), "", os.fspath(folder)


def check(case, set=None, folder="."):
    """The case with all its defaults, as a dict.

    case: a folder with a case.toml, the file, or a dict; the files that a dict names lie in `folder`.
    set: {"key.path": value}, changes of the case.
    Raises cosurge.Error with all errors of the case, as `cosurge check` reports them.
    """
    return json.loads(_cosurge.checked_case(*source_of(case, folder), settings_of(set)))
