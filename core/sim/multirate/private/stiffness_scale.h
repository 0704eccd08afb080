// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/multirate/slow_tissue.h"

namespace palpate {

/// By how much the stiffness of local models must be multiplied, as a tissue itself has shown from
/// exchange to exchange [stability: slow tissue]: what is held around the particles that a model is
/// of, memory, inertia and a curved wall all make it another.
class StiffnessScale {
 public:
  /// Of a hand at `hand` [m] behind a spring of `coupling` [N/m]: compares what `measured` says
  /// with what the model before has foretold of a hand there, and multiplies its stiffness. Models
  /// must come in the order of their exchanges.
  void follow(const Vec3& hand, double coupling, LocalModel& measured) noexcept;
  double value() const noexcept { return value_; }

 private:
  double value_ = 1.0;
  bool touched_ = false;      // before_ is of a tissue that was touched
  LocalModel before_;         // as it was measured
  Vec3 hand_ = Vec3::Zero();  // [m] of that
};

}  // namespace palpate
