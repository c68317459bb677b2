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
    """Whether the page says what its numbers, and the scripts, say; names the files that do not."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "page"
        shutil.copytree(out, fresh)
        page.write(Study(folder), fresh)  # no runs
        stale = [name for name in ("README.md", "numbers.csv", "chart.csv")
                 if (fresh / name).read_text() != (out / name).read_text()]
    for name in stale:
        print(f"{out / name}: not as scripts/reproduce --page writes it")
    return not stale


def main():
    parser = argparse.ArgumentParser(prog="scripts/reproduce", description="The published study, run and compared.")
    parser.add_argument("groups", nargs="*", choices=[*runs.GROUPS, []], metavar="GROUP",
                        help=f"of {', '.join(runs.GROUPS)}; default: all but the last, in this order")
    parser.add_argument("--list", action="store_true", help="what would run, and what is there")
    parser.add_argument("--page", action="store_true", help="only the page, from the runs that are there")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time, one thread each")
    parser.add_argument("--runs", type=Path, default=ROOT / "build/reproduction", help="where the runs lie")
    parser.add_argument("--out", type=Path, default=ROOT / "docs/reproduction", help="where the page goes")
    parser.add_argument("--guard", action="store_true", help="run the reduced study alone, and check its numbers")
    parser.add_argument("--check", action="store_true", help="whether the page is as its numbers make it")
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
