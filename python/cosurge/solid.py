"""Structures of one's own."""
import sys

from . import _cosurge


class Solid:
    """A structure that computes in Python. Subclasses have at least initialize(), advance(), save() and restore().

    Motion and load are those of the water's points on and in the bodies: u = H q and f = H^T F with the same H, so that the
    work on both sides is equal (docs/write_your_own_solid.md).
    """

    #: (name, unit) of each value that advance() returns besides the motion; they are columns of the results.
    columns = []

    def initialize(self, case, position, area, body):
        """Builds the structure at rest. case: dict with all defaults. position [m], area [m^(d-1)]: a row a point, areas
        zero at inner points. body: number of each point's body."""
        raise NotImplementedError

    def advance(self, window, force):
        """One window of window.size seconds under the force [N] on each point (read-only, valid during the call).

        Returns displacement [m] at its end and mean velocity [m/s], a row a point; with columns also their values."""
        raise NotImplementedError

    def save(self):
        """The complete state as bytes. Needed for schemes that iterate, and for checkpoints."""
        raise NotImplementedError

    def restore(self, state):
        """Back to a state that save() has given, in every bit."""
        raise NotImplementedError


def serve(solid, arguments=None):
    """Makes the program a solver for `cosurge run --solid PROGRAM`: connects, answers until the run is over, and exits."""
    sys.exit(_cosurge.serve(solid, list(sys.argv if arguments is None else arguments)))
