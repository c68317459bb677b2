#!/usr/bin/python3
"""A plate that leans on a spring, u_x = q (y / h)^2: a structure in Python, and a program around it.

    cosurge run CASE --solid tests/python/leaning_plate.py        (with the module cosurge in PYTHONPATH)
"""
import numpy as np

import cosurge


class LeaningPlate(cosurge.Solid):
    columns = [("q", "m")]

    def __init__(self, mass=2.0, spring=2000.0):  # per metre of width, of the unknown q [kg/m, N/m2]
        self.mass, self.spring = mass, spring

    def initialize(self, case, position, area, body):
        self.lean = (position[:, 1] / position[:, 1].max())**2
        self.state = np.zeros(2)  # q and its velocity

    def advance(self, window, force):
        q, speed = self.state
        speed += window.size * (force[:, 0] @ self.lean - self.spring * q) / self.mass
        q += window.size * speed
        self.state = np.array([q, speed])
        along_x = np.outer(self.lean, [1, 0])
        return q * along_x, speed * along_x, [q]

    def save(self):
        return self.state.tobytes()

    def restore(self, state):
        self.state = np.frombuffer(state)


if __name__ == "__main__":
    cosurge.serve(LeaningPlate())
