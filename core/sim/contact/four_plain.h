// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "palpate/sim/contact/tree_kernels.h"

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

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
