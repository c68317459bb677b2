"""Disturbances of a run."""
import errno
import random
import signal
import time


class Signal:
    """A signal to cosurge at a random moment, twice perhaps."""

    def __init__(self, number, times=1):
        self.number, self.times = number, times
        self.name = f"{number.name} to cosurge" + (" twice" if times > 1 else "")
        self.settings = {}
        self.codes = {-signal.SIGKILL} if number == signal.SIGKILL else {130}

    def apply(self, program, chance):
        for _ in range(self.times):
            program.send(self.number)
            time.sleep(chance.uniform(0, 0.05))


class Solver:
    """A signal to a solver; if it freezes the solver, possibly another one to cosurge."""

    def __init__(self, number, then=None):
        self.number, self.then = number, then
        self.name = f"{number.name} to a solver" + (f", {then.name} to cosurge" if then else "")
        self.settings = {}
        self.codes = {-signal.SIGKILL} if then == signal.SIGKILL else {1, 130}

    def apply(self, program, chance):
        solvers = sorted(program.solvers())
        if solvers:
            program.send(self.number, chance.choice(solvers))
        if self.then:
            time.sleep(chance.uniform(0, 0.3))
            program.send(self.then)


class Frozen:
    """Cosurge is suspended for some seconds, and then killed or continued."""

    def __init__(self, then):
        self.then = then
        self.name = f"SIGSTOP to cosurge, then {then.name}"
        self.settings = {}
        self.codes = {-signal.SIGKILL} if then == signal.SIGKILL else {1, 130}

    def apply(self, program, chance):
        program.send(signal.SIGSTOP)
        time.sleep(chance.choice([0.1, 4.5]))  # 3 s without a sign of life are enough for a solver to give up
        program.send(self.then)


class Everything:
    """All processes are killed, as by a failing machine."""

    name = "SIGKILL to all"
    settings = {}
    codes = {-signal.SIGKILL}

    def apply(self, program, chance):
        pids = list(program.members())
        chance.shuffle(pids)
        for pid in pids:
            program.send(signal.SIGKILL, pid)


class Disk:
    """The N-th write below the folder fails, and all that follow, or the process is killed there."""

    def __init__(self, library, folder, at, error):
        self.name = f"{errno.errorcode[error] if error else 'SIGKILL'} at write {at}"
        self.settings = {"LD_PRELOAD": str(library), "FAILING_DISK_PATH": f"/{folder}/", "FAILING_DISK_AT": str(at),
                         "FAILING_DISK_ERROR": str(error)}
        self.codes = {1} if error else {-signal.SIGKILL, 1}

    def apply(self, program, chance):
        pass


def choose(chance: random.Random, in_process, library, folder, writes):
    """One at random."""
    stop = signal.SIGSTOP
    found = [Signal(signal.SIGKILL), Signal(signal.SIGKILL), Signal(signal.SIGTERM), Signal(signal.SIGINT),
             Signal(signal.SIGINT, 2), Signal(signal.SIGHUP), Frozen(signal.SIGKILL), Everything()]
    if not in_process:
        found += [Solver(signal.SIGKILL), Solver(signal.SIGTERM), Solver(stop), Solver(stop, signal.SIGKILL),
                  Solver(stop, signal.SIGKILL), Solver(stop, signal.SIGINT), Frozen(signal.SIGCONT)]
    at = chance.randint(1, max(1, writes))
    found += [Disk(library, folder, at, error) for error in (0, 0, errno.ENOSPC, errno.EIO)]
    return chance.choice(found)
