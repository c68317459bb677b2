#!/usr/bin/env python3
"""Stability and order in time of the coupling schemes on a mass on a spring under a column of water, by the eigenvalues
of the update (docs/method.md, section 3).

benchmarks/coupling_theory.py > docs/tables/coupling_theory.csv

critical       largest stable ratio mu of added mass to mass, with windows short against the period; inf: none found to 1e4
frequency      relative error of the wet frequency at 100 windows a period, mu = 0.5
damping        amplitude lost in a period, there
orders         of the two in the window
"""
import numpy as np


def solid(q, v, first, last, omega, h):
    """q'' = -omega^2 q + load, a load per mass that goes linearly from first to last: exact."""
    rest, slope = first / omega**2, (last - first) / h / omega**2
    a, b = q - rest, (v - slope) / omega
    c, s = np.cos(omega * h), np.sin(omega * h)
    return a * c + b * s + rest + slope * h, -a * omega * s + b * omega * c + slope


def update(mu, h, scheme, velocity, load, prediction, omega):
    """The matrix from window to window, for m = 1. State: q, v, load, velocity seen, last and last but one sent."""

    def window(state):
        q, v, f_last, seen_last, sent, sent_before = state

        def answer(f):
            q_new, v_new = solid(q, v, f if load == "held" else f_last, f, omega, h)
            return q_new, v_new, (q_new - q) / h if velocity == "mean" else v_new

        if scheme == "weak":
            seen = sent if prediction == "last" else 2 * sent - sent_before
            f = -mu * (seen - seen_last) / h
        else:  # the load agrees with the velocity that comes out
            free = answer(0)[2]
            mobility = answer(1)[2] - free
            f = -mu * (free - seen_last) / h / (1 + mu * mobility / h)
            seen = free + mobility * f
        q_new, v_new, sent_new = answer(f)
        return np.array([q_new, v_new, f, seen, sent_new, sent])

    zero = window(np.zeros(6))
    return np.array([window(unit) - zero for unit in np.eye(6)]).T


def critical(*words):
    def stable(mu):
        # A free mass: 1 is the eigenvalue of its uniform motion, twice.
        values = np.linalg.eigvals(update(mu, 1.0, *words, 1e-4))
        return np.max(np.abs(values)) < 1 + 1e-3

    low, high = 0.01, 1e4
    if stable(high):
        return np.inf
    while high / low > 1 + 1e-4:
        middle = np.sqrt(low * high)
        low, high = (middle, high) if stable(middle) else (low, middle)
    return low


def errors(windows, *words, mu=0.5):
    h = 2 * np.pi / windows  # the wet frequency is 1
    values = np.linalg.eigvals(update(mu, h, *words, np.sqrt(1 + mu)))
    wave = min((z for z in values if z.imag > 1e-9), key=lambda z: abs(np.angle(z) / h - 1))
    return np.angle(wave) / h - 1, 1 - np.exp(2 * np.pi * np.log(abs(wave)) / h)


def order(coarse, fine):
    return f"{np.log2(abs(coarse / fine)):.2f}" if abs(fine) > 1e-10 else "exact"


def main():
    print("# benchmarks/coupling_theory.py > docs/tables/coupling_theory.csv")
    print("scheme,velocity,load,prediction,critical,frequency,order,damping,order")
    for scheme in ("weak", "strong or weak_inertial"):
        for velocity in ("end", "mean"):
            for load in ("held", "ramped"):
                for prediction in ("last", "extrapolated") if scheme == "weak" else ("any",):
                    words = (scheme, velocity, load, prediction)
                    try:
                        coarse, fine = errors(100, *words), errors(200, *words)
                    except ValueError:
                        continue
                    print(*words, f"{critical(*words):.3g}", f"{coarse[0]:.1e}", order(coarse[0], fine[0]),
                          f"{coarse[1]:.1e}", order(coarse[1], fine[1]), sep=",")


if __name__ == "__main__":
    main()
