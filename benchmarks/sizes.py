#!/usr/bin/python3
"""Time and memory of a step of the water for different numbers of particles, in two and three dimensions.

Usage: benchmarks/sizes.py [--steps N] [--threads 1 2 ...] [--csv FILE]

A column collapses for N steps at a Courant number that is the same for all, solver and coupler in one process. Times are
of the steps alone: the water's processor time, and the wall's, of which only an idle machine speaks well. Memory is the
whole program's at its largest. Runs build/release/bin/cosurge.
"""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLANE = ("hydrostatic", {"fluid.tank": "{ min = [0.0, 0.0], max = [0.56, 0.56] }",
                         "fluid.water": "[{ min = [0.0, 0.0], max = [0.144, 0.288] }]"})
SPACE = ("dam_break_3d", {"fluid.tank": "{ min = [0.0, 0.0, 0.0], max = [0.56, 0.16, 0.56] }",
                          "fluid.water": "[{ min = [0.0, 0.0, 0.0], max = [0.144, 0.16, 0.288] }]",
                          "fluid.obstacle": "[]", "output.probe": "[]"})
SCENES = [(PLANE, 0.002), (PLANE, 0.001), (PLANE, 0.0005), (PLANE, 0.00025), (SPACE, 0.008), (SPACE, 0.004)]
COURANT = 0.05  # spacings over windows [m/s]


def measure(case, settings, spacing, steps, threads):
    """Row of one run."""
    window = spacing * COURANT
    words = settings | {"fluid.spacing": spacing, "time.window": window, "time.stepping": "fixed",
                        "time.end": steps * window, "output.frame_interval": steps * window}
    with tempfile.TemporaryDirectory() as folder:
        command = [ROOT / "build/release/bin/cosurge", "run", ROOT / "cases" / case, "--out", folder, "--in-process",
                   "--threads", str(threads), "--set", *(f"{key}={value}" for key, value in words.items())]
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status != 0:
            raise SystemExit(f"failed: {' '.join(map(str, command))}")
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    fluid = summary["participants"]["fluid"]
    phases = sum(fluid["seconds"]["phases"].values())
    return {"dimension": 3 if case.endswith("3d") else 2, "spacing_m": spacing, "particles": fluid["particles"],
            "threads": threads, "cpu_us_per_step_and_particle": fluid["seconds"]["cpu"] / steps / fluid["particles"] * 1e6,
            "wall_us_per_step_and_particle": phases / steps / fluid["particles"] * 1e6,
            "bytes_per_particle": usage.ru_maxrss * 1024 / fluid["particles"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--steps", type=int, default=40)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--csv", default="-", help="file to write, - for the terminal")
    options = parser.parse_args()
    rows = [measure(*scene, spacing, options.steps, threads) for scene, spacing in SCENES for threads in options.threads]
    out = sys.stdout if options.csv == "-" else open(options.csv, "w", newline="")
    out.write(f"# benchmarks/sizes.py --steps {options.steps} --threads {' '.join(map(str, options.threads))}\n")
    writer = csv.DictWriter(out, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})


if __name__ == "__main__":
    main()
