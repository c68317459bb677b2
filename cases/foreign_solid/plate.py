#!/usr/bin/python3
"""An external structure for Cosurge: an upright cantilever by its lowest bending modes (Euler-Bernoulli), in Python.

    cosurge run cases/foreign_solid --solid cases/foreign_solid/plate.py

docs/write_your_own_solid.md explains it.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import zmq

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROTOCOL, ROOTS = 2, np.array([1.87510407, 4.69409113, 7.85475744])  # roots of cos x cosh x = -1
MODES = len(ROOTS)
with tempfile.TemporaryDirectory() as folder:  # compile the messages
    subprocess.run(["protoc", f"-I{ROOT}", f"--python_out={folder}", "proto/case.proto", "proto/exchange.proto"],
                   cwd=ROOT, check=True)
    sys.path.insert(0, folder)
    from proto import exchange_pb2 as wire


class Plate:
    """Deflection u = sum of q_k phi_k(height) along x, and the rotation that belongs to it; each mode an oscillator."""

    def __init__(self, case, points):
        solid = case.solid
        low, high = np.array(solid.body[0].box.min), np.array(solid.body[0].box.max)
        thickness, length = high - low
        stiffness = solid.young_modulus / (1 - solid.poisson_ratio**2) * thickness**3 / 12
        self.omega = np.sqrt(stiffness / (solid.density * thickness)) * np.square(ROOTS / length)
        self.points, self.H, self.mass = points, np.zeros((points.size, MODES)), np.empty(MODES)
        grid, x, y = np.linspace(0, length, 4001), points[:, 0] - (low[0] + high[0]) / 2, points[:, 1] - low[1]
        for n, kn in enumerate(ROOTS / length):
            s = (np.cosh(kn * length) + np.cos(kn * length)) / (np.sinh(kn * length) + np.sin(kn * length))
            phi = lambda y: np.cosh(kn * y) - np.cos(kn * y) - s * (np.sinh(kn * y) - np.sin(kn * y))
            slope = lambda y: kn * (np.sinh(kn * y) + np.sin(kn * y) - s * (np.cosh(kn * y) - np.cos(kn * y)))
            self.H[0::2, n] = phi(y)
            self.H[1::2, n] = -x * slope(y)
            self.mass[n] = solid.density * thickness * np.trapz(phi(grid)**2, grid)
        self.state = self.start = np.zeros(2 * MODES + 1)  # amplitudes, their velocities, the work done so far
        self.probes = {p.name: np.linalg.norm(points - p.position, axis=1).argmin() for p in case.output.probe
                       if p.quantity == p.displacement}

    def advance(self, window, force):
        self.start = self.state = self.start if window.attempt > 1 else self.state
        q, v, work = self.state[:MODES], self.state[MODES:-1], self.state[-1]
        load = self.H.T @ force
        rest, angle = load / (self.mass * self.omega**2), self.omega * window.size
        new = rest + (q - rest) * np.cos(angle) + v / self.omega * np.sin(angle)  # exact, around the new rest position
        velocity = v * np.cos(angle) - (q - rest) * self.omega * np.sin(angle)
        self.state = np.concatenate([new, velocity, [work + load @ (new - q)]])
        moved = self.H @ new
        values = [self.state[-1], *(moved[2 * k + axis] for k in self.probes.values() for axis in (0, 1))]
        return wire.Motion(displacement=moved, velocity=self.H @ (new - q) / window.size), values


def answer(request, plate):
    call = request.WhichOneof("call")
    if call in ("refuse", "abort", None):
        sys.exit(f"plate.py: {getattr(request, call).reason if call else 'a request without a call'}")
    if plate is None and call not in ("welcome", "initialize", "finalize"):
        raise ValueError(f"{call} is out of order")
    if call == "initialize":
        points = np.array(request.initialize.interface.position).reshape(-1, 2)
        plate, rest = Plate(request.initialize.the_case, points), np.zeros(points.size)
        columns = [("interface_work", "J"), *((f"{name}_{axis}", "m") for name in plate.probes for axis in "xy")]
        return {"initialized": wire.Initialized(
            motion=wire.Motion(displacement=rest, velocity=rest), particles=len(points), window=np.inf,
            columns=[wire.Column(name=name, unit=unit) for name, unit in columns])}, plate
    if call == "advance":
        force = np.array(request.advance.load.force)
        if force.size != plate.points.size or not np.isfinite(force).all():
            raise ValueError(f"{force.size} forces instead of {plate.points.size}, or not all of them numbers")
        motion, values = plate.advance(request.advance.window, force)
        return {"advanced": wire.Advanced(motion=motion, values=values, window=np.inf)}, plate
    if call == "save":
        return {"saved": wire.Saved(state=plate.state.tobytes())}, plate
    if call == "frame":
        position = plate.points.ravel() + plate.H @ plate.state[:MODES]
        return {"snapshot": wire.Snapshot(arrays=[wire.Array(name="position", unit="m", components=2,
                                                             values=position)])}, plate
    if call == "restore":
        plate.state = np.frombuffer(request.restore.state)
    return {"done": wire.Done()}, plate


def serve(socket, token):
    hello = wire.Hello(protocol=PROTOCOL, role=wire.SOLID, program="plate.py", version="1", dimensions=[2],
                       capabilities=["save", "frame"], token=token)
    socket.send(wire.Reply(hello=hello).SerializeToString())
    plate, number, request = None, 0, wire.Request()
    try:
        while request.WhichOneof("call") != "finalize":
            request, begin, number = wire.Request.FromString(socket.recv()), time.perf_counter(), number + 1
            if request.sequence != number:
                raise ValueError(f"request {request.sequence} came instead of {number}")
            result, plate = answer(request, plate)
            socket.send(wire.Reply(sequence=number, seconds=time.perf_counter() - begin, **result).SerializeToString())
    except Exception as error:  # the coupler reports it, and ends the run
        socket.send(wire.Reply(failure=wire.Failure(what=str(error))).SerializeToString())
        sys.exit(f"plate.py: {error}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--connect", "--threads"):
        parser.add_argument(option)
    connection = json.loads(pathlib.Path(parser.parse_args().connect).read_text())
    with zmq.Context() as context, context.socket(zmq.PAIR) as wire_end:
        wire_end.linger, wire_end.heartbeat_ivl = 2000, 250
        wire_end.connect(connection["endpoint"])
        serve(wire_end, connection["token"])
