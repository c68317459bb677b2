"""Numbers of the paper (Amaro & Cheng), and the deviation of Cosurge from them."""

# name, description, the paper's range (or number), source
VERIFICATION = [
    ("tip_peak_m", "largest displacement of the tip [m]", (0.039, 0.039), "section 3.1"),
    ("tip_peak_s", "when [s]", (0.21, 0.27), "published band"),
    ("tip_mean_0.4_to_0.6_m", "tip from 0.4 to 0.6 s [m]", (0.015, 0.015), "section 3.1"),
    ("tip_rms_after_1.5_m", "rms deviation from its mean after 1.5 s [m]", (0.0, 0.002), "\"equilibrium after 1.5 s\""),
]
# name, description, range over the elastic plates, rigid plate
STIFFNESS = [
    ("P01_peak", "P01, filtered peak", (1.45, 1.63), 1.67),
    ("P02_peak", "P02, filtered peak", (1.30, 1.42), 1.57),
    ("P01_second_peak", "P01, second peak", (0.50, 0.80), None),
    ("P02_second_peak", "P02, second peak", (0.33, 0.60), None),
    ("P01_late_mean", "P01, mean after the second peak", (0.30, 0.30), 0.30),
    ("P02_late_mean", "P02, mean after the second peak", (0.17, 0.17), 0.17),
    ("P01_impulse", "P01, impulse C_I", (3.78, 3.80), 3.88),
    ("P02_impulse", "P02, impulse C_I", (2.49, 2.56), 2.58),
]
# name, description, relative difference R of eq. (7) between all six plates
DIFFERENCES = [("P01_peak", "peaks at P01", 0.1517), ("P02_peak", "peaks at P02", 0.2077),
               ("P01_impulse", "impulses at P01", 0.0265), ("P02_impulse", "impulses at P02", 0.0361)]
TOLERANCE = 0.10


def deviation(value, band):
    """How far outside the band, over its nearer end; 0 inside."""
    low, high = band
    if low <= value <= high:
        return 0.0
    return value / low - 1 if value < low else value / high - 1


def verdict(value, band):
    if value != value:
        return "not run"
    off = deviation(value, band)
    if off == 0:
        return "inside"
    return f"{100 * off:+.0f} %" + (", within 10 %" if abs(off) <= TOLERANCE else "")
