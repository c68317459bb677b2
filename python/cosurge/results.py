"""Results of runs: histories and frames as arrays with units, and the report."""
import html
import json
import os
from pathlib import Path

import h5py
import numpy as np

from . import _cosurge


class History(np.ndarray):
    """Values of one column over the windows of a run, with .name, .unit and .time [s]. Arithmetic returns plain arrays."""

    def __new__(cls, values, name, unit, time):
        history = np.asarray(values).view(cls)
        history.name, history.unit, history.time = name, unit, time
        return history

    def __array_finalize__(self, other):
        self.name, self.unit, self.time = getattr(other, "name", ""), getattr(other, "unit", ""), getattr(other, "time", None)

    def __array_wrap__(self, array, context=None):  # a square has another unit
        return np.asarray(array)[()]

    def __getitem__(self, index):
        part = np.asarray(self)[index]
        if np.ndim(part) != 1:
            return part
        return History(part, self.name, self.unit, self.time[index])

    @property
    def peak(self):
        """The value farthest from zero; the first one if there are several. NaN counts as no value."""
        return float(np.asarray(self)[self._farthest()])

    @property
    def time_of_peak(self):
        """Time of the peak [s]."""
        return float(self.time[self._farthest()])

    @property
    def impulse(self):
        """Integral over time by the trapezoidal rule [unit s]."""
        mean = (np.asarray(self)[1:] + np.asarray(self)[:-1]) / 2
        return float(np.nansum(mean * np.diff(self.time)))

    def _farthest(self):
        return int(np.nanargmax(np.abs(np.asarray(self))))


class Frame(dict):
    """{array: values} of one solver at one instant, with .time [s] and .units."""


class Results:
    """The results of a run in a folder. Every call reads the files again, so that it can be used during the run."""

    def __init__(self, folder):
        """Raises FileNotFoundError if the folder contains no results."""
        self.folder = Path(folder)
        self.file = self.folder / "results.h5"
        if not self.file.is_file():
            raise FileNotFoundError(f"{self.folder}: contains no results (results.h5)")
        with self._open() as file:
            self.case = json.loads(file.attrs["case"])
            self.title = str(file.attrs["title"])

    def _open(self):
        return h5py.File(self.file, "r")

    @property
    def summary(self):
        """summary.json as a dict; empty before the end of the run."""
        path = self.folder / "summary.json"
        return json.loads(path.read_text()) if path.is_file() else {}

    def keys(self):
        """Names of the histories: "fluid/front", "solid/tip_x", ..."""
        names = []
        with self._open() as file:
            file["history"].visititems(lambda name, entry: names.append(name) if isinstance(entry, h5py.Dataset) else None)
        return sorted(names)

    def __contains__(self, name):
        return name in self.keys()

    def __getitem__(self, name):
        """The History of this name. Raises KeyError, with the existing names, if there is none."""
        with self._open() as file:
            if name not in file["history"] or not isinstance(file["history"][name], h5py.Dataset):
                raise KeyError(f"{name}; the run has {', '.join(self.keys())}")
            data, time = file["history"][name], file["history/time"][:]
            rows = min(len(data), len(time))
            return History(data[:rows], name, str(data.attrs["unit"]), time[:rows])

    @property
    def frame_times(self):
        """Instants of the frames [s]."""
        with self._open() as file:
            return file["frames/time"][:]

    def frame(self, member, index=-1):
        """The particles of "fluid" or "solid" at one frame: a Frame of arrays with one row per particle."""
        with self._open() as file:
            group = file[f"frames/{member}"]
            frame = Frame({name: data[index] for name, data in group.items()})
            frame.time = float(file["frames/time"][index])
            frame.units = {name: str(data.attrs["unit"]) for name, data in group.items()}
        return frame

    def to_xarray(self):
        """All histories as an xarray.Dataset over time, with units as attributes. Needs xarray."""
        import xarray
        histories = [self[name] for name in self.keys() if name != "time"]
        rows = min(len(history) for history in histories)
        return xarray.Dataset({history.name: ("time", np.asarray(history[:rows]), {"units": history.unit})
                               for history in histories},
                              {"time": ("time", np.asarray(histories[0].time[:rows]), {"units": "s"})}, {"title": self.title})

    def __repr__(self):
        return f"<cosurge.Results {self.folder}: {self.title}, {self.summary.get('status', 'unfinished')}>"

    def _repr_html_(self):
        return report([self], megabytes=3)._repr_html_()


class Report:
    """The page of some runs: shown inline in a notebook, or saved."""

    def __init__(self, text):
        self.text = text

    def save(self, file):
        """Writes the page to a file. Raises FileExistsError if the file exists."""
        with open(file, "x") as page:
            page.write(self.text)

    def _repr_html_(self):
        return (f'<iframe srcdoc="{html.escape(self.text)}" style="width: 100%; height: 900px; border: 0" '
                'sandbox="allow-scripts"></iframe>')


def report(runs, megabytes=5):
    """The page of `cosurge report` for some runs (Results or folders), of about `megabytes` MB."""
    return Report(_cosurge.report_page([os.fspath(getattr(run, "folder", run)) for run in runs], megabytes))
