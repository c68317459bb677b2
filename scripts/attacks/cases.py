"""The cases that are attacked: seconds each; together they have every scheme, every model of a solid, two and three
dimensions, water alone and a solid alone."""
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SMALL = "tests/cases/small_dam_break"

# Name: the case's folder, and values in place of its own.
CASES = {
    "weak": (SMALL, "time.end=0.06", "output.frame_interval=0.01"),
    "strong": (SMALL, "time.end=0.03", "output.frame_interval=0.005", "coupling.scheme=strong", "fluid.source=mixed",
               "solid.model=modal"),
    "auto": (SMALL, "time.end=0.04", "output.frame_interval=0.005", "coupling.scheme=auto", "coupling.velocity=end",
             "solid.density=300"),
    "strong_inertial": (SMALL, "time.end=0.03", "output.frame_interval=0.007", "coupling.scheme=strong_inertial",
                        "coupling.velocity=end", "solid.model=fem"),
    "weak_inertial": (SMALL, "time.end=0.04", "output.frame_interval=0.007", "coupling.scheme=weak_inertial",
                      "coupling.velocity=end", "solid.model=modal"),
    "mps": (SMALL, "time.end=0.03", "output.frame_interval=0.005", "solid.model=mps", "coupling.load=ramped"),
    "hamiltonian": (SMALL, "time.end=0.03", "output.frame_interval=0.005", "solid.model=hamiltonian",
                    "solid.material=st_venant_kirchhoff"),
    "rigid": (SMALL, "time.end=0.05", "output.frame_interval=0.001", "solid.model=rigid"),
    "sprung": ("cases/sprung_piston", "time.end=0.1", "output.frame_interval=0.01"),
    "flap": ("cases/dam_break_flap", "time.end=0.03", "output.frame_interval=0.005"),
    "three_dimensions": ("cases/dam_break_plate_3d", "time.end=0.0016",
                         "output.frame_interval=0.0004"),
    "water_alone": ("cases/wave_maker", "time.end=0.03", "output.frame_interval=0.005"),
    "solid_alone": ("cases/cantilever", "time.end=0.2", "output.frame_interval=0.01", "solid.spacing=0.004"),
}


def arguments(name, out, in_process):
    """Of `cosurge` to run a case into a folder, on one thread."""
    folder, *settings = CASES[name]
    way = ["--in-process"] if in_process else []
    return ["run", str(ROOT / folder), "--out", str(out), "--threads", "1", *way, "--set", *settings]
