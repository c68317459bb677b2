"""Base class of structures written in Python."""
import sys

from . import _cosurge


class Solid:
    """A structure written in Python. Subclasses implement initialize(), advance(), save() and restore().

    Motion and load are those of the interface points, which are the points of the water's lattice on and in the bodies:
    u = H q and f = H^T F with the same H, so that the work on both sides is equal (docs/write_your_own_solid.md).
    """

    #: (name, unit) of each value that advance() returns besides the motion; they are columns of the results.
    columns = []

    def initialize(self, case, position, area, body):
        """Builds the structure at rest.

        case: the case with all defaults, as a dict. position [m]: one row per point. area: outward area vectors [m^(d-1)],
        one row per point, zero at inner points. body: number of the body of each point."""
        raise NotImplementedError

    def advance(self, window, force):
        """Computes one window of window.size [s] under the force [N] on each point (read-only, valid during the call).

        Returns the displacement at its end [m] and the mean velocity [m/s], one row per point, and, if there are columns,
        their values."""
        raise NotImplementedError

    def save(self):
        """The complete state as bytes. Needed for schemes that iterate, and for checkpoints."""
        raise NotImplementedError

    def restore(self, state):
        """Restores a state that save() has returned. The results afterwards must be bit-identical."""
        raise NotImplementedError


def serve(solid, arguments=None):
    """Runs this script as a solver for `cosurge run --solid PROGRAM`: connects, computes until the run is over, and exits."""
    sys.exit(_cosurge.serve(solid, list(sys.argv if arguments is None else arguments)))
