"""docs/reproduction: every number beside the paper's, the pictures, and what each run cost."""
import csv
import math
import sys

import numpy as np

import chart
import figures
import measures
import open_points
import paper
import runs
from plots import recorded, snapshots
from study import ROOT, core_seconds

CASE_FOLDER = ROOT / "cases/dam_break_plate"
FAMILIES = [("recommended", "1mm"), ("recommended", "2mm"), ("paper", "1mm"), ("paper", "2mm")]
FIRST_BLOW = 0.3  # s: what a run must have gone through to count
LABELS = {"recommended": "recommended settings", "paper": "the paper's settings"}


class Numbers:
    """Histories and numbers of the runs that are there, if only in part, by name; read once."""

    def __init__(self, study):
        self.study = study
        self.rows = {}
        self.histories = {}
        for run in (run for group in runs.GROUPS.values() for run in group()):
            summary = study.begun(run)
            if run.case != "dam_break_plate" or summary is None or summary.get("end_time", 0) < FIRST_BLOW:
                continue
            history = measures.History(study.folder_of(run))
            self.histories[run.name] = history
            self.rows[run.name] = measures.numbers(history, summary)

    def family(self, settings, spacing):
        """Numbers by stiffness of one set of runs of Table 2."""
        names = {label: f"stiffness_{settings}_{label}_{spacing}" for label in runs.STIFFNESS}
        return {label: self.rows[name] for label, name in names.items() if name in self.rows}


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def number(value, digits=3):
    return "" if value is None or math.isnan(value) else f"{value:.{digits}g}"


def band(limits):
    return number(limits[0]) if limits[0] == limits[1] else f"{number(limits[0])} to {number(limits[1])}"


def write_numbers(numbers, path):
    with open(path, "w", newline="") as file:
        file.write("# scripts/reproduce\n")
        columns = list(dict.fromkeys(key for row in numbers.rows.values() for key in row))
        writer = csv.DictWriter(file, ["run", *columns], lineterminator="\n")
        writer.writeheader()
        for name, row in sorted(numbers.rows.items()):
            short = {key: f"{value:.5g}" if isinstance(value, float) else value for key, value in row.items()}
            writer.writerow({"run": name} | short)


def verification(numbers):
    names = {"the paper's settings, 1 mm": "verification_paper_1mm",
             "recommended, 1 mm": "verification_recommended_1mm", "recommended, 2 mm": "verification_recommended_2mm",
             "public code's gamma and alpha, 1 mm": "verification_public_code_1mm",
             "public code's gamma and alpha, 2 mm": "verification_public_code_2mm"}
    names = {label: name for label, name in names.items() if name in numbers.rows}
    rows = []
    for key, what, limits, _ in paper.VERIFICATION:
        cells = [f"{number(numbers.rows[name][key])} ({paper.verdict(numbers.rows[name][key], limits)})"
                 for name in names.values()]
        rows.append([what, band(limits), *cells])
    for key, what in (("front_s", "front at the plate [s]"), ("first_motion_s", "first motion of the tip [s]"),
                      ("created_over_work", "work made by the coupling, over the work done"),
                      ("core_s", "core seconds")):
        rows.append([what, "", *[number(numbers.rows[name][key]) for name in names.values()]])
    return table(["", "paper", *names], rows)


def by_spacing(numbers):
    found = {}
    for settings in ("recommended", "paper"):
        row = {}
        for size in (4, 2, 1, 0.5):
            for name in (f"verification_{settings}_{size:g}mm", f"chart_1MPa_{settings}_{size:g}mm"):
                if size not in row and name in numbers.rows:
                    row[size] = numbers.rows[name]
        if row:
            found[LABELS[settings]] = row
    return found


def convergence(found):
    rows = []
    for settings, sizes in found.items():
        for size, row in sizes.items():
            rows.append([settings, f"{size:g} mm", number(1000 * row["tip_peak_m"]), number(row["tip_peak_s"], 4),
                         number(row["front_s"], 4), number(row["core_s"])])
    return table(["settings", "spacing", "largest tip [mm]", "at [s]", "front at the plate [s]", "core seconds"], rows)


def stiffness(rows):
    labels = list(rows)
    lines = []
    for key, what, elastic, rigid in paper.STIFFNESS:
        cells = []
        for label in labels:
            limits = (rigid, rigid) if label == "rigid" and rigid else elastic
            cells.append(f"{number(rows[label][key])} ({paper.verdict(rows[label][key], limits)})")
        lines.append([what, band(elastic) + (f"; rigid {number(rigid)}" if rigid else ""), *cells])
    theirs = {"tip_over_thickness": "0.35 at 20 MPa", "P01_second_peak_tau": "5.5"}
    for key, what in (("P01_second_peak_tau", "P01, second peak at tau"), ("P01_raw_peak", "P01, raw peak"),
                      ("P02_raw_peak", "P02, raw peak"), ("P01_noise", "P01, noise above 70 Hz over the peak"),
                      ("tip_over_thickness", "largest tip / e"), ("core_s", "core seconds")):
        lines.append([what, theirs.get(key, ""), *[number(rows[label][key]) for label in labels]])
    return table(["", "paper", *labels], lines)


