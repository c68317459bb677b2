"""The paper's numbers from a run: Cp = P / (rho g H), tau = t sqrt(g / H), e = thickness of the plate."""
import json

import h5py
import numpy as np
from plots.low_pass import low_passed
from study import core_seconds

GRAVITY, DENSITY, HEIGHT, THICKNESS = 9.81, 1000.0, 0.292, 0.012
PRESSURE = DENSITY * GRAVITY * HEIGHT  # Pa, Cp = 1
RATE = np.sqrt(GRAVITY / HEIGHT)  # 1/s, tau = 1
SPEED = np.sqrt(GRAVITY * HEIGHT)  # m/s, Cv = 1
FILTERS = [(cut_off, order) for cut_off in (50, 70, 100) for order in (2, 4, 8)]  # whose peaks are compared
STEP = 2e-5  # [s] step of the resampled series for the filter, as in the paper
SECOND_PEAK = (4.5, 7.0)  # tau: the upward water falls back
LATE = (7.0, 11.59)  # tau: after it
BLOW = 2.3  # tau: until here the first blow's impulse


class History:
    """What a run recorded every window."""

    def __init__(self, folder):
        self.folder = folder
        with h5py.File(folder / "results.h5") as file:
            self.case = json.loads(file.attrs["case"])
            history = file["history"]
            self.time = history["time"][:]
            rows = len(self.time)
            read = lambda name: history[name][:rows] if name in history else None
            self.pressure = {name: np.nan_to_num(read(f"fluid/{name}")) for name in ("P01", "P02")
                             if f"fluid/{name}" in history}
            self.tip = read("solid/tip_x")
            self.front = read("fluid/front")
            self.created = read("coupling/work_created")
            self.work = read("coupling/work_points")
        if self.tip is None:
            self.tip = np.zeros(rows)

    @property
    def tau(self):
        return self.time * RATE

    def even(self, name):
        """Times and Cp of a pressure probe on even steps."""
        times = np.arange(self.time[0], self.time[-1], STEP)
        return times, np.interp(times, self.time, self.pressure[name]) / PRESSURE


def between(tau, values, limits):
    chosen = values[(tau >= limits[0]) & (tau <= limits[1])]
    return chosen if len(chosen) else np.array([np.nan])


def pressure_numbers(history, name):
    """Peaks, late mean and impulse of one probe; NaN for what lies beyond the end of the run."""
    times, raw = history.even(name)
    tau, smooth = times * RATE, low_passed(raw, 1 / STEP)
    first = tau < SECOND_PEAK[0]
    second = (tau >= SECOND_PEAK[0]) & (tau <= SECOND_PEAK[1])
    fallen = tau[-1] > SECOND_PEAK[1]
    whole = tau[-1] > LATE[1] - 0.01
    return {
        f"{name}_peak": smooth[first].max(), f"{name}_peak_tau": tau[first][smooth[first].argmax()],
        f"{name}_raw_peak": history.pressure[name][history.tau < SECOND_PEAK[0]].max() / PRESSURE,
        f"{name}_second_peak": smooth[second].max() if fallen else np.nan,
        f"{name}_second_peak_tau": tau[second][smooth[second].argmax()] if fallen else np.nan,
        f"{name}_late_mean": between(tau, raw, LATE).mean() if whole else np.nan,
        f"{name}_impulse": np.trapz(raw, tau) if whole else np.nan,
        f"{name}_impulse_first": np.trapz(raw[tau < BLOW], tau[tau < BLOW]) if tau[-1] > BLOW - 0.01 else np.nan,
        f"{name}_noise": np.sqrt(np.mean((raw - smooth)[(tau > 0.8) & first]**2)) / smooth[first].max(),
    }


def tip_numbers(history):
    """Largest displacement of the tip [m] and when; its mean from 0.4 to 0.6 s; its rest after 1.5 s."""
    blow = history.time < 0.5
    peak = history.tip[blow].argmax()
    mean = lambda a, b: history.tip[(history.time >= a) & (history.time <= b)]
    after = mean(1.5, 2.0)
    return {
        "tip_peak_m": history.tip[blow][peak], "tip_peak_s": history.time[blow][peak],
        "tip_over_thickness": np.abs(history.tip).max() / THICKNESS,
        "tip_mean_0.4_to_0.6_m": mean(0.4, 0.6).mean() if history.time[-1] > 0.59 else np.nan,
        "tip_mean_after_1.5_m": after.mean() if history.time[-1] > 1.99 else np.nan,
        "tip_rms_after_1.5_m": after.std() if history.time[-1] > 1.99 else np.nan,
        "first_motion_s": history.time[np.argmax(np.abs(history.tip) > 2e-4)],
    }


def numbers(history, summary):
    arrived = history.front >= 0.292 - 1e-3
    row = {"front_s": history.time[arrived.argmax()] if arrived.any() else np.nan}
    row |= tip_numbers(history)
    for name in ("P01", "P02"):
        row |= pressure_numbers(history, name)
    times, raw = history.even("P01")
    first = times * RATE < SECOND_PEAK[0]
    for cut_off, order in FILTERS:
        row[f"P01_peak_{cut_off}Hz_{order}"] = low_passed(raw, 1 / STEP, cut_off, order)[first].max()
    work = np.abs(history.work).max() if history.work.any() else np.inf
    return row | {"created_over_work": history.created[-1] / work} | cost(summary)


def cost(summary):
    fluid, solid = (summary["participants"][name] for name in ("fluid", "solid"))
    return {"windows": summary["windows"], "core_s": core_seconds(summary), "wall_s": summary["wall_seconds"],
            "solid_core_s": solid["seconds"]["cpu"], "particles": fluid["particles"]}


def relative_difference(values):
    """Eq. (7) of the paper."""
    return (max(values) - min(values)) / min(values)
