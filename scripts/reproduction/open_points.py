"""Open points and misprints of the paper, resolved by runs."""
import math

import h5py
import numpy as np

import measures
import runs

LENGTH = 0.080  # length of the plate [m]


def substeps(rows):
    """Stability of the explicit solid over 4000 steps of each size."""
    lines = ["| E | 1e-6 s | 5e-7 s | 5e-8 s |", "| --- | --- | --- | --- |"]
    words = {"finished": "stable", "failed": "above its stable step"}
    for label, modulus in runs.STIFFNESS.items():
        if modulus:
            names = [runs.substep_name(modulus, substep) for substep in (1e-6, 5e-7, 5e-8)]
            cells = [words[rows[name]["status"]] if name in rows else "" for name in names]
            lines.append(f"| {label} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def normals(folder, case, time=0.23):
    """Largest angles [degrees] along the wet face of the true normal to F^-T n, and to the paper's F^T n; by name."""
    with h5py.File(folder / "results.h5") as file:
        instants = file["frames/time"][:]
        if instants[-1] < time:
            return {}
        first, now = (file["frames/solid/position"][k] for k in (0, int(np.abs(instants - time).argmin())))
    spacing = case["solid"].get("spacing", case["fluid"]["spacing"])
    free = first[:, 1] > 0
    first, now = first[free], now[free]
    rank = np.lexsort((first[:, 1], np.round(first[:, 0] / spacing)))
    face = rank[:int(round(LENGTH / spacing))]  # the column of particles with the smallest x, from the foot up
    way = np.gradient(now[face], axis=0)
    true = np.stack([-way[:, 1], way[:, 0]], axis=1)
    largest = {"normal_off_deg": 0.0, "printed_normal_off_deg": 0.0}
    for i, normal in zip(face, true):
        near = np.flatnonzero((np.linalg.norm(first - first[i], axis=1) < 2.1 * spacing))
        near = near[near != i]
        before, after = first[near] - first[i], now[near] - now[i]
        F = (after.T @ before) @ np.linalg.inv(before.T @ before)
        for name, turned in zip(largest, (np.linalg.inv(F).T @ (-1, 0), F.T @ (-1, 0))):
            cosine = turned @ normal / np.linalg.norm(turned) / np.linalg.norm(normal)
            largest[name] = max(largest[name], np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    return largest


def write(rows):
    """Part of the page; `rows`: the numbers by the name of the run."""
    parts = ["## Open points of the paper\n"]
    if runs.substep_name(2e10, 1e-6) in rows:
        parts += ["The sub-step for each stiffness: a plate of `mps` on 1 mm, 4000 sub-steps.\n",
                  substeps(rows)]
    tips = {name: 1000 * measures.THICKNESS * rows[f"open_{name}"]["tip_over_thickness"]
            for name in ("area", "volume") if f"open_{name}" in rows}
    if len(tips) == 2:
        parts.append(f"Equation (1) with l0^(d-1), an area, gives a tip displacement of {tips['area']:.1f} mm (1 MPa, 4 mm); "
                     f"with l0^d as printed, {tips['volume']:.2f} mm.\n")
    for name in ("verification_paper_1mm", "verification_recommended_2mm"):
        if name in rows and not math.isnan(rows[name].get("normal_off_deg", math.nan)):
            row = rows[name]
            parts.append(f"Equation (2): at 0.23 s, along the wet face of `{name}`, the largest error of the "
                         f"normal by F^-T n is {row['normal_off_deg']:.1f} degrees, by F^T n as printed "
                         f"{row['printed_normal_off_deg']:.0f} degrees.\n")
            break
    return "\n".join(parts)
