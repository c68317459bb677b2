"""Forces, moments, stresses and overtopping over time."""
import numpy as np

from plots.histories import draw_references, reference_curves
from plots.style import plt

COLORS = {"x": "#123f6d", "y": "#d1495b", "z": "#1b998b"}


def unit_of(run, quantity):
    """Of forces and moments: per metre of width in two dimensions."""
    unit = {"force": "N", "moment": "N m"}[quantity]
    return unit if run.case.get("dimension", 2) == 3 else {"N": "N/m", "N m": "N"}[unit]


def panels(count, height=3.2):
    figure, grid = plt.subplots(count, 1, squeeze=False, layout="constrained", figsize=(9, height * count))
    return figure, list(grid.flat)


def draw_columns(run, axes, columns, case_folder, unit):
    """Curves of {label: name of the history}, with published ones of the same column."""
    for label, name in columns.items():
        own = name.split("/")[-1]
        draw_references(axes, reference_curves(case_folder, ("t_s", f"{own}_{unit.replace(' ', '')}")), 1)
        axes.plot(run.time, run.history[name], lw=1.2, color=COLORS.get(label, "black"), label=label or "this run")
    axes.set(xlabel="t [s]", xlim=(0, None))
    axes.legend(fontsize=8)


def vector(run, stem):
    """{"x": its history, ...} of those that the run has; {"": it} of one that is no vector."""
    columns = {axis: f"{stem}_{axis}" for axis in "xyz" if f"{stem}_{axis}" in run.history}
    return columns or ({"": stem} if stem in run.history else {})


def force(run, case_folder):
    """Force probes, and the load of the water on all structures together."""
    found = [(probe["name"], vector(run, f"fluid/{probe['name']}")) for probe in run.probes("force")]
    whole = vector(run, "coupling/force")
    if any(np.any(run.history[name]) for name in whole.values()):
        found.append(("load of the water on the structure", whole))
    return draw_all(run, case_folder, "force", found)


def moment(run, case_folder):
    return draw_all(run, case_folder, "moment",
                    [(probe["name"], vector(run, f"fluid/{probe['name']}")) for probe in run.probes("moment")])


def draw_all(run, case_folder, quantity, found):
    found = [(title, columns) for title, columns in found if columns]
    if not found or not len(run.time):
        return None
    figure, grid = panels(len(found))
    unit = unit_of(run, quantity)
    for axes, (title, columns) in zip(grid, found):
        draw_columns(run, axes, columns, case_folder, unit)
        axes.set(ylabel=f"{quantity} [{unit}]", title=f"{run.title}: {title}")
    return figure


def stress(run):
    """Largest von Mises stress of the frames, and the value that a hundredth of the particles exceeds."""
    stresses = run.all_frames("solid", "von_mises")
    if stresses is None or not np.any(stresses):
        return None
    figure, (axes,) = panels(1, 3.6)
    axes.plot(run.frame_times, stresses.max(axis=1) / 1e3, "k.-", lw=1.2, ms=3, label="largest")
    axes.plot(run.frame_times, np.percentile(stresses, 99, axis=1) / 1e3, color="#ec7014", lw=1.2,
              label="exceeded by 1 % of the particles")
    axes.set(xlabel="t [s]", ylabel="von Mises stress [kPa]", title=f"{run.title}: stress in the structure, at the frames",
             xlim=(0, None), ylim=(0, None))
    axes.legend(fontsize=8)
    return figure


def overtopping(run):
    """Water that has left the tank, by side; and water behind a structure that all water was in front of."""
    spacing = run.case.get("fluid", {}).get("spacing")
    curves = {}
    if spacing and len(run.time):
        volume = spacing**run.case.get("dimension", 2)
        for name, values in run.columns("fluid", "lost_").items():
            if name != "over_rim" and np.any(values):
                curves[f"out of the tank, {name.replace('_', ' ')}"] = (run.time, volume * values)
        behind = water_behind(run)
        if behind is not None and np.any(behind):
            curves["behind the structure"] = (run.frame_times, volume * behind)
    if not curves:
        return None
    figure, (axes,) = panels(1, 3.6)
    for label, (time, values) in curves.items():
        axes.plot(time, values, lw=1.4, label=label)
    unit = "m2" if run.case.get("dimension", 2) == 2 else "m3"
    axes.set(xlabel="t [s]", ylabel=f"water [{unit}]", title=f"{run.title}: overtopping", xlim=(0, None), ylim=(0, None))
    axes.legend(fontsize=8)
    return figure


def water_behind(run):
    """Particles of water beyond the structure's largest x, at each frame; None where some were there at the start."""
    water, structure = run.all_frames("fluid", "position"), run.all_frames("solid", "position")
    kinds = run.all_frames("fluid", "kind")
    if water is None or structure is None or kinds is None:
        return None
    last = structure[:, :, 0].max(axis=1)
    counts = ((kinds == 0) & (water[:, :, 0] > last[:, None])).sum(axis=1)
    return counts if counts[0] == 0 else None
