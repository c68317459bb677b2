#!/usr/bin/python3
"""Pictures of a run, from its results.h5: scripts/plot_run.py FOLDER [--out DIR] [--case DIR]

snapshots.png  the water by pressure and the structure at six instants
tip.png        displacement probes; published curves beside them where the case folder has some (reference/*.csv)
front.png      front of the water on the floor, where the case folder has published fronts
pressure.png   pressure probes, raw and low-passed, and their spectra
level.png      level probes
energy.png     kinetic, potential and elastic energy, and the work through the interface
timing.png     where the wall time went

Works while the run goes on, and for runs of a fluid or a solid alone. What a run does not have is left out.
"""
import argparse
import csv
import json
import re
import sys
import time
import tomllib
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.signal import butter, sosfiltfilt

CUT_OFF = 70.0  # Hz, of the low-pass for impact pressures: the published study's
SNAPSHOTS = 6
HIGHEST = 1.2  # height over width of a snapshot
WALL_KINDS = (1, 2)  # of the fluid's particles: wall, dummy; 0 is water
SOLID_COLOR, WALL_COLOR = "#e8743b", "#b8bcc2"

plt.rcParams.update({
    "font.size": 10, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.alpha": 0.3,
    "legend.frameon": False, "figure.dpi": 110, "savefig.dpi": 150, "axes.titlesize": 10,
})


class Run:
    """What has been recorded so far."""

    def __init__(self, folder):
        with h5py.File(folder / "results.h5", "r") as file:
            self.title = str(file.attrs["title"])
            self.case = json.loads(file.attrs["case"])
            self.case_folder = file.attrs.get("case_folder")
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


# Snapshots

def axes_of(run):
    """Horizontal and upward axis of the pictures, and the axis across them, in three dimensions."""
    gravity = np.array(run.case.get("gravity", [0, -1]))
    dimension = run.case.get("dimension", 2)
    if dimension == 2:
        return 0, 1, None
    up = int(np.abs(gravity).argmax())
    across = 1 if up == 2 else 2
    return ({0, 1, 2} - {up, across}).pop(), up, across


def slice_of(run, particles, spacing):
    """Positions in the picture's plane: all of them, or the middle slice of three dimensions."""
    right, up, across = axes_of(run)
    position = particles["position"]
    shown = np.isfinite(position).all(axis=1)
    if across is not None and shown.any():
        middle = np.nanmean([np.nanmin(position[:, across]), np.nanmax(position[:, across])])
        shown &= np.abs(position[:, across] - middle) <= 0.75 * spacing
    return position[:, [right, up]], shown


def dots(axes, points, spacing, overlap=1.3, **style):
    """Particles as discs a little wider than they are apart."""
    scale = axes.transData.transform([(0, 0), (1, 0)])
    points_per_metre = (scale[1, 0] - scale[0, 0]) * 72 / axes.figure.dpi
    area = (overlap * spacing * points_per_metre) ** 2
    return axes.scatter(points[:, 0], points[:, 1], s=area, linewidths=0, **style)


def view_of(run, spacing):
    """Limits that hold all but a few drops, and no walls above the water."""
    low, high = [], []
    for frame in run.frames:
        for group in ("fluid", "solid"):
            if "position" not in frame.get(group, {}):
                continue
            points, shown = slice_of(run, frame[group], spacing[group])
            wall = np.isin(frame[group].get("kind", np.zeros(len(points))), WALL_KINDS)
            low.append(np.percentile(points[shown], 0.05, axis=0))
            high.append(np.percentile(points[shown], 99.95, axis=0))
            high[-1][1] = np.percentile(points[shown & ~wall, 1], 99.5)
    low, high = np.min(low, axis=0), np.max(high, axis=0)
    margin = max(0.03 * max(high - low), *(side for side in spacing.values() if side))
    low, high = low - margin, high + margin
    narrow = max(0, (high - low)[1] / HIGHEST - (high - low)[0]) / 2
    return low - (narrow, 0), high + (narrow, 0)


def pressure_scale(run):
    wet = [frame["fluid"]["pressure"][frame["fluid"]["kind"] == 0] for frame in run.frames]
    wet = np.concatenate(wet)
    wet = wet[np.isfinite(wet) & (wet > 0)]
    return float(np.percentile(wet, 99)) if len(wet) else 1.0


