#!/usr/bin/python3
"""Cost of a window of the dam break on the elastic plate by phase, at four spacings.

Usage: benchmarks/step_cost.py [--windows N] [--threads N] [--csv FILE]

Runs build/release/bin/cosurge in three processes on an otherwise idle machine and reads summary.json.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
WINDOW = 5e-5  # s: allowed at all spacings
# Spacing [m] and further settings: a column of 146 mm is not a multiple of 4 mm.
SPACINGS = [(0.004, ["fluid.water.0.max=[0.144, 0.292]"]), (0.002, []), (0.001, []), (0.0005, [])]


def measure(spacing, extra, windows, threads):
    """Wall and phase seconds per window [s] of `windows` windows from the start."""
    with tempfile.TemporaryDirectory() as folder:
        end = windows * WINDOW
        command = [ROOT / "build/release/bin/cosurge", "run", ROOT / "cases/dam_break_plate", "--out", folder,
                   "--threads", str(threads), "--set", f"fluid.spacing={spacing}", f"time.window={WINDOW}",
                   "time.stepping=fixed", f"time.end={end}", f"output.frame_interval={end}", *extra]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    fluid = summary["participants"]["fluid"]
    solid = summary["participants"]["solid"]
    phases = {name: seconds / windows for name, seconds in fluid["seconds"]["phases"].items()}
    solid_seconds = sum(solid["seconds"]["phases"].values()) / windows
    return {
        "spacing_m": spacing,
        "particles": fluid["particles"],
        "threads": threads,
        "window_s": summary["wall_seconds"] / windows,
        "ppe_solve_s": phases["ppe_solve"],
        "ppe_assembly_s": phases["ppe_assembly"],
        "neighbors_s": phases["neighbors"],
        "rest_of_fluid_s": phases["density"] + phases["gradient"] + phases["predict"],
        "solid_s": solid_seconds,
        "exchange_s": summary["exchange_seconds"] / windows,
        "fluid_cpu_s": fluid["seconds"]["cpu"] / windows,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--windows", type=int, default=100)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--csv", default="-", help="file to write, - for the terminal")
    options = parser.parse_args()
    rows = [measure(spacing, extra, options.windows, options.threads) for spacing, extra in SPACINGS]
    out = sys.stdout if options.csv == "-" else open(options.csv, "w", newline="")
    out.write(f"# benchmarks/step_cost.py --windows {options.windows} --threads {options.threads}\n")
    writer = csv.DictWriter(out, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})


if __name__ == "__main__":
    main()
