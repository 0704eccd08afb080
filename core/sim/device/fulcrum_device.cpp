// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/fulcrum_device.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

/// [m] Of the shaft that is always beyond the trocar, and before it.
constexpr double kLeastInserted = 0.005, kLeastOutside = 0.005;

/// How a shaft lies: the unit vector from the trocar to its handle, and how long it is outside and
/// inside [m].
struct Shaft {
  Vec3 outward;
  double outside;
  double inside;
  bool slides;  // along itself, with the handle
};

Shaft lay_shaft(const Fulcrum& fulcrum, const Vec3& handle) noexcept {
  const Vec3 away = handle - fulcrum.trocar;
  const double far = away.norm();
  const double most = std::max(kLeastOutside, fulcrum.length - kLeastInserted);
  const double outside = std::clamp(far, kLeastOutside, most);
  return {far > 0.0 ? Vec3(away / far) : Vec3(Vec3::UnitZ()), outside,
          std::max(kLeastInserted, fulcrum.length - outside), outside == far};
}

}  // namespace

/// [contact: trocar]
///
///     p = c - u (L - |h - c|),   u = (h - c)/|h - c|
Vec3 compute_fulcrum_tip(const Fulcrum& fulcrum, const Vec3& handle) noexcept {
  const Shaft shaft = lay_shaft(fulcrum, handle);
  return fulcrum.trocar - shaft.outward * shaft.inside;
}

Vec3 compute_fulcrum_handle(const Fulcrum& fulcrum, const Vec3& tip) noexcept {
  return compute_fulcrum_tip(fulcrum, tip);  // a shaft has no preference for one of its ends
}

/// [contact: trocar] dp = u u·dh - (s/(L-s)) (1 - u u^T) dh, and F_h·dh = F·dp. A hand across the
/// shaft would then feel (s/(L-s))² K: of a leverage above 1 its inverse is taken.
Vec3 carry_force(const Fulcrum& fulcrum, const Vec3& handle, const Vec3& f) noexcept {
  const Shaft shaft = lay_shaft(fulcrum, handle);
  const double leverage = shaft.inside / shaft.outside;
  const Vec3 along = f.dot(shaft.outward) * shaft.outward;
  const Vec3 across = -std::min(leverage, 1.0 / leverage) * (f - along);
  return shaft.slides ? Vec3(along + across) : across;
}

FulcrumDevice::FulcrumDevice(HapticDevice& handle, const Fulcrum& fulcrum)
    : handle_(handle), fulcrum_(fulcrum), at_(fulcrum.trocar + fulcrum.length * Vec3::UnitZ()) {
  if (!fulcrum.trocar.allFinite()) {
    refuse("fulcrum: trocar [m]", "a number that is not finite", "a place");
  }
  if (!(std::isfinite(fulcrum.length) && fulcrum.length > 0.0)) {
    refuse("fulcrum: length [m]", write_text(fulcrum.length), "a positive number");
  }
}

/// The tip goes as fast as the handle takes it; how the stylus is turned is the handle's.
HapticSample FulcrumDevice::read(double time) noexcept {
  HapticSample sample = handle_.read(time);
  if (!sample.position.allFinite()) return sample;  // which SafeDevice refuses
  at_ = sample.position;
  const Shaft shaft = lay_shaft(fulcrum_, at_);
  const Vec3 along = sample.velocity.dot(shaft.outward) * shaft.outward;
  const Vec3 across = -(shaft.inside / shaft.outside) * (sample.velocity - along);
  sample.position = fulcrum_.trocar - shaft.outward * shaft.inside;
  sample.velocity = shaft.slides ? Vec3(along + across) : across;
  return sample;
}

void FulcrumDevice::write(const HapticCommand& command) noexcept {
  handle_.write(HapticCommand{carry_force(fulcrum_, at_, command.force)});
}

}  // namespace palpate
