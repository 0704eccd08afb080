// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "palpate/sim/tree/private/tree_kernels.h"

/// What four-inl.h does, without vector code: for machines and builds that have none.
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

struct Mask {
  bool lane[4];
};

struct Four {
  double lane[4];
};

template <class Operation>
inline Four each(Operation operation) {
  return {{operation(0), operation(1), operation(2), operation(3)}};
}
template <class Condition>
inline Mask each_is(Condition condition) {
  return {{condition(0), condition(1), condition(2), condition(3)}};
}

inline Four set(double s) { return {{s, s, s, s}}; }
inline Four load(const double* from) { return {{from[0], from[1], from[2], from[3]}}; }
inline void store(const Four& a, double* to) { std::copy_n(a.lane, 4, to); }
inline Four load_point(const Vec3& p) { return {{p[0], p[1], p[2], 0.0}}; }

inline Four operator+(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] + b.lane[k]; });
}
inline Four operator-(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] - b.lane[k]; });
}
inline Four operator*(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] * b.lane[k]; });
}
inline Four operator/(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] / b.lane[k]; });
}
inline Four min(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] < b.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline Four max(const Four& a, const Four& b) {
  return each([&](int k) { return a.lane[k] > b.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline Four sqrt(const Four& a) {
  return each([&](int k) { return std::sqrt(a.lane[k]); });
}

inline Mask operator<(const Four& a, const Four& b) {
  return each_is([&](int k) { return a.lane[k] < b.lane[k]; });
}
inline Mask operator<=(const Four& a, const Four& b) {
  return each_is([&](int k) { return a.lane[k] <= b.lane[k]; });
}
inline Mask operator&(const Mask& a, const Mask& b) {
  return each_is([&](int k) { return a.lane[k] && b.lane[k]; });
}
inline Mask operator|(const Mask& a, const Mask& b) {
  return each_is([&](int k) { return a.lane[k] || b.lane[k]; });
}
inline Four select(const Mask& m, const Four& a, const Four& b) {
  return each([&](int k) { return m.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline unsigned bits(const Mask& m) {
  return unsigned{m.lane[0]} | unsigned{m.lane[1]} << 1 | unsigned{m.lane[2]} << 2 |
         unsigned{m.lane[3]} << 3;
}

inline void transpose(const Four (&rows)[4], Four& x, Four& y, Four& z) {
  x = each([&](int k) { return rows[k].lane[0]; });
  y = each([&](int k) { return rows[k].lane[1]; });
  z = each([&](int k) { return rows[k].lane[2]; });
}

inline void store_rounded_down(const Four& a, float* to) {
  for (int k = 0; k < 4; ++k) to[k] = round_down(a.lane[k]);
}
inline void store_rounded_up(const Four& a, float* to) {
  for (int k = 0; k < 4; ++k) to[k] = round_up(a.lane[k]);
}

struct EightMask {
  bool lane[8];
};

struct Eight {
  float lane[8];
};

template <class Operation>
inline Eight each_of_eight(Operation operation) {
  Eight result;
  for (int k = 0; k < 8; ++k) result.lane[k] = operation(k);
  return result;
}

inline Eight set_eight(float s) {
  return each_of_eight([&](int) { return s; });
}
inline Eight load_eight(const float* from) {
  return each_of_eight([&](int k) { return from[k]; });
}
inline void store(const Eight& a, float* to) { std::copy_n(a.lane, 8, to); }

inline Eight operator+(const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return a.lane[k] + b.lane[k]; });
}
inline Eight operator-(const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return a.lane[k] - b.lane[k]; });
}
inline Eight operator*(const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return a.lane[k] * b.lane[k]; });
}
inline Eight min(const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return a.lane[k] < b.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline Eight max(const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return a.lane[k] > b.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline EightMask operator<=(const Eight& a, const Eight& b) {
  EightMask m;
  for (int k = 0; k < 8; ++k) m.lane[k] = a.lane[k] <= b.lane[k];
  return m;
}
inline EightMask operator&(const EightMask& a, const EightMask& b) {
  EightMask m;
  for (int k = 0; k < 8; ++k) m.lane[k] = a.lane[k] && b.lane[k];
  return m;
}
inline Eight select(const EightMask& m, const Eight& a, const Eight& b) {
  return each_of_eight([&](int k) { return m.lane[k] ? a.lane[k] : b.lane[k]; });
}
inline unsigned bits(const EightMask& m) {
  unsigned set = 0;
  for (int k = 0; k < 8; ++k) set |= unsigned{m.lane[k]} << k;
  return set;
}
inline unsigned find_negative(const std::array<int, 8>& numbers) {
  unsigned set = 0;
  for (std::size_t k = 0; k < 8; ++k) set |= unsigned{numbers[k] < 0} << k;
  return set;
}

/// Numbers that are not negative sort as the integers of the same bits, and of those the last three
/// are free to say which child it is, so no two are alike: rounded down, the least stays a least.
inline void make_keys(const Eight& least, std::int32_t (&keys)[8]) {
  for (int k = 0; k < 8; ++k) keys[k] = (std::bit_cast<std::int32_t>(least.lane[k]) & ~7) | k;
}
inline float least_of(std::int32_t key) { return std::bit_cast<float>(key & ~7); }
/// Bits of the keys below one of them.
inline unsigned find_less(const std::int32_t (&keys)[8], std::int32_t key) {
  unsigned set = 0;
  for (int k = 0; k < 8; ++k) set |= unsigned{keys[k] < key} << k;
  return set;
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
