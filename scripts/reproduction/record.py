"""numbers.csv: what the runs have shown, by the name of the run; it outlives their results."""
import numpy as np

import measures
import open_points
import runs
import tables

FIRST_BLOW = 0.3  # s: what a dam break must have gone through to count
TEXTS, DIGITS = ("run", "identity", "status"), 5


class Numbers:
    """Rows of numbers by the name of the run, and histories of those whose results are at hand; read once.

    Results may be deleted: what numbers.csv in `out` says of a run stays as long as its case and settings do.
    """

    def __init__(self, study, out):
        self.rows = {}
        self.histories = {}
        kept = read(out / "numbers.csv")
        for run in runs.of(runs.GROUPS):
            identity = run.identity()[:12]
            old = kept.get(run.name)
            if old and old["identity"] != identity:
                old = None
            summary = study.begun(run)
            if counts(run, summary) and (old is None or study.summary(run)):
                row = {"identity": identity, "status": summary["status"]}
                if run.case != "cantilever":  # there its end is all that is asked
                    self.histories[run.name] = measures.History(study.folder_of(run))
                    found = numbers_of(run, self.histories[run.name], summary)
                    row |= tables.rounded(found, DIGITS)
                    if old and old["windows"] == row["windows"]:  # the same work again: other programs only add to it
                        row |= {cost: np.fmin(row[cost], old[cost]) for cost in ("core_s", "solid_core_s", "wall_s")}
                self.rows[run.name] = row
            elif old:
                self.rows[run.name] = old

    def family(self, settings, spacing):
        """Numbers by stiffness of one set of runs of Table 2."""
        names = {label: f"stiffness_{settings}_{label}_{spacing}" for label in runs.STIFFNESS}
        return {label: self.rows[name] for label, name in names.items() if name in self.rows}


def counts(run, summary):
    """Whether a run has gone far enough: a dam break through the blow, a cantilever to its end, well or not."""
    if summary is None:
        return False
    if run.case == "cantilever":
        return summary["status"] in ("finished", "failed")
    return summary.get("end_time", 0) >= FIRST_BLOW


def numbers_of(run, history, summary):
    if run.case == "dam_break_plate_3d":
        return measures.tip_numbers(history) | measures.cost(summary)
    row = measures.numbers(history, summary)
    if run.name.startswith("verification_"):
        row |= open_points.normals(history.folder, history.case)
    return row


def read(path):
    """Rows of numbers.csv by the name of the run."""
    return {row.pop("run"): row for row in tables.read(path, TEXTS)}


def write(numbers, path):
    rows = [{"run": name} | row for name, row in sorted(numbers.rows.items())]
    tables.write(path, "scripts/reproduce", rows, TEXTS, DIGITS)
