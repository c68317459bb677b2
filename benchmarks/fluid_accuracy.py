#!/usr/bin/python3
"""Accuracy and cost of the water: tables of docs/verification.md.

Usage: benchmarks/fluid_accuracy.py TABLE [--threads N] [--csv FILE]

TABLE is one of
  hydrostatic  water at rest for 5 s: pressure on the walls, kinetic energy, drift of the level, density at the floor
  noise        dam break on a rigid plate, 2 mm: noise of the pressure on it for each source and window
  convergence  dam break on a rigid plate, 8, 4, 2 and 1 mm: arrival of the front and impulse on the plate, with observed orders
  wave         standing wave in a tank of 1 m x 0.5 m of water, 1/40 to 1/320 m: period and decay, with observed orders
  soft         dam break on a rigid plate, 2 mm: what the soft water of public codes gains and costs

Runs build/release/bin/cosurge. Finished runs are kept in build/accuracy and not repeated.
"""
import argparse
import csv
import hashlib
import json
import pathlib
import sys

import h5py
import numpy as np
from scipy.optimize import curve_fit
from scipy.signal import butter, sosfiltfilt

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from study import Run, Study, core_seconds  # noqa: E402

RUNS = ROOT / "build/accuracy"
GRAVITY, DENSITY = 9.81, 1000.0
CUT_OFF = 70.0  # [Hz] low-pass filter for impact pressures, as in Amaro & Cheng
THEORY = 1.1818  # s, period of the standing wave: omega^2 = g k tanh(k h), k = pi / 1 m, h = 0.5 m
SOURCES = [("deviation", "p_min"), ("mixed", "corrected"), ("time_scale", "corrected")]  # with the gradient that suits


def run(case, settings, threads):
    """Folder and summary of the run of `case` with `settings` ({key: value}), finished or failed."""
    words = " ".join(f"{key}={value}" for key, value in settings.items())
    one = Run(f"{case}_{hashlib.sha1(words.encode()).hexdigest()[:12]}", case, settings)
    study = Study(RUNS, threads=threads)
    if study.summary(one) is None:
        print(f"{case} {words}", file=sys.stderr, flush=True)
    study.execute([one])
    return study.folder_of(one), study.summary(one) or {"status": "failed"}


def wall_error(file, frame, water, spacing):
    """Root mean square of P - rho g (H - y) over rho g H on the walls that water stands against, up to two spacings
    below the surface."""
    x, p, kind = (file[f"frames/fluid/{name}"][frame] for name in ("position", "pressure", "kind"))
    (left, _), (right, depth) = water
    beside = (kind == 1) & (x[:, 0] > left - spacing) & (x[:, 0] < right + spacing) & (x[:, 1] < depth - 2 * spacing)
    error = p[beside] - DENSITY * GRAVITY * (depth - x[beside, 1])
    return np.sqrt(np.mean(error**2)) / (DENSITY * GRAVITY * depth)


def volume(file, frame, spacing, low, high):
    """Area of the box over that of the water in it, each particle a cell of l0 x l0: 1 where the water has its density,
    more where it has swollen."""
    x, kind = (file[f"frames/fluid/{name}"][frame] for name in ("position", "kind"))
    sides = np.minimum(x[kind == 0] + spacing / 2, high) - np.maximum(x[kind == 0] - spacing / 2, low)
    return np.prod(np.subtract(high, low)) / np.prod(np.clip(sides, 0, None), axis=1).sum()


def hydrostatic(threads):
    for source, gradient in SOURCES:
        settings = {"fluid.source": source, "fluid.gradient": gradient, "time.end": 5,
                    "output.frame_interval": 0.05}
        folder, summary = run("hydrostatic", settings, threads)
        row = {"source": source, "gradient": gradient, "status": summary["status"]}
        if summary["status"] == "finished":
            with h5py.File(folder / "results.h5") as file:
                case = json.loads(file.attrs["case"])["fluid"]
                water = case["water"][0]["min"], case["water"][0]["max"]
                errors = [wall_error(file, k, water, case["spacing"]) for k in range(len(file["frames/time"]))]
                history = {name: file[f"history/fluid/{name}"][:] for name in ("kinetic_energy", "gravity_energy")}
                after = file["history/time"][:] > 4
                rms = lambda a, b: np.sqrt(np.mean(np.square(errors[round(a / 0.05):round(b / 0.05) + 1])))
                row |= {
                    "wall_rms_1_to_2_s": rms(1, 2), "wall_rms_4_to_5_s": rms(4, 5),
                    "kinetic_over_weight_energy_4_to_5_s":
                        history["kinetic_energy"][after].mean() / history["gravity_energy"][0],
                    "level_drift": history["gravity_energy"][after].mean() / history["gravity_energy"][0] - 1,
                    "volume": volume(file, -1, case["spacing"], (water[0][0], 0), (water[1][0], 0.9 * water[1][1])),
                }
            row["core_s"] = core_seconds(summary)
        yield row


def impact(folder):
    """Measures of the dam break on the plate."""
    with h5py.File(folder / "results.h5") as file:
        case = json.loads(file.attrs["case"])
        plate = case["solid"]["body"][0]["box"]["min"][0]
        time = file["history/time"][:]
        front = file["history/fluid/front"][:]
        p = file["history/fluid/P01"][:]
        frame = int(np.searchsorted(file["frames/time"][:], 0.1 - 1e-9))
        swollen = volume(file, frame, case["fluid"]["spacing"], (0.012, 0.012), (0.1, 0.06))
        force = file["history/coupling/force_x"][:]
    even = np.arange(time[0], time[-1], 2e-5)
    p_even = np.interp(even, time, p)
    low = sosfiltfilt(butter(4, CUT_OFF, fs=1 / 2e-5, output="sos"), p_even)
    wet = even > 0.14
    within = time < 0.3
    return {
        "front_s": time[np.argmax(front >= plate - 0.5e-3)], "P01_peak_raw_Pa": p.max(), "P01_peak_70Hz_Pa": low.max(),
        "noise": np.sqrt(np.mean((p_even - low)[wet]**2)) / low.max(),
        "impulse_P01_to_0.3s_Pa_s": np.trapezoid(p[within], time[within]) if hasattr(np, "trapezoid")
        else np.trapz(p[within], time[within]),
        "impulse_plate_to_0.3s_N_s": np.sum(force[within] * np.diff(time, prepend=0)[within]),
        "volume_0.1s": swollen,
    }


