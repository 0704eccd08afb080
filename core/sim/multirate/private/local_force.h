// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/multirate/slow_tissue.h"

namespace palpate {

/// The force on one hand from local models that come at a rate of their own. Does not allocate,
/// lock or throw.
class LocalForce {
 public:
  /// Models come every `interval` [s].
  LocalForce(const Coupling& coupling, LocalForceMode mode, double interval) noexcept;

  /// From now on by this model. Under local_stiffness what the last one would go on to give beside
  /// it fades over half an interval.
  void take(const LocalModel& model, double now) noexcept;

  /// [N] on a hand at [m], the tool balanced between the hand's spring and F(p). A model whose hand
  /// is older than three intervals is stale: its force falls to 0 in 20 ms.
  Vec3 render(const Vec3& hand, double now) noexcept;

  /// [N/m] That the device keeps passive: the hand's spring is then fit_coupling()'s before the
  /// model's stiffness. 0, as at the start, for the instrument's own.
  void set_passive_stiffness(double passive) noexcept { passive_ = passive; }
  /// [N/m] Of the hand's spring before the model that is felt.
  double stiffness() const noexcept { return fit(model_).stiffness; }
  /// [N/m] Of that model, along its normal.
  double tissue() const noexcept { return model_.normal.dot(model_.stiffness * model_.normal); }

  const LocalModel& model() const noexcept { return model_; }
  bool is_stale(double now) const noexcept;

 private:
  Vec3 follow(const Vec3& hand, double now) const noexcept;
  Coupling fit(const LocalModel& model) const noexcept;

  Coupling coupling_;
  double passive_ = 0.0;  // [N/m]
  LocalForceMode mode_;
  double interval_;                 // [s]
  LocalModel model_, before_;       // the last told, and the one before it
  int told_ = 0;                    // models so far, 2 for more
  Vec3 left_over_ = Vec3::Zero();   // [N] of the model before, when the last came
  double taken_ = 0.0;              // [s] when
  Vec3 last_hand_ = Vec3::Zero();   // [m]
  Vec3 last_force_ = Vec3::Zero();  // [N]
  double stale_since_ = -1.0;       // [s]; negative while it is not
  Vec3 fade_from_ = Vec3::Zero();   // [N]
};

}  // namespace palpate
