#!/usr/bin/env python3
"""Draws a chart of `cosurge chart`: error over core seconds, one panel a quantity, the Pareto front as a line.

scripts/plot_chart.py FOLDER|CHART.csv [PICTURE]        default: chart.png beside the table
"""
import argparse
from pathlib import Path

from plots import chart


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", type=Path)
    parser.add_argument("picture", type=Path, nargs="?")
    arguments = parser.parse_args()
    table = arguments.table / "chart.csv" if arguments.table.is_dir() else arguments.table
    picture = arguments.picture or table.with_suffix(".png")
    chart.draw(chart.read(table)).savefig(picture)
    print(picture)


if __name__ == "__main__":
    main()
