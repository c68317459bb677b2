"""Runs of cosurge for a study: one folder each; interrupted runs are resumed, finished runs are not repeated."""
import concurrent.futures
import dataclasses
import hashlib
import json
import re
import subprocess
import sys
import threading
import time
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COSURGE = ROOT / "build/release/bin/cosurge"


@dataclasses.dataclass(frozen=True)
class Run:
    """A case with changed values ({key: value}), and the name of its folder."""

    name: str
    case: str
    settings: dict

    def words(self):
        return [f"{key}={value}" for key, value in self.settings.items()]

    def identity(self):
        """Hash of everything that the results depend on; a folder with another hash is from an older study."""
        case = tomllib.loads((ROOT / "cases" / self.case / "case.toml").read_text())
        text = json.dumps([case, self.words()], sort_keys=True)
        return hashlib.sha1(text.encode()).hexdigest()


class Study:
    """Runs in one folder, `jobs` at a time, each with `threads` threads."""

    def __init__(self, folder, jobs=1, threads=1):
        self.folder = Path(folder)
        self.jobs = jobs
        self.threads = threads

    def folder_of(self, run):
        return self.folder / run.name

    def begun(self, run):
        """summary.json of a run, finished or not; None if there is none."""
        path = self.folder_of(run) / "summary.json"
        return json.loads(path.read_text()) if path.exists() and self._identity(run) == run.identity() else None

    def summary(self, run):
        """The same for a run that has ended, successfully or not."""
        summary = self.begun(run)
        return summary if summary and summary["status"] in ("finished", "failed") else None

    def finished(self, run):
        summary = self.summary(run)
        return summary is not None and summary["status"] == "finished"

    def execute(self, runs):
        """Runs those that have not ended yet; prints the progress every half minute."""
        left = [run for run in runs if self.summary(run) is None]
        if not left:
            return
        self.folder.mkdir(parents=True, exist_ok=True)
        done = threading.Event()
        watch = threading.Thread(target=self._watch, args=(left, done))
        watch.start()
        try:
            with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
                list(pool.map(self._run, left))
        finally:
            done.set()
            watch.join()

    def _identity(self, run):
        path = self._log(run).with_suffix(".id")
        return path.read_text() if path.exists() else None

    def _log(self, run):
        return self.folder / f"{run.name}.log"

    def _run(self, run):
        folder = self.folder_of(run)
        begun = self._identity(run) == run.identity() and (folder / "checkpoint").exists()
        self._log(run).with_suffix(".id").write_text(run.identity())
        if not begun or "it belongs to another case or build" in self._start(run, ["resume", folder], "a"):
            subprocess.run(["rm", "-rf", folder], check=True)
            settings = ["--set", *run.words()] if run.settings else []
            self._start(run, ["run", ROOT / "cases" / run.case, "--out", folder, *settings], "w")
        if not (folder / "summary.json").exists():  # refused before it began
            folder.mkdir(exist_ok=True)
            words = self._log(run).read_text().strip()
            (folder / "summary.json").write_text(json.dumps({"status": "failed", "reason": words}))

    def _start(self, run, words, mode):
        """Runs cosurge to its end, with its output in the log opened in `mode`; returns the output."""
        with open(self._log(run), mode) as log:
            before = log.tell()
            command = [COSURGE, words[0], "--threads", str(self.threads), *words[1:]]
            subprocess.run(command, stdout=log, stderr=log, check=False)
        return self._log(run).read_bytes()[before:].decode()

    def _progress(self, run):
        """Words of the last line of progress: time, end, seconds left; None before the first."""
        if not self._log(run).exists():
            return None
        lines = re.findall(r"^t ([\d.]+)/([\d.]+) s .* (\d+(?::\d+)+) left$", self._log(run).read_text(), re.M)
        if not lines:
            return None
        now, end, left = lines[-1]
        seconds = 0
        for part in left.split(":"):
            seconds = 60 * seconds + int(part)
        return now, end, seconds

    def _watch(self, runs, done):
        started = time.time()
        while not done.wait(30):
            over = sum(self.summary(run) is not None for run in runs)
            going = [(run, self._progress(run)) for run in runs if self.summary(run) is None]
            going = [(run, progress) for run, progress in going if progress]
            now = ", ".join(f"{run.name} at {t} of {end} s, {left // 60 + 1} min left"
                            for run, (t, end, left) in going)
            minutes = (time.time() - started) / 60
            print(f"{over} of {len(runs)} runs after {minutes:.0f} min; {now}", file=sys.stderr, flush=True)


def core_seconds(summary):
    """Processor time of both solvers [s]."""
    return sum(part["seconds"]["cpu"] for part in summary["participants"].values())
