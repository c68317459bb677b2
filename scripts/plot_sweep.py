#!/usr/bin/python3
"""Draws a column of a sweep's table against one of its keys; the other keys that vary make the curves.

scripts/plot_sweep.py FOLDER|SWEEP.csv --column 'peak(tip.x)' [--against KEY] [--out PICTURE] [--log x|y|xy]
default: the first quantity against the first key; sweep.png beside the table
"""
import argparse
import csv
import itertools
import sys
from pathlib import Path

from plots.style import plt


def read(path):
    """Rows of sweep.csv that finished, and its keys and quantities. Ends the program where the file is no such table."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if not rows or "core_seconds" not in rows[0] or "state" not in rows[0]:
        sys.exit(f"{path}: is no table of cosurge sweep")
    columns = list(rows[0])
    keys = list(itertools.takewhile(lambda column: column != "state", columns))
    quantities = columns[columns.index("core_seconds"):-1]
    return [row for row in rows if row["state"] == "finished"], keys, quantities


def choose(wanted, names, what):
    """The name that begins with `wanted`; the first without one. Ends the program where there is none."""
    found = [name for name in names if wanted is None or name == wanted or name.startswith(f"{wanted} [")]
    if not found:
        sys.exit(f"no {what} {wanted}; there are {', '.join(names)}")
    return found[0]


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def curves(rows, keys, key, column):
    """(label, [(x as text, y)]) for each combination of the keys that vary besides `key`."""
    others = [other for other in keys if other != key and len({row[other] for row in rows}) > 1]
    found = {}
    for row in rows:
        label = ", ".join(f"{other.rsplit('.', 1)[-1]} {row[other] or 'as in the case'}" for other in others)
        found.setdefault(label, []).append((row[key] or "as in the case", number(row[column])))
    return found.items()


def draw(rows, keys, key, column, log):
    figure, axes = plt.subplots(layout="constrained", figsize=(7, 4.6))
    numeric = all(number(row[key]) is not None for row in rows)
    for label, points in curves(rows, keys, key, column):
        if numeric:
            points = sorted((number(x), y) for x, y in points)
        axes.plot([x for x, _ in points], [y for _, y in points], "o-", lw=1.2, ms=4, label=label)
        if label:
            axes.legend(fontsize=8)
    axes.set(xlabel=key, ylabel=column)
    if "x" in log and numeric:
        axes.set_xscale("log")
    if "y" in log:
        axes.set_yscale("log")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", type=Path)
    parser.add_argument("--column")
    parser.add_argument("--against", metavar="KEY")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--log", choices=("", "x", "y", "xy"), default="")
    arguments = parser.parse_args()
    table = arguments.table / "sweep.csv" if arguments.table.is_dir() else arguments.table
    rows, keys, quantities = read(table)
    column = choose(arguments.column, [*quantities[1:], quantities[0]], "column")
    key = choose(arguments.against, keys, "key")
    if not rows:
        sys.exit(f"{table}: no run finished")
    picture = arguments.out or table.with_suffix(".png")
    draw(rows, keys, key, column, arguments.log).savefig(picture)
    print(picture)


if __name__ == "__main__":
    main()