def draw_frame(run, axes, frame, spacing, top):
    image = None
    if "fluid" in frame:
        fluid = frame["fluid"]
        points, shown = slice_of(run, fluid, spacing["fluid"])
        wall, water = shown & np.isin(fluid["kind"], WALL_KINDS), shown & (fluid["kind"] == 0)
        dots(axes, points[wall], spacing["fluid"], overlap=1.6, color=WALL_COLOR)
        image = dots(axes, points[water], spacing["fluid"], c=fluid["pressure"][water] / 1000, cmap="viridis",
                     vmin=0, vmax=top / 1000)
    if "solid" in frame and "position" in frame["solid"]:
        points, shown = slice_of(run, frame["solid"], spacing["solid"])
        dots(axes, points[shown], spacing["solid"], overlap=1.4, color=SOLID_COLOR)
    axes.set_title(f"t = {frame['time']:.3f} s")
    return image


def snapshots(run):
    if not run.frames:
        return None
    fluid, solid = run.case.get("fluid", {}), run.case.get("solid", {})
    spacing = {"fluid": fluid.get("spacing"), "solid": solid.get("spacing", fluid.get("spacing"))}
    low, high = view_of(run, spacing)
    columns = min(3, len(run.frames))
    rows = -(-len(run.frames) // columns)
    width = 3.6
    height = width * (high - low)[1] / (high - low)[0]
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="constrained",
                                figsize=(columns * (width + 0.3) + 1, rows * (height + 0.4) + 0.4))
    for axes in grid.flat:
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        axes.grid(False)
        axes.tick_params(length=2, labelsize=8)
    figure.suptitle(run.title)
    figure.canvas.draw()  # settles the scale that the size of the discs needs
    top = pressure_scale(run) if "fluid" in run.frames[0] else None
    for axes, frame in zip(grid.flat, run.frames):
        image = draw_frame(run, axes, frame, spacing, top)
    for axes in grid.flat[len(run.frames):]:
        axes.set_visible(False)
    if image is not None:
        figure.colorbar(image, ax=grid, label="pressure [kPa]", shrink=0.8, aspect=30, extend="max")
    for axes in grid[-1]:
        axes.set_xlabel("x [m]")
    return figure


# Histories

def reference_curves(case_folder, columns):
    """Curves of reference/*.csv with these columns, by a name made from the file's."""
    curves = {}
    for path in sorted(case_folder.glob("reference/*.csv")) if case_folder else []:
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        if [name.strip() for name in rows[0]] == columns:
            name, letter = re.fullmatch(r"(.*?)(_[a-z])?", path.stem).groups()
            name = name.replace("_", " ").title() + (f" ({letter[1]})" if letter else "")
            curves[name] = np.array(rows[1:], float).T
    return curves


