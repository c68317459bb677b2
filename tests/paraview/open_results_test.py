#!/usr/bin/python3
"""Results open in ParaView with its default reader, and have there what they have in results.h5.

Usage: open_results_test.py FOLDER_OF_THE_PROGRAMS SOURCE_FOLDER
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

SKIPPED = 77  # for ctest: SKIP_RETURN_CODE

BLOCK = """title = "A block falls in space"
dimension = 3
gravity = [0.0, 0.0, -9.81]
[time]
end = 0.05
window = 5e-3
[solid]
spacing = 0.02
density = 1000.0
young_modulus = 1e5
[[solid.body]]
box = { min = [0.0, 0.0, 0.0], max = [0.1, 0.06, 0.08] }
clamp = [{ min = [0.0, 0.0, -0.04], max = [0.1, 0.06, 0.0] }]
[[solid.body]]
box = { min = [0.1, 0.0, 0.0], max = [0.16, 0.06, 0.08] }
clamp = [{ min = [0.1, 0.0, -0.04], max = [0.16, 0.06, 0.0] }]
[output]
frame_interval = 0.01
"""


def opened(file):
    """What ParaView has of a file: in a process of its own, whose HDF5 is another one."""
    done = subprocess.run([sys.executable, str(Path(__file__).with_name("describe.py")), str(file)], capture_output=True,
                          text=True, timeout=300)
    found = [line[5:] for line in done.stdout.splitlines() if line.startswith("JSON ")]
    if done.returncode != 0 or not found:
        raise AssertionError(f"ParaView: {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return json.loads(found[0])


class InParaView(unittest.TestCase):
    def expect_range(self, grid, name, values):
        """The range of a scalar, or of the length of a vector."""
        array = grid["arrays"][name]
        if values.ndim > 1:
            values = np.linalg.norm(values.astype(float), axis=1)
        np.testing.assert_allclose(array["range"], [values.min(), values.max()], rtol=1e-5, atol=1e-12, err_msg=name)

    def run_and_open(self, case, name):
        folder = FOLDER / name
        subprocess.run([str(COSURGE), "run", str(case), "--out", str(folder), "--threads", "1"], check=True, capture_output=True)
        seen = opened(folder / "results.xdmf")
        self.assertRegex(seen["reader"], "^Xdmf3Reader")
        file = h5py.File(folder / "results.h5", "r")
        self.addCleanup(file.close)
        np.testing.assert_allclose(seen["times"], file["frames/time"][:])
        return seen, file

    def test_water_and_plate(self):
        seen, file = self.run_and_open(SOURCE / "tests/cases/small_dam_break", "coupled")
        for k in (0, -1):
            water, plate = seen["frames"][k]
            fluid, solid = file["frames/fluid"], file["frames/solid"]
            self.assertEqual(water["points"], fluid["position"].shape[1])
            self.assertEqual(water["cells"], water["points"])
            for name in ("pressure", "velocity", "kind", "number_density"):
                self.expect_range(water, name, fluid[name][k])
            x = fluid["position"][k]
            np.testing.assert_allclose(water["bounds"][:4], [x[:, 0].min(), x[:, 0].max(), x[:, 1].min(), x[:, 1].max()], rtol=1e-6)
            self.assertEqual((plate["points"], plate["cells"], plate["cell"]), (30, 18, "vtkQuad"))  # 3 x 10 particles
            self.expect_range(plate, "von_mises", solid["von_mises"][k])
            self.expect_range(plate, "displacement", solid["position"][k] - solid["position"][0])
            self.assertLess(plate["largest_cell"], 1.2 * 2 ** 0.5 * 0.004)

    def test_two_bodies_in_space_that_touch_are_two_meshes(self):
        case = FOLDER / "block.toml"
        case.write_text(BLOCK)
        seen, file = self.run_and_open(case, "blocks")
        (blocks,) = seen["frames"][-1]
        # 5 x 3 x 4 and 3 x 3 x 4 particles
        self.assertEqual((blocks["points"], blocks["cells"], blocks["cell"]), (60 + 36, 4 * 2 * 3 + 2 * 2 * 3, "vtkHexahedron"))
        displacement = file["frames/solid/position"][-1] - file["frames/solid/position"][0]
        self.assertGreater(np.abs(displacement).max(), 1e-5)
        self.expect_range(blocks, "displacement", displacement)


if __name__ == "__main__":
    if subprocess.run([sys.executable, "-c", "import paraview.simple"], capture_output=True).returncode != 0:
        print("skipped: no ParaView for Python here (Debian: python3-paraview)")
        sys.exit(SKIPPED)
    COSURGE, SOURCE = Path(sys.argv[1]).resolve() / "cosurge", Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory(prefix="cosurge-paraview-") as folder:
        FOLDER = Path(folder)
        result = unittest.main(argv=sys.argv[:1] + sys.argv[3:], exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() else 1)
