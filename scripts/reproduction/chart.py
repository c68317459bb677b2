"""The speed-accuracy chart: error against core seconds, one point a setting."""
import numpy as np
from matplotlib.ticker import LogLocator, PercentFormatter

import runs
import tables
from figures import plt

TEXTS, DIGITS = ("scene", "setting"), 4  # columns of chart.csv
MEASURES = {"tip_peak_m": "tip, largest", "tip_rms": "tip, history", "P01_peak": "P01, filtered peak",
            "P02_peak": "P02, filtered peak", "P01_impulse_first": "P01, impulse of the impact"}


def tip_rms(history, truth):
    """Root mean square of the difference of two tip histories, over the largest of the truth's."""
    time = np.arange(0, min(history.time[-1], truth.time[-1], runs.CHART_END), 1e-4)
    difference = np.interp(time, history.time, history.tip) - np.interp(time, truth.time, truth.tip)
    return np.sqrt(np.mean(difference**2)) / np.abs(truth.tip).max()


def truth_of(numbers, scene):
    """The finest run with the recommended settings; 2 mm is not fine enough."""
    names = [f"chart_{scene}_recommended_1mm"]
    if scene == "1MPa":
        names.insert(0, "verification_recommended_0.5mm")
    return next((name for name in names if name in numbers.rows), None)


def points(numbers, scene):
    """Rows of the chart: setting, core seconds, errors."""
    truth = truth_of(numbers, scene)
    rows = []
    for name, row in numbers.rows.items():
        if truth is None or name == truth or not name.startswith(f"chart_{scene}_"):
            continue
        errors = {key: abs(row[key] / numbers.rows[truth][key] - 1) for key in MEASURES if key != "tip_rms"}
        errors["tip_rms"] = tip_rms(numbers.histories[name], numbers.histories[truth])
        setting = name.removeprefix(f"chart_{scene}_")
        rows.append({"scene": scene, "setting": setting, **tables.rounded({"core_s": row["core_s"]} | errors, DIGITS)})
    return truth, sorted(rows, key=lambda row: row["core_s"])


def pareto(rows, key):
    """Settings that no cheaper one exceeds in accuracy."""
    best, front = np.inf, []
    for row in rows:
        if row[key] < best:
            best = row[key]
            front.append(row)
    return front


def scatter_of(numbers, key):
    """Relative standard deviation between perturbed starts of the 20 MPa plate at 2 mm."""
    values = [row[key] for name, row in numbers.rows.items() if name.startswith("scatter_recommended_20MPa_")]
    return np.std(values, ddof=1) / np.mean(values) if len(values) > 1 else 0.0


LOWEST = 5e-4  # error: nearer than this is drawn here
MARKERS = "osD^v<>pX*Phd"


def draw(rows, numbers, scene, truth):
    figure, grid = plt.subplots(2, 3, layout="constrained", figsize=(15, 9))
    settings = [run.name.removeprefix(f"chart_{scene}_") for run in runs.chart() if f"_{scene}_" in run.name]
    styles = {setting: {"marker": MARKERS[k % len(MARKERS)], "color": plt.get_cmap("tab10")(k % 10)}
              for k, setting in enumerate(settings)}  # the same in all charts
    for axes, (key, title) in zip(grid.flat, MEASURES.items()):
        spread = scatter_of(numbers, key) if key != "tip_rms" else 0
        front = pareto(rows, key)
        axes.plot([row["core_s"] for row in front], [max(row[key], LOWEST) for row in front], "-", color="0.3", lw=1)
        for row in rows:
            error = max(row[key], LOWEST)
            axes.errorbar(row["core_s"], error, yerr=[[min(spread, error - 0.8 * LOWEST)], [spread]], ecolor="0.8",
                          elinewidth=1, ms=10 if row in front else 6, mec="black" if row in front else "none", ls="",
                          label=row["setting"].replace("_", " "), **styles[row["setting"]])
        axes.set(xscale="log", yscale="log", xlabel="core seconds", title=title, ylabel="error",
                 ylim=(0.8 * LOWEST, None))
        axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter("")
        axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=1))
        axes.margins(x=0.15)
    grid[-1, -1].axis("off")
    grid[-1, -1].legend(*axes.get_legend_handles_labels(), loc="center", fontsize=11)
    figure.suptitle(f"{scene}: error against {truth.replace('_', ' ')}, over cost; bars: scatter between perturbed "
                    "starts; line and black edges: no cheaper setting has a smaller error")
    return figure


def fronts(rows):
    """The settings on the line of each measure, the cheapest first."""
    lines = []
    for key, title in MEASURES.items():
        steps = [f"{row['setting'].replace('_', ' ')} ({row['core_s']:.0f} s, {100 * row[key]:.1f} %)"
                 for row in pareto(rows, key)]
        lines.append(f"- {title}: " + "; ".join(steps))
    return "\n".join(lines) + "\n"


def write(numbers, out):
    """Draws the chart and writes chart.csv; returns the part of the page.

    A scene stays as it is where not all of its runs are at hand.
    """
    kept = tables.read(out / "chart.csv", TEXTS)
    parts, all_rows = [], []
    for scene in runs.SCENES:
        wanted = [name for name in numbers.rows if name.startswith(f"chart_{scene}_")]
        if {truth_of(numbers, scene), *wanted} <= set(numbers.histories):
            truth, rows = points(numbers, scene)
            figure = draw(rows, numbers, scene, truth)
            figure.savefig(out / f"chart_{scene}.png", dpi=90)
            plt.close(figure)
        else:
            rows = [row for row in kept if row["scene"] == scene]
        if len(rows) < 3:
            continue
        all_rows += rows
        parts += [f"![speed and accuracy, {scene}](chart_{scene}.png)\n",
                  f"{scene}: settings that no cheaper one exceeds in accuracy, core seconds and error\n", fronts(rows)]
    if not parts:
        return ""
    tables.write(out / "chart.csv", "scripts/reproduce chart scatter verification", all_rows, TEXTS, DIGITS)
    return "\n".join(["## Speed against accuracy\n", *parts])