def dam_break(settings, threads):
    """Row of a dam break on the rigid plate to 0.35 s."""
    folder, summary = run("dam_break_rigid", settings | {"time.end": 0.35, "output.frame_interval": 0.05}, threads)
    row = {"status": summary["status"]}
    if summary["status"] == "finished":
        row |= impact(folder) | {"windows": summary["windows"], "core_s": core_seconds(summary)}
    return row


def noise(threads):
    for source, gradient in SOURCES:
        for window in (1e-4, 5e-5, 2e-5):
            settings = {"fluid.source": source, "fluid.gradient": gradient, "time.window": window,
                        "time.stepping": "fixed"}
            yield {"source": source, "gradient": gradient, "window_s": window} | dam_break(settings, threads)


def convergence(threads):
    # A column and a plate that all four spacings divide; the plate is thicker than the others, which rigid it may be.
    scene = {"fluid.water.0.max": "[0.144, 0.288]", "fluid.tank.max": "[0.576, 1.152]",
             "solid.body.0.box": "{ min = [0.288, 0.0], max = [0.32, 0.08] }",
             "solid.body.0.clamp": "[{ min = [0.288, -0.04], max = [0.32, 0.0] }]",
             "output.probe": '[{ name = "P01", quantity = "pressure", position = [0.288, 0.012] }]'}
    for source, gradient in SOURCES:
        rows = []
        for spacing in (0.008, 0.004, 0.002, 0.001):
            settings = scene | {"fluid.source": source, "fluid.gradient": gradient, "fluid.spacing": spacing,
                                "time.window": spacing * 0.05, "time.stepping": "fixed"}
            row = {"source": source, "gradient": gradient, "spacing_m": spacing} | dam_break(settings, threads)
            rows.append(row)
            for name in ("front_s", "impulse_P01_to_0.3s_Pa_s", "impulse_plate_to_0.3s_N_s"):
                row[f"order_{name}"] = observed_order([one.get(name, np.nan) for one in rows])
            yield row


def observed_order(values):
    """From the last three of values on spacings that halve: log2 of the ratio of their differences; nan of fewer."""
    if len(values) < 3:
        return np.nan
    coarse, middle, fine = values[-3:]
    return np.log2(abs(coarse - middle) / abs(middle - fine)) if middle != fine else np.nan


def damped_wave(time, height):
    """Period [s] and decay [1/s] of a cos(w t + p) exp(-d t) fitted to the history from its first quarter on."""
    late = time > 0.25 * THEORY
    shape = lambda t, a, d, w, p: a * np.exp(-d * t) * np.cos(w * t + p)
    (_, decay, omega, _), _ = curve_fit(shape, time[late], height[late], p0=[0.05, 0.1, 2 * np.pi / THEORY, 0])
    return 2 * np.pi / omega, decay


def wave(threads):
    for source, gradient in SOURCES:
        rows = []
        for spacing in (0.025, 0.0125, 0.00625, 0.003125):
            settings = {"fluid.source": source, "fluid.gradient": gradient, "fluid.spacing": spacing,
                        "fluid.tank.max": "[1.0, 0.8]", "time.window": spacing / 12.5}
            folder, summary = run("standing_wave", settings, threads)
            row = {"source": source, "gradient": gradient, "spacing_m": spacing, "status": summary["status"]}
            if summary["status"] == "finished":
                with h5py.File(folder / "results.h5") as file:
                    left, right = file["history/fluid/left"][:], file["history/fluid/right"][:]
                    period, decay = damped_wave(file["history/time"][:], left - right)
                    weight = file["history/fluid/gravity_energy"][:]
                row |= {"period_s": period, "period_error": period / THEORY - 1, "decay_per_s": decay,
                        "level_drift": weight[-len(weight) // 10:].mean() / weight[0] - 1,
                        "core_s": core_seconds(summary)}
            rows.append(row)
            row["order_period_s"] = observed_order([one.get("period_s", np.nan) for one in rows])
            yield row


def soft(threads):
    for gamma, alpha in ((0.01, 1e-9), (0.01, 1e-8), (0.01, 1e-7), (0.01, 1e-6), (0.2, 1e-9)):
        settings = {"fluid.source": "deviation", "fluid.gradient": "p_min", "fluid.gamma": gamma,
                    "fluid.compressibility": alpha}
        yield {"gamma": gamma, "alpha_per_Pa": alpha} | dam_break(settings, threads)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", choices=["hydrostatic", "noise", "convergence", "wave", "soft"])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--csv", default="-", help="file to write, - for the terminal")
    options = parser.parse_args()
    rows = list(globals()[options.table](options.threads))
    names = list(dict.fromkeys(name for row in rows for name in row))
    out = sys.stdout if options.csv == "-" else open(options.csv, "w", newline="")
    out.write(f"# benchmarks/fluid_accuracy.py {options.table} --threads {options.threads}\n")
    writer = csv.DictWriter(out, names, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})


if __name__ == "__main__":
    main()
