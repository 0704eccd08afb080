// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

/// A number that carries its derivatives with respect to three variables along (forward
/// differentiation), so that a law written once for any number gives its own exact tangent.
struct Dual {
  double value = 0.0;
  Vec3 slope = Vec3::Zero();

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: constants mix freely with variables
  Dual(double at, const Vec3& derivative) : value(at), slope(derivative) {}
};

inline Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slope + b.slope};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slope - b.slope};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }

}  // namespace palpate