def differences(rows):
    lines = []
    for key, what, theirs in paper.DIFFERENCES:
        values = [row[key] for row in rows.values()]
        if not any(map(math.isnan, values)):
            lines.append([what, f"{100 * theirs:.2f} %", f"{100 * measures.relative_difference(values):.1f} %"])
    return table(["R of eq. (7)", "paper", "ours"], lines)


def scatter(numbers):
    lines = []
    families = {"recommended": "recommended, 2 mm", "recommended_1mm": "recommended, 1 mm",
                "paper": "the paper's, 2 mm"}
    for family, settings in families.items():
        for key in ("P01_peak", "P02_peak", "P01_raw_peak", "P01_impulse_first", "tip_peak_m"):
            cells = []
            for label in ("20MPa", "rigid"):
                values = [row[key] for name, row in numbers.rows.items()
                          if name.startswith(f"scatter_{family}_{label}_") and not math.isnan(row[key])]
                cells.append(f"{np.mean(values):.3g} ± {np.std(values, ddof=1):.2g} ({len(values)} starts)"
                             if len(values) > 1 else "")
            if any(cells):
                lines.append([settings, key, *cells])
    return table(["settings", "number", "20 MPa", "rigid"], lines) if lines else ""


def costs(numbers):
    """Processor time of the verification case and Table 2, and how long they take, one run on each of two cores."""
    lines = []
    for settings, spacing in FAMILIES:
        names = [f"verification_{settings}_{spacing}"]
        names += [f"stiffness_{settings}_{label}_{spacing}" for label in runs.STIFFNESS]
        over = [numbers.rows[name] for name in names if name in numbers.rows]
        spent = [row["core_s"] for row in over if not math.isnan(row["P01_impulse"])]
        if spent:
            lines.append([LABELS[settings], spacing, f"{len(spent)} of {len(names)}",
                          f"{min(spent) / 60:.1f} to {max(spent) / 60:.1f}", number(sum(spent) / 3600),
                          number(sum(spent) / 3600 / 2)])
    return table(["settings", "spacing", "runs that are there", "core minutes of one", "core hours of all",
                  "hours on two cores"], lines)


def filters(history):
    """The peak at P01 by the filter that was taken."""
    _, raw = history.even("P01")
    lines = [["none", number(raw.max())]]
    for cut_off in (50, 70, 100):
        for order in (2, 4, 8):
            smooth = measures.low_passed(raw, cut_off, order)
            lines.append([f"{cut_off} Hz, order {order}, forward and backward", number(smooth.max())])
    return table(["filter", "peak of Cp"], lines)


def finite_width(study, out):
    """Part of the page: the scene in three dimensions."""
    run = next(runs.finite_width())
    if not study.finished(run):
        return ""
    results = recorded.read_run(study.folder_of(run))
    figure = snapshots.snapshots(results)
    figure.savefig(out / "finite_width.png", dpi=80)
    figures.plt.close(figure)
    tip = results.history["solid/tip_x"]
    summary = study.summary(run)
    return ("## Three dimensions: a plate of finite width\n\n"
            f"`cases/dam_break_plate_3d`, 8 mm, {summary['participants']['fluid']['particles']} particles of water and "
            f"walls: the middle slice. The tip goes to {1000 * tip.max():.1f} mm at "
            f"{results.time[tip.argmax()]:.3f} s; {core_seconds(summary):.0f} core seconds.\n\n"
            "![finite width](finite_width.png)\n")


def swapped(numbers, out):
    """Part of the page: the same scene with each model of the structure, by one word."""
    names = {"fem": "recommended_2mm", "modal": "modal", "hamiltonian": "hamiltonian", "mps": "mps"}
    names = {model: f"chart_20MPa_{name}" for model, name in names.items() if f"chart_20MPa_{name}" in numbers.rows}
    if len(names) < 2:
        return ""
    figure = figures.swapped({model: numbers.histories[name] for model, name in names.items()})
    figure.savefig(out / "swapped.png", dpi=90)
    figures.plt.close(figure)
    reference = numbers.rows[next(iter(names.values()))]["tip_peak_m"]
    lines = []
    for model, name in names.items():
        row = numbers.rows[name]
        solid = numbers.study.begun(next(run for run in runs.chart() if run.name == name))["participants"]["solid"]
        lines.append([model, f"{1000 * row['tip_peak_m']:.2f}", number(row["tip_peak_s"], 4),
                      f"{100 * (row['tip_peak_m'] / reference - 1):+.1f} %", number(solid["seconds"]["cpu"])])
    header = ["model", "largest tip [mm]", "at [s]", f"off {next(iter(names))}", "core seconds of the solid"]
    return ("## Another structure by one word\n\n20 MPa, 2 mm, `--set solid.model=...`.\n\n" + table(header, lines) +
            "\n![tips with each model](swapped.png)\n")


