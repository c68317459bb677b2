#!/usr/bin/python3
"""Records the impact on the rigid plate of the dam break: the pressure on its face, for the tables of the solids.

Usage: benchmarks/impact.py > tests/support/impact.csv      (1 minute)

Runs build/release/bin/cosurge on cases/dam_break_rigid with probes over the whole face, nothing filtered.
"""
import pathlib
import subprocess
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEIGHTS = [0.005 + 0.01 * k for k in range(8)]  # m
# From just before the arrival of the front until after the largest moment about the foot, in windows of 0.1 ms.
TIMES = 0.124 + 1e-4 * np.arange(801)  # s


def main():
    probes = ", ".join(f'{{ name = "p{k}", quantity = "pressure", position = [0.292, {height:.3f}] }}'
                       for k, height in enumerate(HEIGHTS))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([ROOT / "build/release/bin/cosurge", "run", ROOT / "cases/dam_break_rigid", "--out", folder,
                        "--set", "time.end=0.205", "time.window=1e-4", "fluid.courant=0.3", "fluid.propagation_speed=1",
                        f"output.probe=[{probes}]"],
                       check=True, stdout=subprocess.DEVNULL)
        with h5py.File(pathlib.Path(folder) / "results.h5") as run:
            time = run["history/time"][:]
            pressures = [np.interp(TIMES, time, run[f"history/fluid/p{k}"][:]) for k in range(len(HEIGHTS))]
    print("# benchmarks/impact.py")
    print("# pressure [Pa] on the plate's face at heights [m] of the first line, at times [s] of the first column")
    print(",".join(["0"] + [f"{height:.3f}" for height in HEIGHTS]))
    for row in zip(TIMES, *pressures):
        print(",".join([f"{row[0]:.4f}"] + [f"{p:.0f}" for p in row[1:]]))


if __name__ == "__main__":
    main()
