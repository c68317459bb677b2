"""The reduced reproduction, 2 mm and 1 s: numbers that a change of the code must not move.

Bands: ours, widened by twice the scatter between perturbed starts (docs/reproduction), and by 3 % where that is less.
"""
import measures
import runs

BANDS = {
    "reduced_verification": {"front_s": (0.122, 0.130), "first_motion_s": (0.130, 0.145),
                             "tip_peak_m": (0.0455, 0.0495), "tip_peak_s": (0.215, 0.240),
                             "tip_mean_0.4_to_0.6_m": (0.0135, 0.0195),
                             "P01_noise": (0.0, 0.08), "created_over_work": (-0.05, 0.05)},
    "reduced_20MPa": {"P01_peak": (1.35, 1.75), "P02_peak": (1.10, 1.50), "P01_impulse_first": (1.18, 1.30),
                      "tip_over_thickness": (0.42, 0.62), "P01_noise": (0.0, 0.08)},
    "reduced_rigid": {"P01_peak": (1.35, 1.85), "P02_peak": (1.10, 1.60), "P01_impulse_first": (1.18, 1.30),
                      "P01_noise": (0.0, 0.08)},
}


def check(study):
    """Prints every number beside its band; True when all lie inside."""
    fine = True
    for run in runs.reduced():
        if not study.finished(run):
            print(f"FAILED: {run.name} did not finish")
            fine = False
            continue
        row = measures.numbers(measures.History(study.folder_of(run)), study.summary(run))
        for key, (low, high) in BANDS[run.name].items():
            inside = low <= row[key] <= high
            fine = fine and inside
            print(f"{'ok    ' if inside else 'FAILED'} {run.name} {key} = {row[key]:.4g} ({low:g} to {high:g})")
    return fine