def draw(out, numbers, found):
    """Saves the figures that there are runs for; returns the lines of the page that show them."""
    shown = {}

    def put(name, figure):
        figure.savefig(out / f"{name}.png", dpi=90)
        figures.plt.close(figure)
        shown[name] = f"![{name.replace('_', ' ')}]({name}.png)\n"

    folder = numbers.study.folder
    tips = {label: numbers.histories[name] for label, name in
            (("the paper's settings, 1 mm", "verification_paper_1mm"),
             ("recommended, 1 mm", "verification_recommended_1mm"),
             ("recommended, 2 mm", "verification_recommended_2mm"))
            if name in numbers.histories}
    if tips:
        put("tip", figures.fig3_tip(tips, CASE_FOLDER))
    for settings in ("paper", "recommended"):
        if f"verification_{settings}_1mm" in numbers.rows:
            put(f"snapshots_{settings}", figures.fig2_snapshots(folder / f"verification_{settings}_1mm"))
    if found:
        put("convergence", figures.convergence(found))
    for settings, spacing in FAMILIES:
        rows = numbers.family(settings, spacing)
        if len(rows) < 2:
            continue
        tag = f"{settings}_{spacing}"
        histories = {label: numbers.histories[f"stiffness_{settings}_{label}_{spacing}"] for label in rows}
        for label in ("20MPa", "rigid"):
            if label in histories:
                put(f"spectrum_{label}_{tag}", figures.fig4_spectrum(histories[label]))
        for name in ("P01", "P02"):
            put(f"{name}_{tag}", figures.fig6_filtered(histories, name))
        put(f"impulses_{tag}", figures.fig8_impulses(rows))
        put(f"tips_{tag}", figures.fig9_tips(histories, rows))
        if spacing == max(("1mm", "2mm"), key=lambda finest: len(numbers.family(settings, finest))):
            put(f"speeds_{tag}", figures.fig10_speeds(
                {label: folder / f"stiffness_{settings}_{label}_{spacing}" for label in rows}))
    return shown


def write(study, out):
    numbers = Numbers(study)
    if not numbers.rows:
        sys.exit(f"no finished runs in {study.folder}")
    out.mkdir(parents=True, exist_ok=True)
    write_numbers(numbers, out / "numbers.csv")
    found = by_spacing(numbers)
    shown = draw(out, numbers, found)
    take = lambda *names: "\n".join(shown[name] for name in names if name in shown)
    parts = ["# The published study, reproduced\n",
             "Written by `scripts/reproduce`; all numbers in [numbers.csv](numbers.csv), what they say in "
             "[findings.md](findings.md). Filter: Butterworth of 4th order, 70 Hz, forward and backward (no delay). "
             "In brackets: how far from the paper's number or range.\n",
             "## Verification case (Table 1, Figs. 2 and 3)\n", verification(numbers),
             take("tip", "snapshots_paper", "snapshots_recommended"), "## Convergence of the first peak\n",
             convergence(found), take("convergence")]
    for settings, spacing in FAMILIES:
        rows = numbers.family(settings, spacing)
        if len(rows) < 2:
            continue
        tag = f"{settings}_{spacing}"
        parts += [f"## Stiffness (Table 2), {LABELS[settings]}, {spacing}\n", stiffness(rows), differences(rows),
                  take(*(f"{name}_{tag}" for name in ("spectrum_20MPa", "spectrum_rigid", "P01", "P02", "impulses",
                                                      "tips", "speeds")))]
        if "20MPa" in rows:
            parts += ["The peak at P01 at 20 MPa by the filter:\n",
                      filters(numbers.histories[f"stiffness_{settings}_20MPa_{spacing}"])]
    parts += ["## Cost\n", "To two seconds each; every run's own time is in numbers.csv.\n", costs(numbers),
              "## Scatter of the peaks\n",
              "Starts that differ by ten-thousandths of gravity, sideways: mean and standard deviation.\n",
              scatter(numbers), open_points.write(study), swapped(numbers, out), finite_width(study, out),
              chart.write(numbers, out)]
    (out / "README.md").write_text("\n".join(part for part in parts if part))
