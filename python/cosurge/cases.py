"""Cases: folders, files, or dicts."""
import json
import math
import os

from . import _cosurge


def toml_value(value):
    """A value of Python in TOML. Raises TypeError for values that TOML does not have."""
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
    """A dict, with dicts and lists in it, as the text of a case file: a table a group, a line a key. None leaves a key out."""
    plain = {key: value for key, value in case.items() if not isinstance(value, dict) and value is not None}
    lines = [f"{key} = {toml_value(value)}" for key, value in plain.items()]
    for name, table in case.items():
        if isinstance(table, dict):
            lines += ["", f"[{name}]", *(f"{key} = {toml_value(value)}" for key, value in table.items() if value is not None)]
    return "\n".join(lines) + "\n"


def settings_of(values):
    """{"key.path": value} as the words of --set; None removes a key, so that its default holds."""
    return [f"{key}={'none' if value is None else toml_value(value)}" for key, value in (values or {}).items()]


def source_of(case, folder="."):
    """path, text and folder of a case, as _cosurge takes them."""
    if isinstance(case, dict):
        return "", toml_of(case), os.fspath(folder)
    return os.fspath(case), "", os.fspath(folder)


def check(case, set=None, folder="."):
    """The case with all its defaults, as a dict.

    case: a folder with a case.toml, the file, or a dict, whose files lie in `folder`. set: {"key.path": value}.
    Raises cosurge.Error with all that is wrong, in the words of `cosurge check`.
    """
    return json.loads(_cosurge.checked_case(*source_of(case, folder), settings_of(set)))
