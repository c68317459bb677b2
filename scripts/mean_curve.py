#!/usr/bin/env python3
"""Writes the mean of several curves, each a table of two columns with a header, over the time that all of them have.

scripts/mean_curve.py OUT.csv CURVE.csv ... [--step SECONDS]
"""
import argparse
import csv

import numpy as np


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], np.array(rows[1:], float).T


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("curves", nargs="+")
    parser.add_argument("--step", type=float, default=1e-3, help="of the times of the mean [s]")
    arguments = parser.parse_args()
    heads, curves = zip(*map(read, arguments.curves))
    if any(head != heads[0] for head in heads):
        parser.error(f"the curves have different columns: {sorted({', '.join(head) for head in heads})}")
    first = np.ceil(max(time[0] for time, _ in curves) / arguments.step)
    last = np.floor(min(time[-1] for time, _ in curves) / arguments.step)
    if last <= first:
        parser.error("the curves have no time in common")
    times = np.arange(first, last + 1) * arguments.step
    mean = np.mean([np.interp(times, time, values) for time, values in curves], axis=0)
    with open(arguments.out, "w") as file:
        print(f"# mean of {len(curves)} curves: scripts/mean_curve.py {arguments.out} {' '.join(arguments.curves)}", file=file)
        print(",".join(heads[0]), file=file)
        for time, value in zip(times, mean):
            print(f"{time:.6g},{value:.6g}", file=file)


if __name__ == "__main__":
    main()
