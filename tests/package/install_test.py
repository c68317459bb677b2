#!/usr/bin/env python3
"""Installs a build, and uses what is installed as others would.

install_test.py BUILD [COMPILER]: by cmake --install into a new prefix; tests/consumer compiled against it by CMake and by
pkg-config; then the prefix is moved, and its programs run a case from another folder.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv[1]).resolve()
COMPILER = sys.argv[2] if len(sys.argv) > 2 else "c++"
CONSUMER = pathlib.Path(__file__).resolve().parents[1] / "consumer"


def output(*command, **options):
    """What a command says; raises with all of it where it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} returned {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="cosurge-install-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        first, cls.prefix = cls.folder / "first", cls.folder / "moved" / "elsewhere"
        output("cmake", "--install", BUILD, "--prefix", first)
        cls.library = next(path.parent for path in first.rglob("libcosurge.so")).relative_to(first)
        cls.by_cmake, cls.by_pkg_config = cls.folder / "b/consumer", cls.folder / "consumer"
        output("cmake", "-S", CONSUMER, "-B", cls.folder / "b", f"-DCMAKE_PREFIX_PATH={first}", "-DCMAKE_BUILD_TYPE=Release",
               f"-DCMAKE_CXX_COMPILER={COMPILER}")
        output("cmake", "--build", cls.folder / "b")
        cls.prefix.parent.mkdir()
        first.rename(cls.prefix)
        environment = dict(os.environ, PKG_CONFIG_PATH=str(cls.prefix / cls.library / "pkgconfig"))
        flags = output("pkg-config", "--cflags", "--libs", "cosurge", env=environment).split()
        output(COMPILER, "-std=c++20", "-O2", CONSUMER / "main.cpp", "-o", cls.by_pkg_config, *flags)
        (cls.folder / "lib").symlink_to(cls.prefix / cls.library)
        cls.case = cls.prefix / "share/cosurge/cases/dam_break_plate"

    def run_consumer(self, program, *arguments):
        """With the library found by a link, as Debian's /lib leads to /usr/lib: from there /libexec is not beside it."""
        environment = dict(os.environ, LD_LIBRARY_PATH=str(self.folder / "lib"), OMP_WAIT_POLICY="passive")
        return output(program, self.case, *arguments, env=environment, cwd=self.folder)

    def test_a_consumer_computes_the_same_in_process_and_over_the_wire_however_it_was_compiled(self):
        here = self.run_consumer(self.by_cmake)
        windows, q = re.fullmatch(r"(\d+) windows, largest q (\S+) m\n", here).groups()
        self.assertGreater(int(windows), 1000)
        self.assertGreater(float(q), 1e-4)  # the front has reached the plate: it is at 0.126 s
        self.assertLess(float(q), 0.05)
        self.assertEqual(here, self.run_consumer(self.by_cmake, "wire"))
        self.assertEqual(here, self.run_consumer(self.by_pkg_config))

    def test_public_headers_need_neither_protobuf_nor_zeromq_nor_fmt(self):
        text = "".join(f"#include <cosurge/{path.name}>\n" for path in (self.prefix / "include/cosurge").glob("*.hpp"))
        used = subprocess.run([COMPILER, "-std=c++20", f"-I{self.prefix}/include", "-I/usr/include/eigen3", "-M", "-x", "c++", "-"],
                              input=text, capture_output=True, text=True, check=True).stdout
        self.assertIn("cosurge/simulation.hpp", used)
        for foreign in ("google/protobuf", "zmq", "fmt/", "toml", "CLI/"):
            self.assertNotIn(foreign, used)

    def test_programs_of_a_moved_prefix_run_a_case_from_another_folder(self):
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        environment = {key: value for key, value in os.environ.items() if key != "LD_LIBRARY_PATH"}
        said = output(self.prefix / "bin/cosurge", "run", self.case, "--set", "time.end=0.005",
                      cwd=elsewhere, env=environment)
        self.assertIn("finished", said)
        self.assertTrue((elsewhere / "results/dam_break_plate/results.h5").exists())
        self.assertTrue((elsewhere / "results/dam_break_plate/fluid_solver.log").exists())
        solver = self.prefix / "libexec/cosurge/fluid_solver"
        solver.unlink()
        failed = subprocess.run([self.prefix / "bin/cosurge", "run", self.case, "--out", elsewhere / "none"], capture_output=True,
                                text=True, cwd=elsewhere, env=environment)
        self.assertEqual(failed.returncode, 1)
        self.assertIn(f"fluid_solver is missing: it is neither in {self.prefix}/bin nor in {solver.parent}", failed.stderr)

    def test_every_command_has_a_man_page_and_licences_are_there(self):
        listed = output(self.prefix / "bin/cosurge", "--help").split("Subcommands:")[1]
        for command in re.findall(r"^  ([a-z]+) ", listed, re.M):
            page = (self.prefix / f"share/man/man1/cosurge-{command}.1").read_text()
            self.assertIn(".SH", page)
            self.assertIn("help", page)
        copyright = (self.prefix / "share/doc/cosurge/copyright").read_text()
        self.assertIn("Apache", copyright)
        self.assertIn("Leon Sorokin", copyright)
        self.assertTrue((self.prefix / "share/doc/cosurge/LICENSE").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
