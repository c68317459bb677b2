// Vectors that are written to before they are read.
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace cosurge::fluid {

/// Constructs numbers without a value.
template <typename T>
struct UnfilledAllocator : std::allocator<T> {
  void construct(T* number) noexcept { ::new (static_cast<void*>(number)) T; }
};

/// Room for more numbers than are used: unwritten memory is not allocated.
template <typename T>
class Unfilled {
 public:
  /// For this many numbers; earlier content is lost.
  void make_room(std::size_t numbers) {
    numbers_.clear();  // nothing is copied
    numbers_.resize(numbers);
  }

  T* data() { return numbers_.data(); }
  const T* data() const { return numbers_.data(); }
  T& operator[](std::size_t k) { return numbers_[k]; }
  const T& operator[](std::size_t k) const { return numbers_[k]; }

 private:
  std::vector<T, UnfilledAllocator<T>> numbers_;
};

}  // namespace cosurge::fluid