def tip(run, case_folder):
    probes = [p for p in run.probes("displacement") if f"solid/{p['name']}_x" in run.history]
    if not probes or not len(run.time):
        return None
    references = reference_curves(case_folder, ["t_s", "ux_m"])
    figure, grid = plt.subplots(len(probes), 1, squeeze=False, layout="constrained", figsize=(9, 4.4 * len(probes)))
    for axes, probe in zip(grid.flat, probes):
        colors = plt.get_cmap("tab10").colors
        for k, (name, (t, x)) in enumerate(references.items()):
            axes.plot(t, 1000 * x, color=colors[k % 10], lw=0.9, alpha=0.75, ls=("-", "--")[k // 10 % 2], label=name)
        for direction, color in (("x", "black"), ("y", "0.5"), ("z", "0.75")):
            values = run.history.get(f"solid/{probe['name']}_{direction}")
            if values is not None:
                label = f"this run, {direction}"
                axes.plot(run.time, 1000 * values, color=color, lw=2 if direction == "x" else 1.2, label=label)
        axes.set(xlabel="t [s]", ylabel="displacement [mm]", title=f"{run.title}: {probe['name']}", xlim=(0, None))
        axes.legend(fontsize=8, ncols=2 if references else 1)
    return figure


def front(run, case_folder):
    references = reference_curves(case_folder, ["t", "z"])
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


def low_passed(values, rate):
    """4th-order Butterworth, forward and backward: no delay. None where the series is too short or too coarse."""
    if rate <= 2.5 * CUT_OFF or len(values) < rate / CUT_OFF:
        return None
    return sosfiltfilt(butter(4, CUT_OFF, fs=rate, output="sos"), values)


def pressure(run):
    probes = [p for p in run.probes("pressure") if f"fluid/{p['name']}" in run.history]
    if not probes or len(run.time) < 50:
        return None
    figure, grid = plt.subplots(len(probes), 2, squeeze=False, layout="constrained", figsize=(11, 3.2 * len(probes)),
                                gridspec_kw={"width_ratios": (2.2, 1)})
    for (left, right), probe in zip(grid, probes):
        values = run.history[f"fluid/{probe['name']}"] / 1000
        times, even, rate = evenly(run, np.nan_to_num(values))
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


def level(run):
    probes = [p for p in run.probes("level") if f"fluid/{p['name']}" in run.history]
    if not probes or not len(run.time):
        return None
    figure, axes = plt.subplots(layout="constrained", figsize=(9, 4))
    for probe in probes:
        place = ", ".join(f"{x:g}" for x in probe["position"][:-1])
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


# Time spent

def phases(run):
    """Seconds of every phase by process, the longest first."""
    bars = {}
    for process in ("fluid", "solid", "coupling"):
        spent = {name.replace("_", " "): values[-1] for name, values in run.columns(process, "seconds_").items()}
        if spent:
            bars[process] = spent
    exchange = run.summary.get("exchange_seconds")
    if exchange is not None and "exchange" not in bars.get("coupling", {}):
        bars.setdefault("coupling", {})["exchange"] = exchange
    return {process: dict(sorted(spent.items(), key=lambda item: -item[1])) for process, spent in bars.items()}


def timing(run):
    if not len(run.time):
        return None
    bars = phases(run)
    if not bars:
        return None
    maps = {"fluid": "Blues", "solid": "Oranges", "coupling": "Greys"}
    figure, axes = plt.subplots(layout="constrained", figsize=(10, 1.6 + 0.9 * len(bars)))
    whole = sum(sum(spent.values()) for spent in bars.values())
    for process, spent in bars.items():
        shades = plt.get_cmap(maps[process])(np.linspace(0.75, 0.3, len(spent) + 1)[:-1])
        start = 0
        for (name, seconds), shade in zip(spent.items(), shades):
            share = f"{process}: {name}, {seconds:.3g} s ({100 * seconds / whole:.1f} %)" if whole > 0 else name
            axes.barh(process, seconds, left=start, color=shade, edgecolor="white", label=share)
            start += seconds
        cpu = run.history.get(f"{process}/cpu_seconds")
        if cpu is not None:
            axes.plot([cpu[-1]] * 2, [list(bars).index(process) - 0.4, list(bars).index(process) + 0.4], "k:", lw=1.2)
            axes.annotate(" CPU", (cpu[-1], list(bars).index(process) - 0.38), fontsize=8, va="top")
    wall = run.summary.get("wall_seconds")
    until = f", wall {wall:.3g} s" if wall else ""
    axes.set(xlabel="seconds of wall time", title=f"{run.title}: until t = {run.time[-1]:.3f} s{until}")
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.05))
    return figure


def find_case_folder(run):
    """The case folder that the results name, or the one of this project with the same title."""
    if run.case_folder and Path(run.case_folder).is_dir():
        return Path(run.case_folder)
    for path in sorted(Path(__file__).resolve().parent.parent.glob("cases/*/case.toml")):
        if tomllib.loads(path.read_text()).get("title") == run.title:
            return path.parent
    return None


def main():
    parser = argparse.ArgumentParser(description="Pictures of a run.", epilog=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="of the results")
    parser.add_argument("--out", type=Path, help="where the pictures go; default: the folder itself")
    parser.add_argument("--case", type=Path, help="case folder with reference curves; default: the run's own")
    arguments = parser.parse_args()
    run = read_run(arguments.folder)
    out = arguments.out or arguments.folder
    out.mkdir(parents=True, exist_ok=True)
    case_folder = arguments.case or find_case_folder(run)
    pictures = {"snapshots": snapshots(run), "tip": tip(run, case_folder), "front": front(run, case_folder),
                "pressure": pressure(run), "level": level(run), "energy": energy(run), "timing": timing(run)}
    for name, figure in pictures.items():
        if figure is not None:
            figure.savefig(out / f"{name}.png")
            print(out / f"{name}.png")


if __name__ == "__main__":
    main()
