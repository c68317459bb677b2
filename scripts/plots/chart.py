"""Error over cost of `cosurge chart`."""
import csv
import itertools
import sys

from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from plots.style import plt

MARKERS = "osD^v<>pX*Ph"


def read(path):
    """Rows of chart.csv: {column: text}. Ends the program where the file is no chart."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if not rows or "core_seconds" not in rows[0]:
        sys.exit(f"{path}: is no table of cosurge chart")
    return rows


def quantities(rows):
    """(name, unit) of each quantity."""
    names = [column[:-len(" over_front")] for column in rows[0] if column.endswith(" over_front")]
    return [(name, next(c for c in rows[0] if c.startswith(f"{name} [")).split("[")[1][:-1]) for name in names]


def keys(rows):
    return list(itertools.takewhile(lambda column: column != "state", rows[0]))


def styles(rows, varied):
    """Colour by the first key that is varied, marker by all others together."""
    firsts = list(dict.fromkeys(row[varied[0]] for row in rows))
    others = list(dict.fromkeys(tuple(row[key] for key in varied[1:]) for row in rows))
    colors = plt.get_cmap("tab10")
    return [{"color": colors(firsts.index(row[varied[0]]) % 10),
             "marker": MARKERS[others.index(tuple(row[key] for key in varied[1:])) % len(MARKERS)]} for row in rows]


def label_of(row, varied):
    """Settings in short: the last word of each key, without a key that changes with the one before it."""
    return ", ".join(f"{key.rsplit('.', 1)[-1]} {row[key] or 'as in the case'}" for key in varied)


def telling(rows):
    """Keys that are varied, without those that only follow another one."""
    varied = [key for key in keys(rows) if len({row[key] for row in rows}) > 1] or keys(rows)[:1]
    kept = []
    for key in varied:
        if not any(len({(row[key], row[other]) for row in rows}) == len({row[other] for row in rows}) for other in kept):
            kept.append(key)
    return kept


def plain(axis):
    """Plain numbers at 1, 2, 3 and 5 times the powers of ten."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 3, 5)))
    axis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def panel(axes, rows, name, unit, varied, style):
    points = [(float(row["core_seconds"]), float(row[f"{name} error"]), row, look) for row, look in zip(rows, style)
              if row["state"] == "finished" and row[f"{name} error"] and float(row[f"{name} error"]) > 0]
    front = sorted((cost, error) for cost, error, row, _ in points if row[f"{name} front"] == "yes")
    axes.plot(*zip(*front), color="0.4", lw=1, zorder=1)
    for cost, error, row, look in points:
        own = row[f"{name} front"] == "yes"
        low, high = float(row[f"{name} lowest"]), float(row[f"{name} highest"])
        if high > low:
            axes.plot([cost, cost], [max(low, 1e-3 * error), high], color="0.75", lw=1, zorder=1)
        axes.plot([cost], [error], ls="", ms=9 if own else 6, mec="black" if own else "none", zorder=2,
                  label=label_of(row, varied), **look)
    truth = [abs(float(row[f"{name} truth"])) for row in rows if row[f"{name} truth"]]
    axes.set(xscale="log", yscale="log", xlabel="core seconds", ylabel=f"error [{unit}]", title=name)
    plain(axes.xaxis)
    plain(axes.yaxis)
    if truth and max(truth) > 0:
        right = axes.secondary_yaxis("right", functions=(lambda e: 100 * e / max(truth), lambda p: p * max(truth) / 100))
        right.set_ylabel("% of the true value")
        plain(right.yaxis)
    axes.margins(0.12)


def draw(rows):
    names, varied = quantities(rows), telling(rows)
    figure, grid = plt.subplots(1, len(names) + 1, squeeze=False, layout="constrained",
                                figsize=(3.2 + 4.4 * len(names), 4.4), gridspec_kw={"width_ratios": [1] * len(names) + [0.55]})
    style = styles(rows, varied)
    labels = {}
    for axes, (name, unit) in zip(grid.flat, names):
        panel(axes, rows, name, unit, varied, style)
        labels |= {label: handle for handle, label in zip(*axes.get_legend_handles_labels())}
    grid.flat[-1].axis("off")
    grid.flat[-1].legend(labels.values(), labels.keys(), loc="center left", fontsize=9,
                         title="line, black edges:\nthe Pareto front")
    return figure
