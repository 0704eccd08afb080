// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/private/clock_fit.h"

namespace palpate {
namespace {

constexpr double kForget = 1e-4;  ///< of the past, with each report
constexpr double kEnough = 0.01;  ///< [s²] of spread before a slope means something

}  // namespace

/// Weighted least squares with forgetting: means and centred sums are carried along, so nothing
/// grows over hours [West79].
double ClockFit::add(std::uint16_t tick, double time) noexcept {
  if (!begun_) last_tick_ = tick;
  if (!begun_ || restarted_) origin_ = time;
  begun_ = true;
  restarted_ = false;
  gap_ = static_cast<std::uint16_t>(tick - last_tick_);
  last_tick_ = tick;
  ticks_ += gap_;
  const double x = device_time(), y = time - origin_;
  const double slope = square_ > kEnough * weight_ ? product_ / square_ : 1.0;
  const double late = weight_ > 0.0 ? y - mean_host_ - slope * (x - mean_device_) : 0.0;

  const double keep = 1.0 - kForget;
  const double weight = keep * weight_ + 1.0;
  const double dx = x - mean_device_, dy = y - mean_host_;
  square_ = keep * square_ + dx * dx * keep * weight_ / weight;
  product_ = keep * product_ + dx * dy * keep * weight_ / weight;
  mean_device_ += dx / weight;
  mean_host_ += dy / weight;
  weight_ = weight;
  return late;
}

void ClockFit::restart() noexcept {
  restarted_ = true;
  weight_ = mean_device_ = mean_host_ = square_ = product_ = 0.0;
}

double ClockFit::drift() const noexcept {
  return square_ > kEnough * weight_ && product_ > 0.0 ? square_ / product_ - 1.0 : 0.0;
}

}  // namespace palpate
