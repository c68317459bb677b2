// Eight numbers that are computed at once.
#pragma once

#include <cstring>

namespace cosurge::fluid {

using Floats = float __attribute__((vector_size(8 * sizeof(float))));

#if !defined(__AVX__) || defined(__AVX512F__)

using Doubles = double __attribute__((vector_size(8 * sizeof(double))));

inline Doubles doubles_of(const Floats& v) { return __builtin_convertvector(v, Doubles); }

#else

/// Two vectors of four numbers. On AVX2, GCC moves vectors that are wider than the registers through memory,
/// number by number, which costs more than the arithmetic. (On SSE2 halves are wider than the registers too,
/// so one vector is as good.)
struct Doubles {
  using Half = double __attribute__((vector_size(4 * sizeof(double))));
  Half low{};
  Half high{};

  double operator[](int lane) const { return lane < 4 ? low[lane] : high[lane - 4]; }
  Doubles& operator+=(const Doubles& other) { return *this = *this + other; }

  friend Doubles operator+(const Doubles& a, const Doubles& b) { return {a.low + b.low, a.high + b.high}; }
  friend Doubles operator*(const Doubles& a, const Doubles& b) { return {a.low * b.low, a.high * b.high}; }
  friend Doubles operator-(const Doubles& a, double b) { return {a.low - b, a.high - b}; }
};

inline Doubles doubles_of(const Floats& v) {
  return {__builtin_convertvector(__builtin_shufflevector(v, v, 0, 1, 2, 3), Doubles::Half),
          __builtin_convertvector(__builtin_shufflevector(v, v, 4, 5, 6, 7), Doubles::Half)};
}

#endif

template <typename Lanes>
Lanes load(const void* numbers) {
  Lanes values;
  std::memcpy(&values, numbers, sizeof values);
  return values;
}

template <typename Lanes>
auto sum_of_lanes(const Lanes& v) {
  return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

}  // namespace cosurge::fluid
