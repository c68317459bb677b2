"""docs/reproduction: every number compared with the paper's, the pictures, and the cost of each run."""
import math
import sys

import numpy as np

import chart
import figures
import measures
import open_points
import paper
import record
import runs
from plots import recorded, snapshots
from study import ROOT

CASE_FOLDER = ROOT / "cases/dam_break_plate"
FAMILIES = [("recommended", "1mm"), ("recommended", "2mm"), ("paper", "1mm"), ("paper", "2mm")]
LABELS = {"recommended": "recommended settings", "paper": "the paper's settings",
          "public_code": "public code's gamma and alpha"}


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def number(value, digits=3):
    return "" if value is None or math.isnan(value) else f"{value:.{digits}g}"


def band(limits):
    return number(limits[0]) if limits[0] == limits[1] else f"{number(limits[0])} to {number(limits[1])}"


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
                      ("created_over_work", "energy created by the coupling, relative to the work done"),
                      ("core_s", "core seconds")):
        rows.append([what, "", *[number(numbers.rows[name][key]) for name in names.values()]])
    return table(["", "paper", *names], rows)


def by_spacing(numbers):
    found = {}
    for settings in LABELS:
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
                      ("P02_raw_peak", "P02, raw peak"), ("P01_noise", "P01, noise above 70 Hz, relative to the peak"),
                      ("tip_over_thickness", "largest tip / e"), ("core_s", "core seconds")):
        lines.append([what, theirs.get(key, ""), *[number(rows[label][key]) for label in labels]])
    return table(["", "paper", *labels], lines)


def differences(rows):
    lines = []
    for key, what, theirs in paper.DIFFERENCES:
        values = [row[key] for row in rows.values() if not math.isnan(row[key])]
        if len(values) > 1:
            ours = f"{100 * measures.relative_difference(values):.1f} %"
            lines.append([what, f"{100 * theirs:.2f} %", ours, f"{len(values)} of {len(runs.STIFFNESS)}"])
    return table(["R of eq. (7)", "paper", "ours", "plates"], lines)


BLOW = ("P01_peak", "P02_peak", "P01_raw_peak", "P01_impulse_first", "tip_peak_m")
FALL = ("P01_second_peak", "P01_second_peak_tau", "P02_second_peak")
SCATTER = {"recommended": ("recommended, 2 mm", BLOW), "recommended_1mm": ("recommended, 1 mm", BLOW),
           "paper": ("the paper's settings, 2 mm", BLOW), "late": ("recommended, 2 mm", FALL),
           "lid": ("recommended, 2 mm, a lid at 1.5 H", FALL)}


def scatter(numbers):
    lines = []
    for family, (settings, keys) in SCATTER.items():
        for key in keys:
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
    """Processor time of the verification case and Table 2, and their duration with one run on each of two cores."""
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
    return table(["settings", "spacing", "finished runs", "core minutes per run", "core hours of all",
                  "hours on two cores"], lines)


def filters(row):
    """The peak at P01 for each filter."""
    lines = [["none", number(row["P01_raw_peak"])]]
    for cut_off, order in measures.FILTERS:
        peak = row[f"P01_peak_{cut_off}Hz_{order}"]
        lines.append([f"{cut_off} Hz, order {order}, forward and backward", number(peak)])
    return table(["filter", "peak of Cp"], lines)


def finite_width(numbers, pictures):
    """Part of the page: the scene in three dimensions."""
    name = next(runs.finite_width()).name
    if name not in numbers.rows:
        return ""
    row = numbers.rows[name]
    return ("## Three dimensions: a plate of finite width\n\n"
            f"`cases/dam_break_plate_3d`, 8 mm, {row['particles']:.0f} particles of water and walls: the middle slice. "
            f"The largest displacement of the tip is {1000 * row['tip_peak_m']:.1f} mm at {row['tip_peak_s']:.3f} s; {row['core_s']:.0f} core "
            "seconds.\n\n" + pictures.draw(name, {name: name}, lambda histories: snapshots.snapshots(
                recorded.read_run(histories[name].folder))))


def swapped(numbers, pictures):
    """Part of the page: the same scene with each structural model."""
    names = {"fem": "recommended_2mm", "modal": "modal", "hamiltonian": "hamiltonian", "mps": "mps"}
    names = {model: f"chart_20MPa_{name}" for model, name in names.items() if f"chart_20MPa_{name}" in numbers.rows}
    if len(names) < 2:
        return ""
    reference = numbers.rows[next(iter(names.values()))]["tip_peak_m"]
    lines = []
    for model, name in names.items():
        row = numbers.rows[name]
        lines.append([model, f"{1000 * row['tip_peak_m']:.2f}", number(row["tip_peak_s"], 4),
                      f"{100 * (row['tip_peak_m'] / reference - 1):+.1f} %", number(row["solid_core_s"])])
    header = ["model", "largest tip [mm]", "at [s]", f"relative to {next(iter(names))}", "core seconds of the solid"]
    return ("## Other structural models\n\n20 MPa, 2 mm, `--set solid.model=...`.\n\n" + table(header, lines) +
            "\n" + pictures.draw("swapped", names, figures.swapped))


