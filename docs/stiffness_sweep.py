#!/usr/bin/python3
"""The dam break on plates from 20 MPa to 200 GPa (Amaro & Cheng, Table 2): peak deflection and impulse on the plate's face."""
import cosurge

STEEL = {"solid.density": 7800, "solid.poisson_ratio": 0.3, "time.end": 0.6}
CASE = "cases/dam_break_plate"

print("E [Pa]   peak [mm]  at [s]  impulse of P01 [Pa s]")
for values, run in cosurge.sweep(CASE, {"solid.young_modulus": [2e7, 2e8, 2e9, 2e10, 2e11]}, "results/stiffness", STEEL):
    tip, pressure = run["solid/tip_x"], run["fluid/P01"]
    print(f"{values['solid.young_modulus']:.0e}  {1e3 * tip.peak:9.4f}  {tip.time_of_peak:6.4f}  {pressure.impulse:8.1f}")
