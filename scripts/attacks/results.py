"""Content of results, and whether it is bit-identical to an undisturbed run."""
import json

import h5py


def datasets(file):
    """Every dataset that does not depend on the clock."""
    found = {}
    with h5py.File(file, "r") as results:
        results.visititems(lambda name, item: found.update({name: item[()]})
                           if isinstance(item, h5py.Dataset) and "seconds" not in name else None)
    return found


def rows_and_frames(found):
    return len(found.get("history/time", ())), len(found.get("frames/time", ()))


def _same(a, b):
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()


def differences_of_part(part, whole):
    """Checks results that end early: their content must be right."""
    wrong = [f"{name}: not in the undisturbed run" for name in part if name not in whole]
    for name in part:
        expected = whole.get(name)
        if expected is not None and not name.startswith("interface"):
            expected = expected[:len(part[name])]
        if expected is not None and not _same(part[name], expected):
            wrong.append(f"{name}: wrong")
    return wrong


def differences(part, whole):
    wrong = [f"{name}: only in one of both" for name in set(part) ^ set(whole)]
    return wrong + [f"{name}: {part[name].shape} instead of {whole[name].shape}, or other bits"
                    for name in sorted(set(part) & set(whole)) if not _same(part[name], whole[name])]


def summary(folder):
    """Without values that depend on the clock."""
    found = json.loads((folder / "summary.json").read_text())
    for key in ("wall_seconds", "exchange_seconds"):
        found.pop(key, None)
    for member in found.get("participants", {}).values():
        member.pop("seconds", None)
    return found
