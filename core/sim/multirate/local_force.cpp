// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/private/local_force.h"

#include <Eigen/LU>
#include <algorithm>

#include "palpate/sim/base/private/limit.h"

namespace palpate {
namespace {

/// Part of an interval over which what the last model gave beside the new one fades.
constexpr double kBlend = 0.5;

/// Intervals after which a model is stale.
constexpr double kStale = 3.0;

/// [s] In which the force of a stale model falls to 0: dropped at once it would be felt as a knock.
constexpr double kFadeTime = 0.02;

/// [s] More than any rounding of times.
constexpr double kRounding = 1e-9;

/// Tissue that is not held only pushes, and sideways no harder than outwards: beyond, the tool has
/// left the place that the model is of.
Vec3 push_only(const LocalModel& model, const Vec3& force) noexcept {
  if (model.held) return force;
  const double outward = model.normal.dot(force);
  if (!(outward > 0.0)) return Vec3::Zero();
  return outward * model.normal + limit(force - outward * model.normal, outward);
}

/// The hand's spring k and the tissue hold the massless tool between them,
///
///     k (h - p) + f0 - K (p - p0) = 0   =>   p = h + (k I + K)^-1 (f0 - K (h - p0))
///
/// and the hand feels k (p - h).
Vec3 balance(const LocalModel& model, const Coupling& coupling, const Vec3& hand) noexcept {
  const Mat3 both = coupling.stiffness * Mat3::Identity() + model.stiffness;
  const Vec3 at_hand = model.force - model.stiffness * (hand - model.position);
  const Vec3 force = coupling.stiffness * (both.inverse() * at_hand);
  return limit(push_only(model, force), coupling.force_max);
}

}  // namespace

LocalForce::LocalForce(const Coupling& coupling, LocalForceMode mode, double interval) noexcept
    : coupling_(coupling), mode_(mode), interval_(interval) {}

Coupling LocalForce::fit(const LocalModel& model) const noexcept {
  Coupling fitted = coupling_;
  if (passive_ > 0.0 && passive_ < coupling_.stiffness) {
    fitted.stiffness = fit_coupling(coupling_.stiffness, passive_,
                                    model.normal.dot(model.stiffness * model.normal));
  }
  return fitted;
}

Vec3 LocalForce::follow(const Vec3& hand, double now) const noexcept {
  if (told_ == 0) return Vec3::Zero();
  if (mode_ == LocalForceMode::hold) return model_.force;
  if (mode_ == LocalForceMode::extrapolation) {
    const double between = model_.time - before_.time;
    if (told_ < 2 || !(between > 0.0)) return model_.force;
    const Vec3 rate = (model_.force - before_.force) / between;
    return limit(model_.force + (now - model_.time) * rate, coupling_.force_max);
  }
  const double part = std::max(0.0, 1.0 - (now - taken_) / (kBlend * interval_));
  const Vec3 force = balance(model_, fit(model_), hand) + part * left_over_;
  // what fades may not hold a tool that the tissue has let go of
  return limit(model_.normal.isZero(0.0) ? force : push_only(model_, force), coupling_.force_max);
}

void LocalForce::take(const LocalModel& model, double now) noexcept {
  const Vec3 was = is_stale(now) ? last_force_ : follow(last_hand_, now);
  before_ = model_;
  model_ = model;
  told_ = std::min(told_ + 1, 2);
  taken_ = now;
  left_over_ = told_ == 1 ? Vec3(Vec3::Zero()) : Vec3(was - balance(model, fit(model), last_hand_));
}

bool LocalForce::is_stale(double now) const noexcept {
  return told_ > 0 && now - model_.time > kStale * interval_ + kRounding;
}

Vec3 LocalForce::render(const Vec3& hand, double now) noexcept {
  if (hand.allFinite()) last_hand_ = hand;
  if (!is_stale(now)) {
    stale_since_ = -1.0;
    last_force_ = follow(last_hand_, now);
    return last_force_;
  }
  if (stale_since_ < 0.0) {
    stale_since_ = now;
    fade_from_ = last_force_;
  }
  last_force_ = fade_from_ * std::max(0.0, 1.0 - (now - stale_since_) / kFadeTime);
  return last_force_;
}

}  // namespace palpate
