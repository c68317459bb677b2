"""Runs of cases."""
import itertools
import os

from . import _cosurge
from .cases import settings_of, source_of
from .results import Results


def run(case, set=None, out=None, *, solid=None, on_window=None, wire=False, threads=0, folder="."):
    """Runs a case and returns its Results, which lie in the folder `out` (default: a new one in results/).

    case, set, folder: as in check().
    solid: your own structure: a cosurge.Solid, or, with wire=True, the command of a program.
    on_window: called after every window with the time [s] and a dict of all values; True ends the run early.
    wire: run the solvers in processes of their own (a Python Solid in a thread), as in `cosurge run`. The results are
    bit-identical.
    threads: number of threads of the fluid solver; 0: one per core.
    Raises Error for errors in the case or the solid, NumericalError if the computation fails, and the exceptions of on_window
    and the solid. The results up to then are kept.
    """
    done = _cosurge.run(*source_of(case, folder), settings_of(set), "" if out is None else os.fspath(out), solid, on_window,
                        wire, threads)
    return Results(done)


def sweep(case, over, out, set=None, **options):
    """Runs a case with all combinations of values; yields (values, Results) for each, one after the other.

    over: {"key.path": [value, ...]}. out: the folder of all runs; finished runs in it are not repeated.
    options: as in run().
    """
    for combination in itertools.product(*over.values()):
        values = dict(zip(over, combination))
        name = ",".join(f"{key}={value}" for key, value in values.items()).replace("/", "_")
        place = os.path.join(os.fspath(out), name)
        if os.path.isfile(os.path.join(place, "results.h5")):
            results = Results(place)
            if results.summary.get("status") == "finished":
                yield values, results
                continue
        yield values, run(case, {**(set or {}), **values}, place, **options)
