#!/usr/bin/python3
"""Draws the cost of a second of the plate of Amaro & Cheng with each solid model, from docs/tables/solid_cost.csv.

Usage: scripts/plot_solid_cost.py [FILE.png]     (docs/pictures/solid_cost.png by default)
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    picture = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs/pictures/solid_cost.png"
    with open(ROOT / "docs/tables/solid_cost.csv", encoding="utf-8") as table:
        rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
    figure, axes = plt.subplots(figsize=(7, 4.5), constrained_layout=True)
    for model, marker in (("mps", "o"), ("hamiltonian", "s"), ("fem", "^"), ("modal", "v")):
        points = [(float(row["young_modulus_Pa"]), float(row["cpu_seconds_per_s"])) for row in rows if row["model"] == model]
        axes.loglog(*zip(*points), marker=marker, label=model)
    axes.axhline(1, color="0.6", linewidth=0.8)
    axes.text(4e10, 1.1, "real time", color="0.4", fontsize=8)
    axes.set_xlabel("Young's modulus [Pa]")
    axes.set_ylabel("CPU seconds for one second of motion")
    axes.set_title("Plate of 12 x 80 mm, 12 particles thick, windows of 0.2 ms, one core", fontsize=10)
    axes.grid(True, which="major", alpha=0.3)
    axes.legend()
    figure.savefig(picture, dpi=130)
    print(picture)


if __name__ == "__main__":
    main()
