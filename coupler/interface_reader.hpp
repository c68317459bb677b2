// Reads the part of a saved state that has fields of the interface.
#pragma once

#include "common/participant.hpp"
#include "common/state_bytes.hpp"

namespace cosurge {

/// A StateReader that knows the interface of the run. A field that was saved with its size must have the size
/// of this interface: a state of another interface is refused before anything computes with it.
class InterfaceReader : public StateReader {
 public:
  InterfaceReader(std::string_view bytes, int dimension, Eigen::Index points)
      : StateReader(bytes), dimension_(dimension), points_(points) {}

  using StateReader::get;

  /// @throws Error where the byte is neither 0 nor 1: a bool of another value is undefined.
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    require(byte <= 1, "saved state: {} where 0 or 1 must be; it belongs to another case or build", byte);
    value = byte == 1;
  }

  /// Reads a field that put_sized() wrote. Returns false if it is empty, which means that the value was
  /// unknown when it was saved.
  /// @throws Error where it has another number of directions or points than the interface.
  bool get_field(Field& field) {
    get_sized(*this, field);
    if (field.rows() == 0 && field.cols() == 0) return false;
    require_size(field, dimension_, points_);
    return true;
  }

  /// The same for a field whose numbers lie in one column; it may not be empty.
  void get_column(Eigen::VectorXd& values) {
    get_sized(*this, values);
    require_size(values, dimension_ * points_, 1);
  }

 private:
  template <typename Matrix>
  static void require_size(const Matrix& values, Eigen::Index rows, Eigen::Index columns) {
    require(values.rows() == rows && values.cols() == columns,
            "saved state: a field of the interface has {} x {} numbers instead of {} x {}; it belongs to "
            "another case or build",
            values.rows(), values.cols(), rows, columns);
  }

  int dimension_;
  Eigen::Index points_;
};

}  // namespace cosurge
