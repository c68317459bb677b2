#!/usr/bin/python3
"""The module cosurge as its users have it: cases, runs, structures in Python, results.

module_test.py PROGRAMS SOURCE: PYTHONPATH leads to the module.
"""
import importlib.util
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import cosurge

from leaning_plate import LeaningPlate

PROGRAMS, SOURCE = Path(sys.argv[1]), Path(sys.argv[2])
CASE = SOURCE / "tests/cases/small_dam_break"
SHORT = {"time.end": 0.06}
WET = {"time.end": 0.09}  # the water has reached the plate

SCENE = {
    "title": "small", "gravity": [0.0, -9.81], "time": {"end": 0.02, "window": 1e-3},
    "fluid": {"spacing": 0.01, "tank": {"min": [0.0, 0.0], "max": [0.4, 0.4]},
              "water": [{"min": [0.0, 0.0], "max": np.array([0.1, 0.2])}]},
    "output": {"frame_interval": 0.01, "probe": [{"name": "P", "quantity": "pressure", "position": [0.0, 0.0]}]},
}


def cosurge_says(*words):
    return subprocess.run([PROGRAMS / "cosurge", *map(str, words)], capture_output=True, text=True, timeout=600)


class Module(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="cosurge-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_plate(self, name, set=SHORT, **options):
        return cosurge.run(CASE, set, self.folder / name, **options)


class Cases(Module):
    def test_errors_are_those_of_the_command_line(self):
        wrong = {"fluid.spacing": -1, "solid.model": "jelly", "output.nothing": 3}
        with self.assertRaises(cosurge.Error) as raised:
            cosurge.check(CASE, wrong)
        told = cosurge_says("check", CASE, "--set", "fluid.spacing=-1", 'solid.model="jelly"', "output.nothing=3")
        self.assertEqual(str(raised.exception), told.stderr.strip())
        self.assertEqual(len(str(raised.exception).splitlines()), 3)

    def test_a_dict_is_the_same_case_as_its_file(self):
        (self.folder / "case.toml").write_text(cosurge.toml_of(SCENE))
        self.assertEqual(cosurge.check(SCENE), cosurge.check(self.folder))
        self.assertEqual(cosurge.check(SCENE)["fluid"]["water"][0]["max"], [0.1, 0.2])

    def test_none_takes_the_default(self):
        self.assertNotEqual(cosurge.check(CASE)["time"]["window"],
                            cosurge.check(CASE, {"time.window": None})["time"].get("window"))


class Runs(Module):
    def test_results_have_units_and_are_those_of_the_program(self):
        run = self.run_plate("here")
        done = cosurge_says("run", CASE, "--set", "time.end=0.06", "--out", self.folder / "program")
        self.assertEqual(done.returncode, 0, done.stderr)
        program = cosurge.Results(self.folder / "program")
        for name in ("time", "solid/tip_x", "fluid/foot", "coupling/work_points"):
            self.assertTrue(np.array_equal(run[name], program[name], equal_nan=True), name)
        foot = run["fluid/foot"]
        self.assertEqual((foot.unit, foot.name, len(foot)), ("Pa", "fluid/foot", len(foot.time)))
        self.assertEqual(foot.peak, program.summary["probes"]["foot"]["peak"]["value"])
        self.assertEqual(foot.time_of_peak, program.summary["probes"]["foot"]["peak"]["time"])
        self.assertEqual(run.summary["status"], "finished")
        frame = run.frame("fluid")
        self.assertEqual(frame["position"].shape[1], 2)
        self.assertEqual(frame.units["pressure"], "Pa")
        self.assertAlmostEqual(frame.time, 0.06)

    def test_a_callback_sees_every_window_and_can_end_the_run(self):
        seen = []
        run = self.run_plate("early", on_window=lambda t, values: seen.append((t, values["solid/tip_x"])) or t > 0.03)
        self.assertGreater(seen[-1][0], 0.03)
        self.assertLess(seen[-1][0], 0.031)
        self.assertEqual(run.summary["status"], "interrupted")
        self.assertTrue(np.array_equal(run["time"], [t for t, _ in seen]))
        self.assertTrue(np.array_equal(run["solid/tip_x"], [x for _, x in seen]))

    def test_what_a_callback_raises_comes_out_and_the_results_stay(self):
        def fail(t, values):
            if t > 0.01:
                raise ZeroDivisionError("enough")
        with self.assertRaisesRegex(ZeroDivisionError, "enough"):
            self.run_plate("broken", on_window=fail)
        self.assertGreater(len(cosurge.Results(self.folder / "broken")["time"]), 40)

    def test_nothing_is_written_over(self):
        cosurge.run(SCENE, out=self.folder / "once")
        before = (self.folder / "once/results.h5").read_bytes()
        with self.assertRaises(cosurge.Error):
            cosurge.run(SCENE, out=self.folder / "once")
        self.assertEqual((self.folder / "once/results.h5").read_bytes(), before)

    def test_a_sweep_goes_on_where_it_was(self):
        over = {"time.window": [1e-3, 5e-4]}
        first = [values for values, _ in cosurge.sweep(SCENE, over, self.folder)]
        self.assertEqual(first, [{"time.window": 1e-3}, {"time.window": 5e-4}])
        written = (self.folder / "time.window=0.001/results.h5").stat().st_mtime_ns
        rows = [len(run["time"]) for _, run in cosurge.sweep(SCENE, over, self.folder)]
        self.assertEqual(rows, [20, 40])
        self.assertEqual((self.folder / "time.window=0.001/results.h5").stat().st_mtime_ns, written)

    def test_a_notebook_shows_the_report(self):
        run = cosurge.run(SCENE, out=self.folder / "shown")
        shown = run._repr_html_()
        self.assertTrue(shown.startswith("<iframe srcdoc="))
        self.assertIn("small", shown)
        page = self.folder / "page.html"
        cosurge.report([run]).save(page)
        self.assertIn("</html>", page.read_text().lower())
        with self.assertRaises(FileExistsError):
            cosurge.report([run]).save(page)

    def test_histories_become_a_dataset_of_xarray(self):
        if importlib.util.find_spec("xarray") is None:
            self.skipTest("xarray is not installed")
        run = cosurge.run(SCENE, out=self.folder / "data")
        data = run.to_xarray()
        self.assertEqual(data["fluid/P"].attrs["units"], "Pa")
        self.assertTrue(np.array_equal(data["time"], run["time"]))


class Solids(Module):
    def test_the_same_bits_here_in_a_thread_and_in_a_program(self):
        here = self.run_plate("here", WET, solid=LeaningPlate())
        wire = self.run_plate("wire", WET, solid=LeaningPlate(), wire=True)
        program = self.run_plate("program", WET, solid=str(Path(__file__).with_name("leaning_plate.py")), wire=True)
        self.assertGreater(np.abs(here["solid/q"]).max(), 0)
        for other in (wire, program):
            for name in ("time", "solid/q", "fluid/foot", "coupling/work_points"):
                self.assertTrue(np.array_equal(here[name], other[name], equal_nan=True), name)

    def test_windows_are_repeated_from_the_saved_state(self):
        strong = {**WET, "coupling.scheme": "strong"}
        here = self.run_plate("strong", strong, solid=LeaningPlate())
        self.assertGreater(here["coupling/iterations"].max(), 1)
        self.assertTrue(np.array_equal(here["solid/q"], self.run_plate("wire", strong, solid=LeaningPlate(), wire=True)["solid/q"]))

    def test_it_is_no_slower_here_than_behind_the_wire(self):
        program = str(Path(__file__).with_name("leaning_plate.py"))  # has the same Python
        seconds = {False: [], True: []}
        for k in range(3):  # the fastest of three: other work on the machine slows single runs down
            for wire in seconds:
                start = time.perf_counter()
                self.run_plate(f"timed {k} {wire}", wire=wire, solid=program if wire else LeaningPlate(), threads=1)
                seconds[wire].append(time.perf_counter() - start)
        seconds = {wire: min(times) for wire, times in seconds.items()}
        print(f"in process {seconds[False]:.2f} s, over the wire {seconds[True]:.2f} s")
        self.assertLess(seconds[False], 2 * seconds[True])

    def test_what_it_raises_comes_out_with_its_traceback(self):
        class Broken(LeaningPlate):
            def advance(self, window, force):
                raise KeyError("spring")
        for wire in (False, True):
            with self.assertRaises(KeyError) as raised:
                self.run_plate(f"broken {wire}", solid=Broken(), wire=wire)
            self.assertIn("spring", str(raised.exception))
            self.assertIn("Broken.advance()", cosurge.Results(self.folder / f"broken {wire}").summary["reason"])

    def test_wrong_shapes_and_missing_values_are_refused_in_words(self):
        class Flat(LeaningPlate):
            def advance(self, window, force):
                return np.zeros(3), np.zeros_like(force), [0.0]
        with self.assertRaisesRegex(cosurge.Error, r"Flat.advance\(\): the displacement has the shape \(3,\), must be \(\d+, 2\)"):
            self.run_plate("flat", solid=Flat())

        class Silent(LeaningPlate):
            def advance(self, window, force):
                return super().advance(window, force)[:2]
        with self.assertRaisesRegex(cosurge.Error, "returned 0 values for 1 columns"):
            self.run_plate("silent", solid=Silent())

    def test_the_program_keeps_to_the_protocol(self):
        told = cosurge_says("certify", "--", Path(__file__).with_name("leaning_plate.py"))
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
