// The interfaces between coupler and solvers: what a Fluid and a Solid do in a coupled run.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace cosurge::v1 {
class Case;  // proto/case.pb.h: for those who read the case
}

namespace cosurge {

static_assert(
    EIGEN_DEFAULT_ALIGN_BYTES == 64,
    "compile with the flags of cosurge::cosurge (CMake) or cosurge (pkg-config): Eigen's arrays pass between "
    "your program and libcosurge, and must be allocated alike");

/// Vectors at points, one column a point: dimension x points.
using Field = Eigen::MatrixXd;

enum class Role { fluid, solid };

/// Identity and capabilities of a participant, from the handshake.
struct Identity {
  std::string program;
  std::string version;
  std::vector<int> dimensions;            ///< dimensions that it can compute
  std::vector<std::string> capabilities;  ///< calls beyond initialize and advance: "save", "frame"
};

/// The interface consists of the fluid's points on and in the bodies, in the reference configuration.
struct Interface {
  int dimension = 0;
  Field position;         ///< [m]
  Field area;             ///< outward area vectors [m^(d-1)]; zero at inner points of the bodies
  std::vector<int> body;  ///< index of the body that a point belongs to

  Eigen::Index points() const { return position.cols(); }
};

/// One of the structure's lowest modes (docs/method.md, eq. 20). If the interface had the load `force`
/// instead of the predicted one, the velocity v over the window would become v + mobility (shape . force -
/// load) shape.
struct Mode {
  Field shape;          ///< displacement of the points for a unit of the mode [m]
  double mobility = 0;  ///< velocity for a unit of load on the mode [m/(N s)]
  double load = 0;      ///< predicted load on the mode, with which the motion was computed [N]
};

/// Motion of the interface points, from the solid.
struct InterfaceMotion {
  Field displacement;  ///< [m] at the end of the solid's last window
  Field velocity;      ///< [m/s] mean over the solid's last window, or at its end, as set in the case
  Field
      ramp_increment;  ///< [m] integral of velocity * (t - start) / size over the window; zero for held loads
  std::vector<Mode> modes;  ///< modes of a predicted motion; empty otherwise
  double frequency = 0;     ///< angular frequency of the structure's slowest oscillation [rad/s]; 0: unknown

  static InterfaceMotion at_rest(int dimension, Eigen::Index points);
};

/// Load on the interface points, from the fluid.
struct InterfaceLoad {
  Field force;               ///< [N] on the solid (per metre of width in two dimensions) = -pressure * area
  Eigen::VectorXd pressure;  ///< [Pa]

  static InterfaceLoad zero(int dimension, Eigen::Index points);
};

/// Whether a participant computes a window once or repeatedly.
enum class Attempt {
  once,   ///< the window is not repeated
  first,  ///< it may be repeated: save the state before it
  again   ///< it is repeated: restore the state saved before it
};

/// A coupling window: both solvers advance from start to start + size.
struct Window {
  std::uint64_t index = 0;
  double start = 0;  ///< [s]
  double size = 0;   ///< [s]
  Attempt attempt = Attempt::once;
};

/// A quantity that a participant reports after every window.
struct Column {
  std::string name;
  std::string unit;
};

/// Data of a participant after it has read the case.
struct Setup {
  std::vector<Column> columns;
  std::uint64_t particles = 0;
  double window = 0;   ///< largest first window [s]
  double substep = 0;  ///< the solver's own step [s]; 0 if it takes the window as its step
};

/// Data of a participant for one window.
struct Report {
  std::vector<double> values;           ///< one a column
  double window = 0;                    ///< largest next window [s]
  std::vector<std::string> notes = {};  ///< messages for the user
};

/// A named array of a frame: components values for each particle, one particle after the other.
struct Array {
  std::string name;
  std::string unit;
  int components = 1;
  std::vector<float> values;
};

/// The particles of a solver at one instant.
using Snapshot = std::vector<Array>;

/// A solver that can take part in a coupled run: a Fluid or a Solid. Implemented by Cosurge's own solvers, by
/// the proxies for solvers behind a connection, and by the mocks of the tests. Legal order of calls:
/// initialize ( advance | save | restore | frame )* finalize. All calls throw Error or NumericalError if they
/// cannot continue.
class Participant {
 public:
  virtual ~Participant() = default;

  virtual Role role() const = 0;
  virtual Identity identity() const = 0;

  /// The complete state as bytes. After restore(save()) the results are bit-identical, also in another
  /// process of the same build.
  virtual std::string save() = 0;
  virtual void restore(const std::string& state) = 0;

  /// Arrays for the results. Names, components and lengths never change in a run.
  virtual Snapshot frame() = 0;

  virtual void finalize() {}
};

/// The water: receives the motion of the interface points, and returns the load on them.
class Fluid : public virtual Participant {
 public:
  Role role() const final { return Role::fluid; }

  /// Builds the initial state of a checked case, and fills the interface and the load at the start of the
  /// first window.
  virtual Setup initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) = 0;

  /// Computes one window: reads the motion, and fills the load, which already has its size. Between attempts
  /// at one window only the velocity of the motion differs: the bodies keep their positions at the start.
  virtual Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) = 0;
};

/// A structure: receives the load on the interface points, and returns their motion.
class Solid : public virtual Participant {
 public:
  Role role() const final { return Role::solid; }

  /// Builds the initial state of a checked case, and fills the motion of the interface points at the start of
  /// the first window. `load` is the load at that time.
  virtual Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                           InterfaceMotion& motion) = 0;

  /// Computes one window: reads the load, and fills the motion, which already has its size.
  virtual Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) = 0;
};

}  // namespace cosurge
