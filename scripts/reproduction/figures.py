"""The paper's figures from our runs, each a PNG."""
import h5py
import numpy as np

import measures
from plots import recorded, snapshots
from plots.histories import reference_curves
from plots.low_pass import CUT_OFF, low_passed
from plots.style import plt
from runs import STIFFNESS

COLORS = dict(zip(STIFFNESS, plt.get_cmap("viridis")(np.linspace(0, 0.85, len(STIFFNESS) - 1)).tolist() + ["black"]))


class Frames:
    """Particles of a run at chosen times; a run as the pictures of plots take it."""

    def __init__(self, folder, times):
        run = recorded.read_run(folder)
        self.case, self.title = run.case, run.title
        with h5py.File(folder / "results.h5") as file:
            instants = file["frames/time"][:]
            chosen = [int(np.abs(instants - t).argmin()) for t in times if t <= instants[-1] + 0.02]
            self.frames = [{"time": instants[k], **{
                name: {array: group[array][k] for array in group}
                for name, group in file["frames"].items() if isinstance(group, h5py.Group)}} for k in chosen]
        fluid, solid = self.case["fluid"], self.case["solid"]
        self.spacing = {"fluid": fluid["spacing"], "solid": solid.get("spacing", fluid["spacing"])}


def window(axes):
    axes.set(xlim=(-0.02, 0.604), ylim=(-0.02, 0.42), aspect="equal")
    axes.grid(False)
    axes.tick_params(length=2, labelsize=7)


def fig2_snapshots(folder):
    """Water by pressure and the plate at the paper's six instants."""
    frames = Frames(folder, (0.16, 0.26, 0.34, 0.42, 0.62, 0.80))
    figure, grid = plt.subplots(2, 3, layout="constrained", figsize=(11, 5.8), sharex=True, sharey=True)
    for axes in grid.flat:
        window(axes)
    figure.canvas.draw()
    for axes, frame in zip(grid.flat, frames.frames):
        image = snapshots.draw_frame(frames, axes, frame, frames.spacing, 3.0)
    figure.colorbar(image, ax=grid, label="pressure [kPa]", shrink=0.8, extend="max")
    return figure


def fig3_tip(histories, case_folder):
    """Tip over the published curves; `histories` by label."""
    figure, axes = plt.subplots(layout="constrained", figsize=(9, 5))
    for k, (name, (t, x)) in enumerate(reference_curves(case_folder, ["t_s", "ux_m"]).items()):
        axes.plot(t, 1000 * x, lw=0.8, alpha=0.6, color=plt.get_cmap("tab10").colors[k % 10], label=name)
    for style, (label, history) in zip(("-", "--", ":", "-."), histories.items()):
        axes.plot(history.time, 1000 * history.tip, "k" + style, lw=1.6, label=label)
    axes.axhline(39, color="0.6", lw=0.8)
    axes.annotate("the paper's largest, 39 mm", (1.2, 39.5), fontsize=8, color="0.4")
    axes.set(xlabel="t [s]", ylabel="displacement of the tip [mm]", xlim=(0, 2))
    axes.legend(fontsize=7, ncols=2)
    return figure


def fig4_spectrum(history, name="P01"):
    """Raw and filtered pressure, and the single-sided spectrum of the raw one."""
    times, raw = history.even(name)
    figure, (left, right) = plt.subplots(1, 2, layout="constrained", figsize=(11, 3.8), width_ratios=(2, 1))
    left.plot(times * measures.RATE, raw, color="#9ec5e8", lw=0.5, label="raw")
    left.plot(times * measures.RATE, low_passed(raw, 1 / measures.STEP), color="#123f6d", lw=1.3, label="below 70 Hz")
    left.set(xlabel="tau", ylabel="Cp", ylim=(-0.2, 3))
    left.legend()
    amplitude = 2 * np.abs(np.fft.rfft(raw)) / len(raw)
    right.plot(np.fft.rfftfreq(len(raw), measures.STEP), amplitude, color="#123f6d", lw=0.8)
    right.axvline(CUT_OFF, color="0.5", ls=":")
    right.set(xlabel="f [Hz]", ylabel="amplitude of Cp", xlim=(0, 200))
    return figure


def fig6_filtered(histories, name):
    """Filtered pressure for every stiffness, the rigid plate behind each."""
    figure, grid = plt.subplots(2, 3, layout="constrained", figsize=(12, 6), sharex=True, sharey=True)
    for axes, (label, history) in zip(grid.flat, histories.items()):
        if "rigid" in histories and label != "rigid":
            times, raw = histories["rigid"].even(name)
            axes.plot(times * measures.RATE, low_passed(raw, 1 / measures.STEP), color="0.75", lw=0.9, label="rigid")
        times, raw = history.even(name)
        axes.plot(times * measures.RATE, low_passed(raw, 1 / measures.STEP), color=COLORS[label], lw=1.2, label=label)
        axes.legend(fontsize=8)
    for axes in grid[-1]:
        axes.set_xlabel("tau")
    for axes in grid[:, 0]:
        axes.set_ylabel(f"Cp, {name}")
    return figure


