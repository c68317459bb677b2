"""A run of cosurge with all of its processes, and a check that none remain."""
import os
import signal
import subprocess
import time
from pathlib import Path

MARK = "COSURGE_ATTACK"  # an environment variable, by which descendants are known whoever their parent is


class Program:
    """`arguments`: of the command cosurge; `temporary`: folder for temporary files; `settings`: environment variables."""

    def __init__(self, cosurge, arguments, log, mark, temporary, settings=None):
        self.mark = f"{MARK}={mark}\0".encode()
        self.log = log
        environment = {**os.environ, MARK: mark, "TMPDIR": str(temporary), **(settings or {})}
        with open(log, "w") as output:
            self.process = subprocess.Popen([str(cosurge), *arguments], stdin=subprocess.DEVNULL, stdout=output,
                                            stderr=subprocess.STDOUT, env=environment)

    def members(self):
        """{process id: name} of all that live, the stopped ones too."""
        found = {}
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                if self.mark in (entry / "environ").read_bytes():
                    found[int(entry.name)] = (entry / "comm").read_text().strip()
            except OSError:
                continue  # it has just ended, or is somebody else's
        return found

    def solvers(self):
        return {pid: name for pid, name in self.members().items() if pid != self.process.pid}

    def send(self, number, pid=None):
        try:
            os.kill(pid or self.process.pid, number)
        except ProcessLookupError:
            pass  # it was faster

    def wait(self, seconds):
        """The exit code; None where it has not ended."""
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None

    def left_behind(self, seconds):
        """Names of processes that are still running a given time after the end of cosurge."""
        end = time.monotonic() + seconds
        while (left := self.members()) and time.monotonic() < end:
            time.sleep(0.02)
        return sorted(left.values())

    def end(self):
        for pid in self.members():
            self.send(signal.SIGKILL, pid)
        self.process.wait()

    def output(self):
        return self.log.read_text(errors="replace")