class Pictures:
    """PNGs in `out`. A picture is kept if some of its runs are not available."""

    def __init__(self, out, histories):
        self.out = out
        self.histories = histories

    def draw(self, name, wanted, figure_of):
        """Saves figure_of(histories by label) of the runs `wanted`, {label: name}; returns the line that shows it."""
        here = {label: self.histories[run] for label, run in wanted.items() if run in self.histories}
        path = self.out / f"{name}.png"
        if here and (len(here) == len(wanted) or not path.exists()):
            self.save(name, figure_of(here))
        return self.line(name) if path.exists() else ""

    def save(self, name, figure):
        figure.savefig(self.out / f"{name}.png", dpi=90)
        figures.plt.close(figure)
        return self.line(name)

    @staticmethod
    def line(name):
        return f"![{name.replace('_', ' ')}]({name}.png)\n"


def draw(pictures, numbers, found):
    """Saves the figures that there are runs for; returns the lines of the page that show them."""
    shown = {}

    def put(name, wanted, figure_of):
        known = {label: run for label, run in wanted.items() if run in numbers.rows}
        shown[name] = pictures.draw(name, known, figure_of)

    tips = {"the paper's settings, 1 mm": "verification_paper_1mm", "recommended, 1 mm": "verification_recommended_1mm",
            "recommended, 2 mm": "verification_recommended_2mm"}
    soft = {f"public code's gamma and alpha, {size} mm": f"verification_public_code_{size}mm" for size in (1, 2)}
    for name, wanted in (("tip", tips), ("tip_public_code", soft)):
        put(name, wanted, lambda histories: figures.fig3_tip(histories, CASE_FOLDER))
    for settings in ("paper", "recommended"):
        put(f"snapshots_{settings}", {settings: f"verification_{settings}_1mm"},
            lambda histories: figures.fig2_snapshots(histories[settings].folder))
    if found:
        shown["convergence"] = pictures.save("convergence", figures.convergence(found))
    for settings, spacing in FAMILIES:
        rows = numbers.family(settings, spacing)
        if len(rows) < 2:
            continue
        tag = f"{settings}_{spacing}"
        names = {label: f"stiffness_{settings}_{label}_{spacing}" for label in rows}
        for label in ("20MPa", "rigid"):
            put(f"spectrum_{label}_{tag}", {label: f"stiffness_{settings}_{label}_{spacing}"},
                lambda histories: figures.fig4_spectrum(histories[label]))
        for probe in ("P01", "P02"):
            put(f"{probe}_{tag}", names, lambda histories: figures.fig6_filtered(histories, probe))
        shown[f"impulses_{tag}"] = pictures.save(f"impulses_{tag}", figures.fig8_impulses(rows))
        put(f"tips_{tag}", names, lambda histories: figures.fig9_tips(histories, rows))
        if spacing == max(("1mm", "2mm"), key=lambda finest: len(numbers.family(settings, finest))):
            put(f"speeds_{tag}", names, lambda histories: figures.fig10_speeds(
                {label: history.folder for label, history in histories.items()}))
    return shown


def write(study, out):
    numbers = record.Numbers(study, out)
    if not numbers.rows:
        sys.exit(f"no finished runs in {study.folder}")
    out.mkdir(parents=True, exist_ok=True)
    record.write(numbers, out / "numbers.csv")
    found = by_spacing(numbers)
    pictures = Pictures(out, numbers.histories)
    shown = draw(pictures, numbers, found)
    take = lambda *names: "\n".join(shown[name] for name in names if shown.get(name))
    parts = ["# Reproduction of the published study\n",
             "Written by `scripts/reproduce`; all numbers are in [numbers.csv](numbers.csv), conclusions in "
             "[findings.md](findings.md). \"Paper\" is Amaro & Cheng ([bibliography](../bibliography.md)). Filter: "
             "Butterworth of 4th order, 70 Hz, forward and backward (no delay). In brackets: deviation from the paper's "
             "number or range.\n",
             "## Verification case (Table 1, Figs. 2 and 3)\n", verification(numbers),
             take("tip", "tip_public_code", "snapshots_paper", "snapshots_recommended"),
             "## Convergence of the first peak\n", convergence(found), take("convergence")]
    for settings, spacing in FAMILIES:
        rows = numbers.family(settings, spacing)
        if len(rows) < 2:
            continue
        tag = f"{settings}_{spacing}"
        parts += [f"## Stiffness (Table 2), {LABELS[settings]}, {spacing}\n", stiffness(rows), differences(rows),
                  take(*(f"{name}_{tag}" for name in ("spectrum_20MPa", "spectrum_rigid", "P01", "P02", "impulses",
                                                      "tips", "speeds")))]
        if "20MPa" in rows:
            parts += ["Peak at P01 at 20 MPa with different filters:\n",
                      filters(rows["20MPa"])]
    parts += ["## Cost\n", "Runs to two seconds; numbers.csv has the time of each run.\n", costs(numbers),
              "## Scatter of the peaks\n",
              "Starts with a lateral acceleration of ten-thousandths of gravity: mean and standard deviation.\n",
              scatter(numbers), open_points.write(numbers.rows), swapped(numbers, pictures),
              finite_width(numbers, pictures), chart.write(numbers, out)]
    (out / "README.md").write_text("\n".join(part for part in parts if part))
