#!/usr/bin/python3
"""Impacts and loads against theory and experiment, with default settings: a table of docs/verification.md.

Usage: benchmarks/impacts.py [SCENE...] [--threads N] [--csv FILE]

A SCENE is a folder of cases/validation; all of them by default. Runs build/release/bin/cosurge. Finished runs are kept in
build/accuracy and not repeated.
"""
import argparse
import csv
import json
import pathlib
import sys

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from study import Run, Study, core_seconds  # noqa: E402

RUNS = ROOT / "build/accuracy"
CASES = ROOT / "cases/validation"
G, RHO = 9.81, 1000.0

ANGLES = [10, 15, 20, 25, 30, 40]  # deadrise angles of the wedges [deg]


def table(path):
    """Rows of a CSV file with a header and comments, as dictionaries of numbers."""
    lines = [line for line in (CASES / path).read_text().splitlines() if not line.startswith("#")]
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]


SIMILARITY = {row["deadrise_deg"]: (row["F"], row["Cpmax"]) for row in table("similarity.csv")}


class Results:
    """Histories and frames of a run."""

    def __init__(self, folder):
        self.file = h5py.File(folder / "results.h5")
        self.case = json.loads(self.file.attrs["case"])
        self.time = self.file["history/time"][:]
        self.spacing = self.case["fluid"]["spacing"]

    def of(self, column):
        return self.file[f"history/fluid/{column}"][:]

    def impulse(self, column, begin, end):
        """Integral over time of a force between two times: each value belongs to the window that it ends."""
        size = np.diff(self.time, prepend=0)
        inside = (self.time > begin) & (self.time <= end * (1 + 1e-9))
        return np.sum(self.of(column)[inside] * size[inside])


def scatter(values):
    """Standard deviation of what is left of a history after a parabola, over its mean."""
    k = np.arange(len(values))
    return np.std(values - np.polyval(np.polyfit(k, values, 2), k)) / np.mean(values)


def wedge(angle):
    """Force and largest pressure coefficient while the wetted half-width grows from 24 to 40 spacings; noise of two
    gauges in the water beside."""
    speed = 5.0

    def read(run):
        force, peak = SIMILARITY[angle]
        end = run.time[-1]
        late = run.time > 0.6 * end
        slope = np.tan(np.radians(angle))
        buoyancy = RHO * G * (speed * run.time)**2 / slope
        measured = np.mean((run.of("F_y") - buoyancy)[late] / (RHO * speed**3 * run.time[late]))
        rows = [("force / (rho V^3 t)", measured, force), ("largest Cp", largest_coefficient(run, slope, speed), peak)]
        rows += [(f"noise of gauge {name}", scatter(run.of(name)[late]), None) for name in ("deep", "side")]
        return rows

    return read


def largest_coefficient(run, slope, speed):
    """Mean over the later frames of the largest Cp on the face: of the wall's particles behind it, by height, mean of both sides,
    over three neighbours."""
    frames = run.file["frames"]
    time, kind, start = frames["time"][:], frames["fluid/kind"][0], frames["fluid/position"][0]
    apex = np.array([1.0, 0.8])
    depth = (start[:, 1] - apex[1] - np.abs(start[:, 0] - apex[0]) * slope) / np.hypot(1, slope)
    face = np.where((kind == 1) & (np.abs(depth - 0.5 * run.spacing) < 0.1 * run.spacing) & (start[:, 1] > apex[1]))[0]
    bins = np.round(np.abs(start[face, 0] - apex[0]) / run.spacing - 0.5).astype(int)
    peaks = []
    for n in np.where(time > 0.6 * run.time[-1])[0]:
        p = frames["fluid/pressure"][n][face]
        profile = np.array([p[bins == b].mean() for b in np.unique(bins)])
        peaks.append(np.convolve(profile, np.ones(3) / 3, "valid").max())
    return np.mean(peaks) / (0.5 * RHO * speed**2)


def cylinder(run):
    """Slamming coefficient F / (rho V^2 R), at three depths of submergence; the fit as in DNV-RP-C205."""
    speed, radius = 5.0, 0.1
    rows = []
    for depth in (0.1, 0.2, 0.4):  # over the diameter
        near = np.abs(run.time * speed / (2 * radius) - depth) < 0.1 * depth
        measured = np.mean(run.of("F_y")[near]) / (RHO * speed**2 * radius)
        rows.append((f"slamming coefficient at {depth} D", measured, 5.15 / (1 + 19 * depth) + 0.55 * depth))
    return rows


