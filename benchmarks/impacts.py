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

# F / (rho V^3 t) and largest Cp = p / (rho V^2 / 2): Zhao & Faltinsen 1993, table 1 (similarity solution).
SIMILARITY = {10: (213.980, 77.847), 15: (85.522, 33.271), 20: (42.485, 17.774), 25: (23.657, 10.691),
              30: (14.139, 6.927), 40: (5.477, 3.266)}


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
    """Slamming coefficient F / (rho V^2 R) by Campbell & Weynberg's fit to experiments, at three depths of submergence."""
    speed, radius = 5.0, 0.1
    rows = []
    for depth in (0.1, 0.2, 0.4):  # over the diameter
        near = np.abs(run.time * speed / (2 * radius) - depth) < 0.1 * depth
        measured = np.mean(run.of("F_y")[near]) / (RHO * speed**2 * radius)
        rows.append((f"slamming coefficient at {depth} D", measured, 5.15 / (1 + 9.5 * depth) + 0.275 * depth))
    return rows


def sudden(column, sign, speed, scale, reference, what, steady=0.0):
    """Impulse of a sudden motion over rho times speed times `scale`; `steady` is the force at rest."""
    def read(run):
        end = run.time[-1]
        impulse = sign * run.impulse(column, 0, end) - steady * end
        return [(what, impulse / (RHO * speed * scale), reference)]
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
    end = run.time[-1]
    rows = []
    for name, sign, low, high in (("lower", -1, 0.0, 0.5), ("upper", -1, 0.5, 1.0)):
        at_rest = RHO * G * depth**2 * ((1 - low)**2 - (1 - high)**2) / 2
        impulse = sign * run.impulse(f"{name}_x", 0, end) - at_rest * end
        rows.append((f"impulse on the {name} half / (rho V H^2)", impulse / (RHO * speed * depth**2),
                     pressure_impulse(0.5, 2.0, low, high)))
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


SCENES = {f"wedge_{angle}": (wedge(angle), "similarity solution (Zhao & Faltinsen 1993)") for angle in SIMILARITY}
SCENES |= {
    "cylinder_entry": (cylinder, "fit to experiments (Campbell & Weynberg 1980)"),
    "plate_start": (sudden("F_y", 1, 0.5, 0.1**2, np.pi / 2, "impulse / (rho V a^2)"), "potential flow, pi / 2 (von Karman 1929)"),
    "piston_start": (sudden("F_x", -1, 0.5, 0.2**2, chwang(), "impulse / (rho V H^2)", RHO * G * 0.2**2 / 2),
                     "potential flow (Chwang 1978)"),
    "pressure_impulse": (upper_wall, "pressure impulse (Cooker & Peregrine 1995)"),
    "cylinder_mass": (added_mass(1.0, np.pi * 0.05**2), "potential flow (Lamb 1932)"),
    "square_mass": (added_mass(1.1885, 0.1**2), "potential flow (Wendel 1956)"),
    "triangle_at_rest": (triangle, "Archimedes"),
    "floating_box": (floating, "Archimedes"),
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
