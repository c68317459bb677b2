#!/usr/bin/python3
"""Runs and reports; see scripts/reproduce."""
import argparse
import os
import shutil
import signal
import sys
import tempfile
from pathlib import Path

import guard
import page
import runs
from study import ROOT, Study


def page_is_current(out):
    """Whether the page is up to date with its numbers and the scripts; prints the files that are not."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "page"
        shutil.copytree(out, fresh)
        page.write(Study(folder), fresh)  # no runs
        stale = [name for name in ("README.md", "numbers.csv", "chart.csv")
                 if (fresh / name).read_text() != (out / name).read_text()]
    for name in stale:
        print(f"{out / name}: out of date; run scripts/reproduce --page")
    return not stale


def main():
    parser = argparse.ArgumentParser(prog="scripts/reproduce", description="Run the published study and compare the results.")
    parser.add_argument("groups", nargs="*", choices=[*runs.GROUPS, []], metavar="GROUP",
                        help=f"of {', '.join(runs.GROUPS)}; default: all but the last, in this order")
    parser.add_argument("--list", action="store_true", help="list the runs and their states")
    parser.add_argument("--page", action="store_true", help="only write the page, from the available runs")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of simultaneous runs, one thread each")
    parser.add_argument("--runs", type=Path, default=ROOT / "build/reproduction", help="folder of the runs")
    parser.add_argument("--out", type=Path, default=ROOT / "docs/reproduction", help="folder of the page")
    parser.add_argument("--guard", action="store_true", help="run only the reduced study, and check its numbers")
    parser.add_argument("--check", action="store_true", help="check that the page is up to date with its numbers")
    options = parser.parse_args()
    if options.check:
        sys.exit(not page_is_current(options.out))
    study = Study(options.runs, options.jobs)
    if options.guard:
        study.execute(list(runs.reduced()))
        sys.exit(not guard.check(study))
    groups = options.groups or [name for name in runs.GROUPS if name != "reduced"]
    chosen = runs.of(groups)
    if options.list:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # into head
        for run in chosen:
            summary = study.summary(run)
            print(f"{run.name:44s} {summary['status'] if summary else 'not yet':9s} {' '.join(run.words())}")
        return
    if not options.page:
        study.execute(chosen)
        failed = [run.name for run in chosen if not study.finished(run)]
        if failed:
            print(f"did not finish: {', '.join(failed)} (logs in {options.runs})", file=sys.stderr)
    page.write(study, options.out)
    print(options.out / "README.md")


if __name__ == "__main__":
    main()