def sudden_impulse(run, column):
    """Integral of a force that a sudden motion at the start causes, without the force that stays after it: the mean of the last
    quarter."""
    end = run.time[-1]
    return run.impulse(column, 0, end) - 4 * run.impulse(column, 0.75 * end, end)


def sudden(column, sign, speed, scale, reference, what):
    """Impulse of a sudden motion over rho times speed times `scale`."""
    def read(run):
        return [(what, sign * sudden_impulse(run, column) / (RHO * speed * scale), reference)]
    return read


def chwang():
    """Impulse on a vertical wall that is set in motion, over rho V H^2 (Chwang 1978): 16 / pi^3 sum 1 / (2 n - 1)^3."""
    return 16 / np.pi**3 * np.sum(1 / np.arange(1, 20001, 2.0)**3)


def pressure_impulse(share, length, low, high):
    """Impulse over rho V H^2 on a part of the wall between two heights, where the upper `share` of it is hit at V (Cooker &
    Peregrine 1995): the potential of the sudden motion, zero at the surface, at rest at the floor and at `length` H."""
    y = np.linspace(low, high, 2001)
    total = np.zeros_like(y)
    for n in range(1, 4001):
        k = (n - 0.5) * np.pi
        amplitude = 2 * (1 - np.cos(share * k)) / k**2 / np.tanh(k * length)
        total += amplitude * np.sin(k * (1 - y))
    return np.trapz(total, y)


def upper_wall(run):
    speed, depth = 0.5, 0.2
    rows = []
    for name, low, high in (("lower", 0.0, 0.5), ("upper", 0.5, 1.0)):
        measured = -sudden_impulse(run, f"{name}_x") / (RHO * speed * depth**2)
        rows.append((f"impulse on the {name} half / (rho V H^2)", measured, pressure_impulse(0.5, 2.0, low, high)))
    return rows


def added_mass(reference, area):
    """Least squares of the force along x on acceleration and velocity, over whole periods after the ramp."""
    def read(run):
        omega, amplitude = 2 * np.pi * 4.0, 0.004
        late = run.time > 0.25
        t, force = run.time[late], run.of("F_x")[late]
        motion = np.column_stack([-omega**2 * amplitude * np.sin(omega * t), omega * amplitude * np.cos(omega * t), np.ones_like(t)])
        mass = -np.linalg.lstsq(motion, force, rcond=None)[0][0]
        return [("added mass / (rho A)", mass / (RHO * area), reference)]
    return read


def steady(column, reference, what, begin):
    def read(run):
        return [(what, np.mean(run.of(column)[run.time > begin]), reference)]
    return read


def triangle(run):
    late = run.time > 0.4
    buoyancy = RHO * G * 0.5 * 0.16 * 0.1
    return [("buoyancy [N/m]", np.mean(run.of("F_y")[late]), buoyancy),
            ("its lever about the left corner [m]", np.mean(run.of("M")[late]) / np.mean(run.of("F_y")[late]), 0.08)]


def floating(run):
    keel = run.file["history/solid/keel_y"][:] + 0.36
    late = run.time > 2.0
    level = np.mean(run.of("level")[late])
    return [("draught [mm]", 1e3 * (level - np.mean(keel[late])), 50.0)]


def wall_impact(run):
    """Raw peaks at the sensors 1, 2 and 3, over rho g H, against the medians of 100 repetitions."""
    rows = []
    for sensor in table("dam_break_wall/peaks.csv")[:3]:
        low, high = sensor["p2.5_pstar"], sensor["p97.5_pstar"]
        peak = run.of(f"s{sensor['sensor']:.0f}").max() / (997 * G * 0.3)
        rows.append((f"peak at {sensor['z_mm']:.0f} mm / (rho g H); 95 % of the experiments: {low:.2f} to {high:.2f}", peak,
                     sensor["median_pstar"]))
    return rows


def rolling_tank(run):
    """Mean of the second to fourth impact on the left wall, against that of 102 repetitions. (The first depends on how the motion
    began.)"""
    repetitions = np.array([list(row.values())[-4:] for row in table("rolling_tank_impact/peaks.csv")]) * 100
    period, pressure, peaks = 1.6295, run.of("left"), []
    first = run.time[np.argmax(pressure > 1000)]
    for n in range(1, 4):
        near = np.abs(run.time - first - n * period) < 0.4 * period
        peaks.append(pressure[near].max())
    scatter_of_mean = np.std(repetitions[:, 1:]) / 100
    return [(f"peaks 2 to 4, mean [Pa]; one peak scatters by {100 * scatter_of_mean:.0f} Pa", np.mean(peaks),
             np.mean(repetitions[:, 1:]))]


