"""The low-pass for impact pressures: Butterworth, forward and backward, so that it has no delay."""
from scipy.signal import butter, sosfiltfilt

CUT_OFF, ORDER = 70.0, 4  # Hz: the published study's cut-off, which leaves the order open


def low_passed(values, rate, cut_off=CUT_OFF, order=ORDER):
    """An even series of `rate` [Hz]; None where it is too short or too coarse."""
    if rate <= 2.5 * cut_off or len(values) < rate / cut_off:
        return None
    return sosfiltfilt(butter(order, cut_off, fs=rate, output="sos"), values)