def fig8_impulses(numbers):
    """Pressure impulse over Young's modulus, the rigid plate as a line."""
    figure, grid = plt.subplots(1, 2, layout="constrained", figsize=(10, 3.6))
    for axes, name in zip(grid, ("P01", "P02")):
        elastic = [(STIFFNESS[label], row[f"{name}_impulse"]) for label, row in numbers.items()
                   if STIFFNESS[label] and not np.isnan(row[f"{name}_impulse"])]
        if elastic:
            axes.semilogx(*zip(*elastic), "ko-", mfc="none", label="elastic")
        if "rigid" in numbers:
            axes.axhline(numbers["rigid"][f"{name}_impulse"], color="tab:blue", label="rigid")
        axes.set(xlabel="E [Pa]", ylabel=f"C_I, {name}")
        axes.legend()
    return figure


def fig9_tips(histories, numbers):
    """Tip over the plate's thickness: histories, and largest values over Young's modulus."""
    figure, (left, right) = plt.subplots(1, 2, layout="constrained", figsize=(11, 4))
    elastic = [label for label in histories if STIFFNESS[label]]
    for label in elastic:
        history = histories[label]
        left.plot(history.tau, history.tip / measures.THICKNESS, color=COLORS[label], lw=1, label=label)
    left.set(xlabel="tau", ylabel="tip / e")
    left.legend(fontsize=8)
    moduli = np.array([STIFFNESS[label] for label in elastic])
    largest = np.array([numbers[label]["tip_over_thickness"] for label in elastic])
    right.loglog(moduli, largest, "ko-", mfc="none", label="ours")
    right.loglog(moduli, largest[0] * moduli[0] / moduli, "k:", lw=0.8, label="1 / E")
    right.axhline(0.35, color="0.6", lw=0.8)
    right.annotate("the paper at 20 MPa: about 0.35", (1e8, 0.38), fontsize=8, color="0.4")
    right.set(xlabel="E [Pa]", ylabel="largest tip / e")
    right.legend()
    return figure


def fig10_speeds(folders):
    """Water by |v| / sqrt(g H) at tau = 0.81, 2.43 and 3.13 for every stiffness."""
    times = [tau / measures.RATE for tau in (0.81, 2.43, 3.13)]
    figure, grid = plt.subplots(len(folders), 3, squeeze=False, layout="constrained",
                                figsize=(10, 2.5 * len(folders)), sharex=True, sharey=True)
    for axes in grid.flat:
        window(axes)
    figure.canvas.draw()
    image = None
    for row, (label, folder) in zip(grid, folders.items()):
        frames = Frames(folder, times)
        for axes, frame in zip(row, frames.frames):
            fluid = frame["fluid"]
            water = fluid["kind"] == 0
            wall = np.isin(fluid["kind"], snapshots.WALL_KINDS)
            speed = np.linalg.norm(fluid["velocity"][water], axis=1) / measures.SPEED
            snapshots.dots(axes, fluid["position"][wall], frames.spacing["fluid"], 1.6, color=snapshots.WALL_COLOR)
            image = snapshots.dots(axes, fluid["position"][water], frames.spacing["fluid"], c=speed, cmap="jet",
                                   vmin=0, vmax=2)
            snapshots.dots(axes, frame["solid"]["position"], frames.spacing["solid"], 1.4, color=snapshots.SOLID_COLOR)
            axes.set_title(f"{label}, tau = {frame['time'] * measures.RATE:.2f}", fontsize=8)
    figure.colorbar(image, ax=grid, label="|v| / sqrt(g H)", shrink=0.5, extend="max")
    return figure


def convergence(rows):
    """Largest displacement of the tip over the spacing; `rows`: settings, {spacing [mm]: numbers}."""
    figure, axes = plt.subplots(layout="constrained", figsize=(6, 4))
    for marker, (settings, by_spacing) in zip("osd^", rows.items()):
        axes.plot(list(by_spacing), [1000 * row["tip_peak_m"] for row in by_spacing.values()], marker + "-", mfc="none",
                  label=settings)
    axes.axhspan(41, 49, color="0.9", label="published")
    axes.axhline(39, color="tab:red", lw=0.8, label="the paper")
    axes.set(xlabel="spacing [mm]", ylabel="largest tip displacement [mm]", xlim=(0, None))
    axes.legend(fontsize=8)
    return figure


def swapped(histories):
    """Tips of one scene with each model of the structure."""
    figure, axes = plt.subplots(layout="constrained", figsize=(8, 4))
    for label, history in histories.items():
        axes.plot(history.time, 1000 * history.tip, lw=1.2, label=label)
    axes.set(xlabel="t [s]", ylabel="displacement of the tip [mm]", title="20 MPa, 2 mm", xlim=(0.1, None))
    axes.legend()
    return figure