def elastic_wedge(run):
    """Deflection of the middle of a side, across it and relative to the falling edges, against Wagner's theory."""
    slope, speed = np.radians(10), 30.0
    solid = run.file["history/solid"]
    deflection = (solid["B_y"][:] + speed * run.time) * np.cos(slope) - solid["B_x"][:] * np.sin(slope)
    theory = table("elastic_wedge/deflection.csv")
    at = [row["t_s"] for row in theory], [row["w_m"] for row in theory]
    return [(f"deflection at {1e3 * t:.1f} ms [mm]", 1e3 * np.interp(t, run.time, deflection), 1e3 * np.interp(t, *at))
            for t in (0.001, 0.0014, 0.0018)]


def wedge_drop(run):
    """Largest force on 0.2 m, over 1 ms, against a nonlinear computation; the test section is 23 % lower because of its ends."""
    force = 0.2 * run.of("F_y")
    means = [np.mean(force[np.abs(run.time - t) < 5e-4]) for t in run.time[run.time > 0.005]]
    measured, computed = (max(row[name] for row in table("wedge_drop/force.csv")) for name in ("F_measured_N", "F_computed_N"))
    return [(f"largest force on 0.2 m [N]; measured: {measured:.0f}", max(means), computed)]


def elastic_gate(run):
    """Largest displacements of the free end, against the experiment."""
    solid = run.file["history/solid"]
    tip = table("elastic_gate/tip.csv")
    return [(f"largest u{axis} of the free end [mm]", 1e3 * solid[f"tip_{axis}"][:].max(), 1e3 * max(row[f"u{axis}_m"] for row in tip))
            for axis in "xy"]


SCENES = {f"wedge_{angle}": (wedge(angle), "similarity solution (Zhao & Faltinsen 1993)") for angle in ANGLES}
SCENES |= {
    "cylinder_entry": (cylinder, "fit to experiments (Campbell & Weynberg 1980)"),
    "plate_start": (sudden("F_y", 1, 0.5, 0.1**2, np.pi / 2, "impulse / (rho V a^2)"), "potential flow, pi / 2 (von Karman 1929)"),
    "piston_start": (sudden("F_x", -1, 0.5, 0.2**2, chwang(), "impulse / (rho V H^2)"),
                     "potential flow (Chwang 1978)"),
    "pressure_impulse": (upper_wall, "pressure impulse (Cooker & Peregrine 1995)"),
    "cylinder_mass": (added_mass(1.0, np.pi * 0.05**2), "potential flow (Lamb 1932)"),
    "square_mass": (added_mass(1.1885, 0.1**2), "potential flow (Wendel 1956)"),
    "elastic_wedge": (elastic_wedge, "Wagner's theory with the modes of a beam (Scolan 2004)"),
    "wedge_drop": (wedge_drop, "nonlinear computation (Zhao, Faltinsen & Aarsnes 1996)"),
    "elastic_gate": (elastic_gate, "experiment (Antoci et al. 2007)"),
    "triangle_at_rest": (triangle, "Archimedes"),
    "floating_box": (floating, "Archimedes"),
    "dam_break_wall": (wall_impact, "experiment (Lobovsky et al. 2014)"),
    "rolling_tank_impact": (rolling_tank, "experiment (Souto-Iglesias & Botia-Vera 2011)"),
    "buoyancy_5": (steady("F_y", 98.1, "buoyancy [N/m]", 0.5), "Archimedes"),
    "buoyancy_10": (steady("F_y", 98.1, "buoyancy [N/m]", 0.5), "Archimedes"),
    "buoyancy_20": (steady("F_y", 98.1, "buoyancy [N/m]", 0.5), "Archimedes"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="*", choices=[[], *SCENES], default=[])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--csv", type=pathlib.Path)
    arguments = parser.parse_args()
    study = Study(RUNS, threads=arguments.threads)
    rows = []
    for name in arguments.scene or SCENES:
        read, source = SCENES[name]
        one = Run(f"validation_{name}", f"validation/{name}", {})
        study.execute([one])
        results = Results(study.folder_of(one))
        cost = core_seconds(study.summary(one))
        for quantity, value, reference in read(results):
            off = "" if reference is None else f"{100 * (value / reference - 1):+.1f} %"
            rows.append([name, quantity, f"{value:.4g}", "" if reference is None else f"{reference:.4g}", off, source, f"{cost:.0f}"])
            print(" | ".join(rows[-1]), flush=True)
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            csv.writer(file).writerows([["scene", "quantity", "Cosurge", "reference", "difference", "source", "core seconds"], *rows])


if __name__ == "__main__":
    main()
