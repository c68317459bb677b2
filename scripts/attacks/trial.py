"""One trial: a run that is disturbed, and its resumptions, against the undisturbed run."""
import shutil
import time

from . import cases, disturbances, results
from .program import Program

PATIENCE = 10  # s until a disturbed run has ended, with all its processes


class Wrong(Exception):
    """A failure of a trial."""


class Reference:
    """The undisturbed run of a case: its results, its duration, its writes to files."""

    def __init__(self, name, attack):
        folder = attack.folder / "reference" / name
        folder.parent.mkdir(parents=True, exist_ok=True)
        count = folder.with_suffix(".count")
        settings = {"LD_PRELOAD": str(attack.library), "FAILING_DISK_PATH": f"/{name}/", "FAILING_DISK_AT": "0",
                    "FAILING_DISK_COUNT": str(count)}
        begin = time.monotonic()
        program = Program(attack.cosurge, cases.arguments(name, folder, True), folder.with_suffix(".log"), name,
                          attack.folder, settings)
        if program.process.wait() != 0:
            raise SystemExit(f"{name}: the undisturbed run fails:\n{program.output()}")
        self.seconds = time.monotonic() - begin
        self.writes = int(count.read_text())
        self.whole = results.datasets(folder / "results.h5")
        self.summary = results.summary(folder)


class Trial:
    def __init__(self, attack, number):
        self.attack, self.number = attack, number
        self.chance = attack.chance(number)
        self.name = sorted(cases.CASES)[number % len(cases.CASES)]
        self.in_process = self.chance.random() < 0.4
        self.reference = attack.reference(self.name)
        self.place = attack.folder / f"trial-{number}"
        self.folder = self.place / "run"
        self.temporary = self.place / "tmp"
        self.story = []
        self.frames = 0

    def run(self):
        """None if the trial passed; otherwise the failure and the disturbances."""
        self.temporary.mkdir(parents=True)
        try:
            for _ in range(self.chance.choice([1, 1, 2, 3])):
                if self._disturbed():
                    break
            self._finished()
        except Wrong as wrong:
            return f"{wrong}\n    {self.describe()}\n    kept: {self.place}"
        shutil.rmtree(self.place)
        return None

    def describe(self):
        where = "in process" if self.in_process else "in processes"
        return f"trial {self.number}: {self.name}, {where}: " + "; ".join(self.story)

    def _start(self, settings=None):
        if not (self.folder / "checkpoint").exists():
            shutil.rmtree(self.folder, ignore_errors=True)  # it had not begun
        self.resuming = self.folder.exists()
        way = ["--in-process"] if self.in_process else []
        arguments = (["resume", str(self.folder), "--threads", "1", *way] if self.resuming
                     else cases.arguments(self.name, self.folder, self.in_process))
        self.place.mkdir(exist_ok=True)
        log = self.place / f"{len(self.story)}.log"
        return Program(self.attack.cosurge, arguments, log, f"{self.number}.{len(self.story)}", self.temporary, settings)

    def _disturbed(self):
        """Starts or resumes the run, and disturbs it. True if it had finished before."""
        disturbance = disturbances.choose(self.chance, self.in_process, self.attack.library,
                                          f"trial-{self.number}/run", self.reference.writes)
        moment = self.chance.uniform(0, 1.1 * self.reference.seconds)
        program = self._start(disturbance.settings)
        self.story.append(f"{disturbance.name} after {moment:.3f} s")
        try:
            if not disturbance.settings:
                program.wait(moment)
                disturbance.apply(program, self.chance)
            patience = PATIENCE + (5 * self.reference.seconds if disturbance.settings else 0)
            code = program.wait(patience)
            if code is None:
                raise Wrong(f"hangs: not ended {patience:.0f} s later:\n{program.output()}")
            if left := program.left_behind(PATIENCE):
                raise Wrong(f"left behind: {', '.join(left)}")
        finally:
            program.end()
        self._look(code, disturbance, program)
        return code == 0

    def _look(self, code, disturbance, program):
        """At the end of a disturbed run."""
        early = self.resuming and code == 1 and "the run is finished at" in program.output()
        if code not in disturbance.codes | {0} and not early and not self._died_before_words(code):
            raise Wrong(f"exit code {code} instead of {sorted(disturbance.codes)}:\n{program.output()}")
        if code in (1, 130) and not program.output().strip():
            raise Wrong(f"exit code {code} without a word")
        if (self.folder / "checkpoint").exists():
            self._look_at_part()
        elif self.frames:
            raise Wrong("the checkpoint is lost")

    @staticmethod
    def _died_before_words(code):
        """Whether a signal came before cosurge could handle it: then nothing has been written."""
        return code in (-1, -2, -15)

    def _look_at_part(self):
        try:
            part = results.datasets(self.folder / "results.h5")
        except (OSError, KeyError, RuntimeError) as error:
            raise Wrong(f"the results cannot be read: {error}") from error
        if wrong := results.differences_of_part(part, self.reference.whole):
            raise Wrong(f"the results are wrong: {wrong[:3]}")
        frames = results.rows_and_frames(part)[1]
        if frames < self.frames - 1:  # one may lie behind the checkpoint
            raise Wrong(f"{frames} frames, and there were {self.frames} before")
        self.frames = frames

    def _finished(self):
        """Continues the run without a disturbance; the results must be bit-identical."""
        program = self._start()
        try:
            code = program.wait(PATIENCE + 20 * self.reference.seconds)
            if code is None:
                raise Wrong(f"the last resumption hangs:\n{program.output()}")
            if code != 0 and "the run is finished at" not in program.output():
                raise Wrong(f"the last resumption ends with exit code {code}:\n{program.output()}")
        finally:
            program.end()
        if wrong := results.differences(results.datasets(self.folder / "results.h5"), self.reference.whole):
            raise Wrong(f"other results than undisturbed: {wrong[:3]}")
        if results.summary(self.folder) != self.reference.summary:
            raise Wrong("another summary than undisturbed")
        if code != 0:
            self._run_anew()  # nothing was left to run: what a killed run leaves goes with the next run
        if left := [entry.name for entry in self.temporary.iterdir()]:
            raise Wrong(f"left in the folder for temporary files: {', '.join(left)}")
        if left := [entry.name for entry in self.folder.iterdir() if entry.name.endswith(".new")]:
            raise Wrong(f"left in the folder of results: {', '.join(left)}")

    def _run_anew(self):
        """The case once more, from its start, undisturbed."""
        program = Program(self.attack.cosurge, cases.arguments(self.name, self.place / "anew", False),
                          self.place / "anew.log", f"{self.number}.anew", self.temporary)
        try:
            if program.wait(PATIENCE + 20 * self.reference.seconds) != 0:
                raise Wrong(f"a new run of the case fails:\n{program.output()}")
        finally:
            program.end()
