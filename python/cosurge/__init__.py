"""Wave impacts on elastic structures: cases, runs and results of Cosurge in Python.

    import cosurge
    run = cosurge.run("cases/dam_break_plate", {"time.end": 0.4})
    tip = run["solid/tip_x"]            # an array with .unit and .time
    print(tip.peak, tip.time_of_peak)
    run                                 # in a notebook: the report of the run

docs/python.md explains it.
"""
import os

# OpenMP reads it once: its threads must not spin while they wait.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

from ._cosurge import Error, NumericalError, Window, version as __version__  # noqa: E402
from .cases import check, toml_of  # noqa: E402
from .results import History, Results, report  # noqa: E402
from .runs import run, sweep  # noqa: E402
from .solid import Solid, serve  # noqa: E402

__all__ = ["Error", "History", "NumericalError", "Results", "Solid", "Window", "check", "report", "run", "serve", "sweep",
           "toml_of", "__version__"]
