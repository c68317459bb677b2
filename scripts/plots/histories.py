"""Probes, levels and energies over time, with published curves beside them."""
import csv
import re

import numpy as np

from plots.low_pass import CUT_OFF, low_passed
from plots.style import plt


def reference_curves(case_folder, *wanted):
    """Curves of reference/*.csv that have one of these pairs of columns, by a name made from the file's."""
    curves = {}
    for path in sorted(case_folder.glob("reference/*.csv")) if case_folder else []:
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        if tuple(name.strip() for name in rows[0]) in wanted:
            name, letter = re.fullmatch(r"(.*?)(_[a-z])?", path.stem).groups()
            name = name.replace("_", " ").title() + (f" ({letter[1]})" if letter else "")
            curves[name] = np.array(rows[1:], float).T
    return curves


def draw_references(axes, curves, factor, label="{}", first=0):
    """Thin lines, coloured from the colour `first` on; returns their number."""
    colors = plt.get_cmap("tab10").colors
    for k, (name, (t, values)) in enumerate(curves.items(), first):
        axes.plot(t, factor * values, color=colors[k % 10], lw=0.9, alpha=0.75, ls=("-", "--")[k // 10 % 2],
                  label=label.format(name))
    return len(curves)


def tip(run, case_folder):
    probes = [p for p in run.probes("displacement") if f"solid/{p['name']}_x" in run.history]
    if not probes or not len(run.time):
        return None
    figure, grid = plt.subplots(len(probes), 1, squeeze=False, layout="constrained", figsize=(9, 4.4 * len(probes)))
    for axes, probe in zip(grid.flat, probes):
        curves = 0
        for direction in "xyz":
            own = f"{probe['name']}_{direction}_m"
            references = reference_curves(case_folder, ("t_s", f"u{direction}_m"), ("t_s", own))
            label = "{}" if direction == "x" else "{}, " + direction
            curves += draw_references(axes, references, 1000, label, curves)
        for direction, color in (("x", "black"), ("y", "0.5"), ("z", "0.75")):
            values = run.history.get(f"solid/{probe['name']}_{direction}")
            if values is not None:
                label = f"this run, {direction}"
                axes.plot(run.time, 1000 * values, color=color, lw=2 if direction == "x" else 1.2, label=label)
        axes.set(xlabel="t [s]", ylabel="displacement [mm]", title=f"{run.title}: {probe['name']}", xlim=(0, None))
        axes.legend(fontsize=8, ncols=2 if curves else 1)
    return figure


def front(run, case_folder):
    references = reference_curves(case_folder, ("t", "z"))
    column = run.case["fluid"]["water"][0] if "fluid/front" in run.history else {}
    if not references or "max" not in column:
        return None
    width = column["max"][0] - column["min"][0]
    gravity = np.linalg.norm(run.case["gravity"])
    figure, axes = plt.subplots(layout="constrained", figsize=(7, 4.6))
    for marker, (name, (t, z)) in zip("os^dv", references.items()):
        axes.plot(t, z, marker, mfc="none", ms=4, label=name)
    last = max(t[-1] for t, _ in references.values())
    reached = run.time * np.sqrt(2 * gravity / width)
    shown = reached <= last
    axes.plot(reached[shown], run.history["fluid/front"][shown] / width, "k", lw=1.8, label="this run")
    axes.set(xlabel="t sqrt(2 g / a)", ylabel="front / a", title=run.title)
    axes.legend()
    return figure


def evenly(run, values):
    """Windows differ in length: values on even steps as short as the median window, and their rate."""
    step = np.median(np.diff(run.time))
    times = np.arange(run.time[0], run.time[-1], step)
    return times, np.interp(times, run.time, values), 1 / step


def pressure(run, case_folder):
    probes = [p for p in run.probes("pressure") if f"fluid/{p['name']}" in run.history]
    if not probes or len(run.time) < 50:
        return None
    figure, grid = plt.subplots(len(probes), 2, squeeze=False, layout="constrained", figsize=(11, 3.2 * len(probes)),
                                gridspec_kw={"width_ratios": (2.2, 1)})
    for (left, right), probe in zip(grid, probes):
        values = run.history[f"fluid/{probe['name']}"] / 1000
        times, even, rate = evenly(run, np.nan_to_num(values))
        draw_references(left, reference_curves(case_folder, ("t_s", f"{probe['name']}_Pa")), 1e-3)
        smooth = low_passed(even, rate)
        left.plot(run.time, values, color="#9ec5e8", lw=0.6, label=f"raw, up to {np.nanmax(values):.1f} kPa")
        if smooth is not None:
            label = f"below {CUT_OFF:.0f} Hz, up to {smooth.max():.1f} kPa"
            left.plot(times, smooth, color="#123f6d", lw=1.6, label=label)
            left.set_ylim(min(0, 1.3 * smooth.min()), max(1.6 * smooth.max(), np.nanpercentile(values, 99.5)))
        left.set(xlabel="t [s]", ylabel="pressure [kPa]", title=f"{run.title}: {probe['name']}", xlim=(0, None))
        left.legend(fontsize=8, loc="upper right")
        amplitude = 2 * np.abs(np.fft.rfft(even)) / len(even)
        frequency = np.fft.rfftfreq(len(even), 1 / rate)
        right.semilogy(frequency[1:], amplitude[1:], color="#123f6d", lw=0.8)
        right.axvline(CUT_OFF, color="0.5", ls=":", lw=1)
        right.set(xlabel="f [Hz]", ylabel="amplitude [kPa]", title="single-sided spectrum",
                  xlim=(0, min(5 * CUT_OFF, rate / 2)))
    return figure


def level(run, case_folder):
    probes = [p for p in run.probes("level") if f"fluid/{p['name']}" in run.history]
    if not probes or not len(run.time):
        return None
    figure, axes = plt.subplots(layout="constrained", figsize=(9, 4))
    for probe in probes:
        place = ", ".join(f"{x:g}" for x in probe["position"][:-1])
        draw_references(axes, reference_curves(case_folder, ("t_s", f"{probe['name']}_m")), 1, "{}, at " + place + " m")
        axes.plot(run.time, run.history[f"fluid/{probe['name']}"], lw=1.4, label=f"{probe['name']}, at {place} m")
    axes.set(xlabel="t [s]", ylabel="level [m]", title=f"{run.title}: free surface", xlim=(0, None))
    axes.legend(fontsize=8)
    return figure


def energy(run):
    groups = [
        ("water", [("fluid/kinetic_energy", "kinetic"), ("fluid/gravity_energy", "potential")]),
        ("structure", [("solid/kinetic_energy", "kinetic"), ("solid/elastic_energy", "elastic"),
                       ("solid/gravity_energy", "potential"),
                       ("solid/interface_work", "work of the water, in the solid"),
                       ("coupling/work_points", "work of the water, at the points")]),
    ]
    groups = [(title, [(n, label) for n, label in lines if n in run.history]) for title, lines in groups]
    groups = [(title, lines) for title, lines in groups if any("energy" in name for name, _ in lines)]
    if not groups or not len(run.time):
        return None
    figure, grid = plt.subplots(len(groups), 1, squeeze=False, layout="constrained", figsize=(9, 3.4 * len(groups)))
    for axes, (title, lines) in zip(grid.flat, groups):
        for name, label in lines:
            dashes = "--" if name.startswith("coupling") else "-"
            axes.plot(run.time, run.history[name], label=label, lw=1.4, ls=dashes)
        sums = [run.history[name] for name, label in lines if not label.startswith("work")]
        axes.plot(run.time, sum(sums), color="black", lw=1, label="sum of energies")
        unit = "J/m" if run.case.get("dimension", 2) == 2 else "J"
        axes.set(xlabel="t [s]", ylabel=f"energy [{unit}]", title=f"{run.title}: {title}", xlim=(0, None))
        axes.legend(fontsize=8)
    return figure
