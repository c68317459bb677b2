#!/usr/bin/python3
"""Reads results again and again while a run writes them, and compares every number with what it must be.

Usage: tests/coupled/read_during_run.py RESULTS.h5 WINDOWS_A_FRAME DONE

Row i of a history called c has the value i + c / 8, frame k of particle p the value k + p / 1024 (read_during_run_test.cpp).
Prints a dot for each read, an e for a read that ended in an error of the library. Ends when the file DONE exists, after a
last read of everything; exit code 1 at the first wrong number.
"""
import os
import random
import sys
import time

import h5py
import numpy

HISTORIES = {"fluid/first": 0, "fluid/second": 1, "solid/first": 2}
SOME = 64  # rows and frames of a short read


def expect(values, right, what):
    wrong = numpy.flatnonzero(values != right)
    if wrong.size:
        sys.exit(f"\n{what}: {wrong.size} wrong numbers of {values.size}: number {wrong[0]} is "
                 f"{values.flat[wrong[0]]}, must be {right.flat[wrong[0]]}")


def check_rows(run, begin, end):
    for name, column in HISTORIES.items():
        values = run["history/" + name][begin:end]
        expect(values, numpy.arange(begin, begin + len(values)) + column / 8, f"rows from {begin} of {name}")


def check_frames(run, begin, end):
    for solver in "fluid", "solid":
        values = run[f"frames/{solver}/state"][begin:end]
        frames = numpy.arange(begin, begin + len(values))[:, None]
        expect(values, (frames + numpy.arange(values.shape[1]) / 1024).astype("f4"), f"frames from {begin} of {solver}")


def read(path, windows_a_frame, whole):
    """Number of frames that were seen."""
    with h5py.File(path, "r") as run:
        times = run["frames/time"][:]
        frames, rows = len(times), len(run["history/time"])
        right = numpy.arange(frames) * windows_a_frame * 1e-3
        if not numpy.allclose(times, right, rtol=1e-9, atol=0):
            sys.exit("\nfalse times of frames")
        if whole:
            check_rows(run, 0, rows)
            check_frames(run, 0, frames)
        else:
            for length, check in (rows, check_rows), (frames, check_frames):
                check(run, max(0, length - SOME), length)
                begin = random.randrange(length + 1)
                check(run, begin, min(length, begin + SOME))
        return frames


def main():
    path, windows_a_frame, done = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    reads = seen = 0
    while True:
        last = os.path.exists(done)
        if not os.path.exists(path):
            time.sleep(0.001)
            continue
        try:
            seen = max(seen, read(path, windows_a_frame, last or reads % 100 == 99))
            reads += 1
            mark = "."
        except (OSError, RuntimeError, KeyError):
            if last:
                raise
            mark = "e"
        print(mark, end="", flush=True)
        if last:
            break
    print(f"\nfinished: {reads} reads, {seen} frames")


if __name__ == "__main__":
    main()
