#!/usr/bin/env python3
"""Draws the tables of limits in docs/stability.md; the name of the table selects the picture.

scripts/plot_limits.py docs/tables/solid_steps.csv docs/pictures/solid_steps.png
"""
import csv
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROOT = Path(__file__).resolve().parent.parent
BLUE, ORANGE, RED, VIOLET, GREY = "#2a7ab9", "#e8a33d", "#b3262a", "#7a5ab9", "#999999"
MARKS = {"stable": ("o", BLUE, "stable"), "growing": ("s", ORANGE, "bounded, grows or alternates"),
         "draining": ("D", VIOLET, "bounded, energy drains"), "lost": ("s", ORANGE, "particles lost"),
         "blown_up": ("x", RED, "blown up")}


def read(table):
    with open(table, newline="") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    return [{key: number(value) for key, value in zip(rows[0], row)} for row in rows[1:]]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def groups(rows, *keys):
    """Rows by the values of keys, in their order."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found


def scatter(plot, rows, x, y):
    for state, (marker, colour, label) in MARKS.items():
        some = [row for row in rows if row["state"] == state]
        if some:
            plot.scatter([row[x] for row in some], [row[y] for row in some], marker=marker, color=colour,
                         label=label, s=30)


def legend_above(figure, plots):
    seen = {}
    for plot in np.ravel(plots):
        for handle, label in zip(*plot.get_legend_handles_labels()):
            seen.setdefault(label, handle)
    rows = -(-len(seen) // 5)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - (0.1 + 0.22 * rows) / figure.get_figheight()))
    figure.legend(seen.values(), seen.keys(), loc="upper center", ncol=5, fontsize=8, frameon=False)


def solid_steps(rows):
    models = groups(rows, "model")
    figure, plots = plt.subplots(1, len(models), figsize=(10, 3.6), sharey=True, layout="constrained")
    for plot, ((model,), some) in zip(plots, models.items()):
        small = [row for row in some if row["speed_over_c_p"] == min(r["speed_over_c_p"] for r in some)]
        for row in small:
            row["step"] = row["share"] * row["stated_c_p_over_l0"]
        scatter(plot, small, "poisson_ratio", "step")
        limits = {row["poisson_ratio"]: row["stated_c_p_over_l0"] for row in small}
        plot.plot(list(limits), list(limits.values()), color="black", lw=1.6, label="stated: 2 / omega_max of the body")
        nu = np.linspace(0, 0.47, 100)
        if model.startswith("mps"):  # omega_max = sqrt(24) c_s / l0
            ratio = np.sqrt((2 - 2 * nu) / (1 - 2 * nu))  # c_p / c_s
            plot.plot(nu, 2 / np.sqrt(24) * ratio, "k:", lw=1.4, label="lattice: 0.408 l0 / c_s")
        plot.set_title(model, fontsize=10)
        plot.set_xlabel("Poisson's ratio")
    plots[0].set_ylabel("step, in l0 / c_p")
    legend_above(figure, plots)
    return figure


def solid_zero_modes(rows):
    shapes = read(ROOT / "docs/tables/solid_zero_mode.csv")
    figure, plots = plt.subplots(1, 3, figsize=(10, 5), layout="constrained", width_ratios=[1, 1, 1.7])
    for plot, ((stabilisation,), some) in zip(plots, groups(shapes, "stabilisation").items()):
        x, y, u, v = (np.array([row[key] for row in some]) for key in ("x", "y", "u_x", "u_y"))
        plot.scatter(x, y, s=4, color=GREY)
        plot.quiver(x, y, u, v, angles="xy", scale_units="xy", scale=0.8, color=RED if stabilisation == 0 else BLUE,
                    width=0.006)
        plot.set_aspect("equal")
        plot.set_title(f"stabilisation {stabilisation:g}:\n{some[0]['frequency']:.1e} c_p / l0", fontsize=9)
        plot.set_xlabel("x / l0")
    plots[0].set_ylabel("y / l0")
    for (clamped,), some in groups(rows, "clamped").items():
        name = "clamped" if clamped == "true" else "free"
        x = [max(row["stabilisation"], 3e-5) for row in some]
        plots[2].plot(x, [row["slower_than_bending"] for row in some], "o-", label=f"{name} block",
                      color=BLUE if name == "free" else ORANGE)
    plots[2].axhline(3, color="black", lw=1, ls=":", label="theory: 3 free, 0 clamped")
    plots[2].axhline(0, color="black", lw=1, ls=":")
    plots[2].set_xscale("log")
    plots[2].set_xlabel("stabilisation (at the left end: 0)")
    plots[2].set_ylabel("motions slower than the first bending")
    plots[2].legend(fontsize=8)
    return figure


def fluid_column(rows):
    sources = groups(rows, "source")
    figure, plots = plt.subplots(2, len(sources), figsize=(11, 6.4), sharex=True, sharey="row", layout="constrained")
    for (upper, lower), ((source,), some) in zip(plots.T, sources.items()):
        scatter(upper, some, "courant", "compressibility")
        for row in some:
            if row["state"] != "blown_up":
                upper.annotate(f"{100 * row['volume']:.0f}", (row["courant"], row["compressibility"]), fontsize=7,
                               textcoords="offset points", xytext=(0, 5), ha="center")
        # Too dense by alpha P / gamma, or alpha P / (k dt)^2, under 0.15 m of water; k = c / l0 = 250 / s
        run = [row for row in some if row["compressibility"] == 1e-9 and row["state"] != "blown_up"]
        mends = [(250 * row["end"] / row["windows"])**2 if source.startswith("time_scale") else 0.01 for row in run]
        upper.plot([row["courant"] for row in run], [0.05 * s / 1500 for s in mends], "k-", lw=1.4,
                   label="theory: 5 % too dense")
        upper.set_title(source, fontsize=10)
        for (alpha,), line in groups(some, "compressibility").items():
            line = [row for row in line if row["state"] != "blown_up"]
            lower.plot([row["courant"] for row in line], [row["noise"] for row in line], "o-", ms=3,
                       label=f"alpha = {alpha:g} / Pa")
        lower.set_xlabel("Courant number")
        for plot in (upper, lower):
            plot.axvline(0.5, color="black", lw=1, ls="--", label="largest in a case")
            plot.set_xscale("log")
            plot.set_yscale("log")
    plots[0][0].set_ylabel("alpha [1/Pa]; numbers: volume off, %")
    plots[1][0].set_ylabel("noise of the floor's pressure / rho g H")
    legend_above(figure, plots)
    return figure


def turning_patch(rows):
    figure, plots = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
    for (gradient, shifting, lowest), some in groups(rows, "gradient", "shifting", "lowest_pressure").items():
        if lowest == 0 and (gradient, shifting) != ("corrected", 0):
            continue  # the same for all
        colour = GREY if lowest == 0 else {"p_min": RED, "conserving": ORANGE, "corrected": BLUE}[gradient]
        name = "pressure >= 0, any gradient" if lowest == 0 else f"{gradient}{' with shifting' if shifting else ''}"
        for plot, key in zip(plots, ("filled", "pressure", "energy")):
            t, y = [row["time"] for row in some], [row[key] for row in some]
            plot.plot(t, y, "o-" if gradient == "conserving" else "-", ms=3, color=colour, label=name,
                      lw=4 if lowest == 0 else 2.5 if shifting else 1.2, alpha=0.5 if shifting or lowest == 0 else 1)
            if np.isnan(y[-1]):
                plot.plot([t[-1]], [y[-2]], "x", color=colour, ms=8)
    t = np.linspace(0, 2, 100)
    plots[0].plot(t, 1 / (1 + t**2), "k--", lw=1, label="theory")
    plots[0].axhline(1, color="black", ls="--", lw=1)
    plots[1].plot([0, 0.3], [-0.1473] * 2, "k--", lw=1)
    plots[2].axhline(1, color="black", ls="--", lw=1)
    for plot, title in zip(plots, ("share of the middle that is filled", "pressure in the middle / rho omega^2 L^2",
                                   "energy / first")):
        plot.set_title(title, fontsize=9)
        plot.set_xlabel("omega t")
    legend_above(figure, plots)
    return figure


def coupling_order(rows):
    sys.path.insert(0, str(ROOT / "benchmarks"))
    import coupling_theory
    rows = [row for row in rows if row["substeps"] > 1]
    figure, plots = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    windows = np.geomspace(20, 250, 30)
    for k, ((scheme, velocity, load), some) in enumerate(groups(rows, "scheme", "velocity", "load").items()):
        colour = plt.cm.tab10(k)
        hidden = scheme == "weak_inertial" or (scheme, velocity, load) == ("weak", "mean", "held")  # below another's marks
        words = ("weak" if scheme == "weak" else "strong", velocity, load, "last" if scheme == "weak" else "any")
        theory = np.array([coupling_theory.errors(n, *words) for n in windows])
        for plot, key, line in zip(plots, ("frequency", "lost"), theory.T):
            if np.max(np.abs(line)) < 1e-9:
                plot.plot([], [], "o-", color=colour, label=f"{scheme}, {velocity}, {load}")
                continue
            plot.plot(windows, np.abs(line), color=colour, lw=1)
            plot.plot([row["windows"] for row in some], [abs(row[key]) for row in some],
                      "s" if hidden else "o", mfc="none" if hidden else colour, ms=9 if hidden else 5, color=colour,
                      ls="none", label=f"{scheme}, {velocity}, {load}")
    for plot, title in zip(plots, ("error of the frequency (second order)", "amplitude lost in a period (first order, or none)")):
        plot.set_xscale("log")
        plot.set_yscale("log")
        plot.set_title(title, fontsize=10)
        plot.set_xlabel("windows a period (lines: theory)")
        plot.set_xticks([25, 50, 100, 200], ["25", "50", "100", "200"])
        plot.minorticks_off()
        plot.grid(alpha=0.3, which="both")
    legend_above(figure, plots)
    return figure


def plate_density(rows):
    schemes = groups(rows, "coupling.scheme")
    figure, plots = plt.subplots(1, len(schemes), figsize=(12, 4.2), sharey=True, layout="constrained")
    for plot, ((scheme,), some) in zip(plots, schemes.items()):
        for row in some:
            row["window"] = 1e3 * row["time.window"]
        scatter(plot, some, "solid.density", "window")
        for row in some:
            words = f"{row['seconds'] / max(row['end'], 1e-9):.0f} s" if row["state"] == "stable" else ""
            plot.annotate(words, (row["solid.density"], row["window"]), textcoords="offset points", xytext=(0, 5),
                          ha="center", fontsize=6)
        plot.set_xscale("log")
        plot.set_yscale("log")
        plot.set_title(scheme.replace("/", ", "), fontsize=9)
        plot.set_xlabel("rho_s [kg/m3]")
    measured = [row for row in rows if row["coupling.scheme"] == "strong" and row["time.window"] == 2e-4]
    mu, density = np.array(sorted((np.log(row["ratio"]), np.log(row["solid.density"])) for row in measured)).T
    plots[0].axvline(np.exp(np.interp(0, mu, density)), color="black", lw=1.4,
                     label="theory: mu = 1, as strong measures it")
    plots[0].set_ylabel("window [ms]; numbers: cost of a second")
    legend_above(figure, plots)
    return figure


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    table = Path(sys.argv[1])
    pictures = {name.__name__: name for name in (solid_steps, solid_zero_modes, fluid_column, turning_patch,
                                                 coupling_order, plate_density)}
    if table.stem not in pictures:
        raise SystemExit(f"{table}: no picture of that name; there are {', '.join(pictures)}")
    pictures[table.stem](read(table)).savefig(sys.argv[2], dpi=130)


if __name__ == "__main__":
    main()
