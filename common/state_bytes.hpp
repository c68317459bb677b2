// A state as a string of bytes, for this build alone: numbers lie as they lie in memory.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/error.hpp"

namespace cosurge {

/// Types that can be copied byte by byte: numbers, enums, and Eigen's fixed-size vectors.
template <typename T>
concept Plain = std::is_trivially_copyable_v<T> || requires {
  requires T::SizeAtCompileTime >
  0;
};

/// Appends numbers and arrays of numbers to a state.
class StateWriter {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T>
  void put(const T& value) { append(&value, sizeof value); }

  template <typename Derived>
  void put(const Eigen::PlainObjectBase<Derived>& values) {
    append(values.data(), sizeof(*values.data()) * static_cast<std::size_t>(values.size()));
  }

  template <Plain T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    append(values.data(), sizeof(T) * values.size());
  }

  void put(const std::string& part) {
    put(static_cast<std::uint64_t>(part.size()));
    append(part.data(), part.size());
  }

  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* from, std::size_t length) { bytes_.append(static_cast<const char*>(from), length); }

  std::string bytes_;
};

/// Reads back what a StateWriter wrote, in the same order; Eigen's arrays must have the size that was
/// written.
/// @throws Error where the state is shorter or longer: it comes from another case or another build.
class StateReader {
 public:
  explicit StateReader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  requires std::is_arithmetic_v<T>
  void get(T& value) { copy(&value, sizeof value); }

  template <typename Derived>
  void get(Eigen::PlainObjectBase<Derived>& values) {
    copy(values.data(), sizeof(*values.data()) * static_cast<std::size_t>(values.size()));
  }

  template <Plain T>
  void get(std::vector<T>& values) {
    values.resize(length(sizeof(T)));
    copy(values.data(), sizeof(T) * values.size());
  }

  void get(std::string& part) {
    part.resize(length(1));
    copy(part.data(), part.size());
  }

  /// @throws Error unless so many rows and columns of entries may follow.
  void expect(std::int64_t rows, std::int64_t columns, std::size_t size_of_entry) const {
    const auto most = static_cast<std::int64_t>(rest_.size() / size_of_entry);
    require(rows >= 0 && columns >= 0 && (rows == 0 || columns <= most / rows),
            "saved state: too short; it belongs to another case or build");
  }

  void finish() const {
    require(rest_.empty(), "saved state: {} bytes too many; it belongs to another case or build",
            rest_.size());
  }

 private:
  std::size_t length(std::size_t size_of_entry) {
    std::uint64_t entries = 0;
    get(entries);
    require(entries <= rest_.size() / size_of_entry,
            "saved state: too short; it belongs to another case or build");
    return entries;
  }

  void copy(void* to, std::size_t bytes) {
    require(bytes <= rest_.size(), "saved state: too short; it belongs to another case or build");
    if (bytes > 0) std::memcpy(to, rest_.data(), bytes);
    rest_.remove_prefix(bytes);
  }

  std::string_view rest_;
};

/// A matrix with its size, for readers that do not know the size.
template <typename Matrix>
void put_sized(StateWriter& state, const Matrix& values) {
  state.put(static_cast<std::int64_t>(values.rows()));
  state.put(static_cast<std::int64_t>(values.cols()));
  state.put(values);
}

template <typename Matrix>
void get_sized(StateReader& state, Matrix& values) {
  std::int64_t rows = 0;
  std::int64_t columns = 0;
  state.get(rows);
  state.get(columns);
  state.expect(rows, columns, sizeof(*values.data()));
  values.resize(rows, columns);
  state.get(values);
}

}  // namespace cosurge
