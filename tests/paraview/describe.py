#!/usr/bin/python3
"""Opens a file as ParaView's Open dialog does, with the default reader, and prints what is in it as JSON."""
import json
import sys

from paraview import servermanager
from paraview.simple import OpenDataFile


def leaves(data):
    if data is None:
        return
    if data.IsA("vtkDataSet"):
        yield data
        return
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def described(grid):
    arrays = {}
    points = grid.GetPointData()
    for k in range(points.GetNumberOfArrays()):
        array = points.GetArray(k)
        arrays[array.GetName()] = {"components": array.GetNumberOfComponents(), "range": array.GetRange(-1),
                                   "tuples": array.GetNumberOfTuples()}
    cell = grid.GetCell(0) if grid.GetNumberOfCells() else None
    sizes = [grid.GetCell(k).GetLength2() for k in range(min(grid.GetNumberOfCells(), 50))]
    return {"points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(), "bounds": grid.GetBounds(),
            "cell": cell.GetClassName() if cell else None, "largest_cell": max(sizes, default=0) ** 0.5, "arrays": arrays}


def main():
    reader = OpenDataFile(sys.argv[1])
    times = list(reader.TimestepValues) if hasattr(reader.TimestepValues, "__iter__") else [reader.TimestepValues]
    frames = []
    for time in (times[0], times[-1]):
        reader.UpdatePipeline(time)
        frames.append([described(grid) for grid in leaves(servermanager.Fetch(reader))])
    print("JSON " + json.dumps({"reader": reader.GetXMLName(), "times": times, "frames": frames}))


if __name__ == "__main__":
    main()
