"""Small runs of all kinds, by the real programs."""
import signal
import subprocess
import time

TANK = """title = "Small dam break in three dimensions"
dimension = 3
gravity = [0.0, 0.0, -9.81]
[time]
end = 0.1
window = 1e-3
[fluid]
spacing = 0.02
tank = { min = [0.0, 0.0, 0.0], max = [0.4, 0.16, 0.4] }
water = [{ min = [0.0, 0.0, 0.0], max = [0.12, 0.16, 0.24] }]
[[fluid.obstacle]]
shape = { min = [0.3, 0.04, 0.0], max = [0.38, 0.12, 0.1] }
[output]
frame_interval = 0.01
probe = [{ name = "foot", quantity = "pressure", position = [0.3, 0.08, 0.02] }]
"""

WAVE = """title = "A wall pushes water"
gravity = [0.0, -9.81]
[time]
end = 0.2
window = 1e-3
[fluid]
spacing = 0.01
tank = { min = [0.0, 0.0], max = [0.6, 0.3] }
water = [{ min = [0.1, 0.0], max = [0.6, 0.1] }]
[[fluid.obstacle]]
shape = { min = [0.0, 0.0], max = [0.1, 0.25] }
motion = { amplitude = [0.04, 0.0], frequency = 1.0 }
[output]
probe = [{ name = "far", quantity = "level", position = [0.55, 0.0] }]
"""


class Runs:
    """Makes each run once, in a folder of its own."""

    def __init__(self, programs, source, folder):
        self.cosurge, self.source, self.folder = programs / "cosurge", source, folder
        self.small = source / "tests/cases/small_dam_break"

    def command(self, case, name, *changes):
        arguments = [str(self.cosurge), "run", str(case), "--out", str(self.folder / name), "--threads", "1"]
        return arguments + (["--set", *changes] if changes else [])

    def cosurge_says(self, *arguments):
        """Runs cosurge to its end and returns what it has said; fails where it has."""
        done = subprocess.run([str(self.cosurge), *map(str, arguments)], capture_output=True, text=True, timeout=600)
        if done.returncode != 0:
            raise AssertionError(f"cosurge {arguments}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def case(self, name, text):
        path = self.folder / f"{name}_case"
        path.mkdir(exist_ok=True)
        (path / "case.toml").write_text(text)
        return path

    def run(self, case, name, *changes):
        if not (self.folder / name / "summary.json").exists():
            subprocess.run(self.command(case, name, *changes), check=True, capture_output=True, timeout=900)
        return self.folder / name

    def ended(self, case, name, how):
        """A run that gets a signal after its first frames."""
        process = subprocess.Popen(self.command(case, name), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (self.folder / name / "checkpoint.old").exists() and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(how)
        process.wait(30)
        return self.folder / name

    def report(self, *runs, name):
        page = self.folder / f"{name}.html"
        page.unlink(missing_ok=True)
        self.cosurge_says("report", *runs, "--out", page)
        return page

    def coupled(self):
        return self.run(self.small, "coupled")

    def stiffer(self):
        return self.run(self.small, "stiffer", "solid.young_modulus=4e6")

    def water(self):
        return self.run(self.case("wave", WAVE), "water")

    def space(self):
        return self.run(self.case("tank", TANK), "space")

    def solid(self):
        return self.run(self.source / "cases/cantilever", "solid", "solid.spacing=0.002")

    def interrupted(self):
        return self.ended(self.small, "interrupted", signal.SIGINT)

    def killed(self):
        return self.ended(self.small, "killed", signal.SIGKILL)
