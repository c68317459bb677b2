#!/usr/bin/python3
"""Pictures of a run, from its results.h5: scripts/plot_run.py FOLDER [--out DIR] [--case DIR]

snapshots.png  the water by pressure and the structure at six instants; a long scene around its structure; three dimensions
               by speed, as seen from the front and the right
tip.png        displacement probes
front.png      front of the water on the floor, where the case folder has published fronts (columns t, z)
pressure.png   pressure probes, raw and low-passed, and their spectra
level.png      level probes
force.png      force probes, and the load of the water on the structure
moment.png     moment probes
overtopping.png  water that has left the tank, and water behind the structure
stress.png     largest von Mises stress of the frames
energy.png     kinetic, potential and elastic energy, and the work through the interface
timing.png     where the wall time went

Works while the run goes on, and for runs of a fluid or a solid alone. What a run does not have is left out.

Reference curves are the tables reference/*.csv of the run's own case folder, which the results name. Their first
column is t_s; the second says what they are: ux_m, uy_m, uz_m of every displacement probe, or a probe's own history with its unit
(tip_y_m, P01_Pa, gauge_m).
"""
import argparse
from pathlib import Path

from plots import histories, loads, recorded, snapshots, timing


def main():
    parser = argparse.ArgumentParser(description="Pictures of a run.", epilog=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="of the results")
    parser.add_argument("--out", type=Path, help="where the pictures go; default: the folder itself")
    parser.add_argument("--case", type=Path, help="case folder with reference curves; default: the run's own")
    arguments = parser.parse_args()
    run = recorded.read_run(arguments.folder)
    out = arguments.out or arguments.folder
    out.mkdir(parents=True, exist_ok=True)
    case_folder = arguments.case or recorded.find_case_folder(run)
    pictures = {"snapshots": snapshots.snapshots(run), "tip": histories.tip(run, case_folder),
                "front": histories.front(run, case_folder), "pressure": histories.pressure(run, case_folder),
                "level": histories.level(run, case_folder), "force": loads.force(run, case_folder),
                "moment": loads.moment(run, case_folder), "overtopping": loads.overtopping(run),
                "stress": loads.stress(run), "energy": histories.energy(run),
                "timing": timing.timing(run)}
    for name, figure in pictures.items():
        if figure is not None:
            figure.savefig(out / f"{name}.png")
            print(out / f"{name}.png")


if __name__ == "__main__":
    main()
