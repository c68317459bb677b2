#!/usr/bin/env python3
"""Draws a table of `cosurge map`: one row per combination of the first axes, the last axis to the right.

scripts/plot_map.py TABLE PICTURE [--x 20/x] [--label "added mass over mass"] [--limit weak/mean/held=2 ...]

--x      what is drawn to the right, from the first number x of the last axis
--limit  a mark at this place in every row whose name contains the text
"""
import argparse
import csv

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STATES = {"stable": ("o", "#2a7ab9", "stable"), "growing": ("s", "#e8a33d", "bounded, grows or alternates"),
          "draining": ("D", "#7a5ab9", "bounded, energy drains"),
          "blown_up": ("x", "#b3262a", "blown up"), "refused": (".", "#999999", "refused")}


def read(table):
    with open(table, newline="") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    head = rows[0]
    axes = head[:head.index("state")]
    return axes, [dict(zip(head, row)) for row in rows[1:]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table")
    parser.add_argument("picture")
    parser.add_argument("--x", default="x")
    parser.add_argument("--label", default=None)
    parser.add_argument("--limit", action="append", default=[])
    arguments = parser.parse_args()
    axes, cells = read(arguments.table)
    names = []
    for cell in cells:
        cell["name"] = ", ".join(cell[axis].replace("/", " ") for axis in axes[:-1])
        cell["x"] = eval(arguments.x, {"x": float(cell[axes[-1]].split("/")[0])})
        if cell["name"] not in names:
            names.append(cell["name"])
    figure, plot = plt.subplots(figsize=(9, 1.2 + 0.34 * len(names)), layout="constrained")
    for state, (marker, colour, label) in STATES.items():
        some = [cell for cell in cells if cell["state"] == state]
        if some:
            plot.scatter([cell["x"] for cell in some], [-names.index(cell["name"]) for cell in some],
                         marker=marker, color=colour, label=label, s=36)
    drawn = False
    for limit in arguments.limit:
        text, value = limit.rsplit("=", 1)
        for row, name in enumerate(names):
            if text.replace("/", " ") in name:
                plot.plot([float(value)] * 2, [-row - 0.42, -row + 0.42], color="black", lw=1.8,
                          label=None if drawn else "theory")
                drawn = True
    plot.set_xscale("log")
    plot.set_yticks([-row for row in range(len(names))], names, fontsize=8)
    plot.set_xlabel(arguments.label or axes[-1])
    plot.grid(axis="x", alpha=0.3)
    plot.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=5, fontsize=8, frameon=False)
    figure.savefig(arguments.picture, dpi=130)


if __name__ == "__main__":
    main()
