"""Wall time of a run by phase."""
import numpy as np

from plots.style import plt


def phases(run):
    """Seconds of every phase by process, the longest first."""
    bars = {}
    for process in ("fluid", "solid", "coupling"):
        spent = {name.replace("_", " "): values[-1] for name, values in run.columns(process, "seconds_").items()}
        if spent:
            bars[process] = spent
    exchange = run.summary.get("exchange_seconds")
    if exchange is not None and "exchange" not in bars.get("coupling", {}):
        bars.setdefault("coupling", {})["exchange"] = exchange
    return {process: dict(sorted(spent.items(), key=lambda item: -item[1])) for process, spent in bars.items()}


def timing(run):
    if not len(run.time):
        return None
    bars = phases(run)
    if not bars:
        return None
    maps = {"fluid": "Blues", "solid": "Oranges", "coupling": "Greys"}
    figure, axes = plt.subplots(layout="constrained", figsize=(10, 1.6 + 0.9 * len(bars)))
    whole = sum(sum(spent.values()) for spent in bars.values())
    for process, spent in bars.items():
        shades = plt.get_cmap(maps[process])(np.linspace(0.75, 0.3, len(spent) + 1)[:-1])
        start = 0
        for (name, seconds), shade in zip(spent.items(), shades):
            share = f"{process}: {name}, {seconds:.3g} s ({100 * seconds / whole:.1f} %)" if whole > 0 else name
            axes.barh(process, seconds, left=start, color=shade, edgecolor="white", label=share)
            start += seconds
        cpu = run.history.get(f"{process}/cpu_seconds")
        if cpu is not None:
            axes.plot([cpu[-1]] * 2, [list(bars).index(process) - 0.4, list(bars).index(process) + 0.4], "k:", lw=1.2)
            axes.annotate(" CPU", (cpu[-1], list(bars).index(process) - 0.38), fontsize=8, va="top")
    wall = run.summary.get("wall_seconds")
    until = f", wall {wall:.3g} s" if wall else ""
    axes.set(xlabel="seconds of wall time", title=f"{run.title}: until t = {run.time[-1]:.3f} s{until}")
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.05))
    return figure
