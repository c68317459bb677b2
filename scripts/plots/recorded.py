"""The recorded data of a run, from its results.h5, and the folder of its case."""
import json
import sys
import time
import tomllib
from pathlib import Path

import h5py
import numpy as np

SNAPSHOTS = 6
ROOT = Path(__file__).resolve().parent.parent.parent


class Run:
    """The data recorded so far."""

    def __init__(self, folder):
        self.file = folder / "results.h5"
        with h5py.File(self.file, "r") as file:
            self.title = str(file.attrs["title"])
            self.case = json.loads(file.attrs["case"])
            case_file = str(file.attrs.get("case_file", ""))
            self.case_folder = Path(case_file).parent if case_file else None
            self.frame_times = file["frames/time"][:]
            self.history = {}
            file["history"].visititems(self._read)
            rows = min(map(len, self.history.values()))
            self.history = {name: values[:rows] for name, values in self.history.items()}
            chosen = np.linspace(0, len(self.frame_times) - 1, min(SNAPSHOTS, len(self.frame_times)))
            self.frames = [self._frame(file, int(k)) for k in np.unique(chosen.round())] if len(chosen) else []
        summary = folder / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.exists() else {}

    def _read(self, name, item):
        if isinstance(item, h5py.Dataset):
            self.history[name] = item[:]

    def _frame(self, file, k):
        groups = {name: group for name, group in file["frames"].items() if isinstance(group, h5py.Group)}
        arrays = {name: {array: group[array][k] for array in group} for name, group in groups.items()}
        return {"time": self.frame_times[k], **arrays}

    def all_frames(self, member, array):
        """Frames x particles (x components); None where the run has no such array, or no frame."""
        with h5py.File(self.file, "r") as file:
            path = f"frames/{member}/{array}"
            return file[path][:len(self.frame_times)] if path in file and len(self.frame_times) else None

    @property
    def time(self):
        return self.history["time"]

    def probes(self, quantity):
        return [probe for probe in self.case.get("output", {}).get("probe", []) if probe["quantity"] == quantity]

    def columns(self, group, prefix=""):
        start = f"{group}/{prefix}"
        return {name[len(start):]: values for name, values in self.history.items() if name.startswith(start)}


def read_run(folder):
    """A writer that is just flushing makes parts of the file unreadable for a moment."""
    path = folder / "results.h5"
    if not path.exists():
        sys.exit(f"{path}: no such file")
    for _ in range(20):
        try:
            return Run(folder)
        except OSError:
            time.sleep(0.1)
    return Run(folder)


def find_case_folder(run):
    """The case folder that the results name, or the one of this project with the same title."""
    if run.case_folder and run.case_folder.is_dir():
        return run.case_folder
    for path in sorted(ROOT.glob("cases/*/case.toml")):
        if tomllib.loads(path.read_text()).get("title") == run.title:
            return path.parent
    return None
