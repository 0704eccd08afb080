// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/device/safe_device.h"

namespace palpate {

VelocityWindow::VelocityWindow(double step, int longest) : step_(step), longest_(longest) {
  if (!(step >= 0.0) || !std::isfinite(step)) {
    refuse("velocity window: step", write_text(step), "0 or more");
  }
  if (longest < 2 || longest > kLongest) {
    refuse("velocity window: longest", write_text(longest), write_text("2 to ", kLongest));
  }
}

/// The line through the newest reading and the one n before it passes every one between within a
/// step. Each reading is off by up to half of one, and so is the line.
bool VelocityWindow::fits(int n) const noexcept {
  const double slope = (value_ago(0) - value_ago(n)) / (time_ago(0) - time_ago(n));
  // readings may be off by rounding too where the step is zero
  const double allowed = step_ + 1e-12 * std::abs(value_ago(0));
  for (int i = 1; i < n; ++i) {
    const double on_line = value_ago(0) - slope * (time_ago(0) - time_ago(i));
    if (std::abs(value_ago(i) - on_line) > allowed) return false;
  }
  return true;
}

/// First-order adaptive windowing, end-fit [JanabiSharifiHaywardChen00]: the longest window in
/// which the line through its ends passes all readings within the step.
double VelocityWindow::add(double time, double value) noexcept {
  if (count_ > 0 && time == time_ago(0)) return speed_;
  if (count_ > 0 && time < time_ago(0)) clear();
  newest_ = (newest_ + 1) % kLongest;
  times_[slot(0)] = time;
  values_[slot(0)] = value;
  count_ = std::min(count_ + 1, longest_);
  length_ = 1;
  speed_ = 0.0;
  for (int n = 1; n < count_ && fits(n); ++n) {
    length_ = n + 1;
    speed_ = (value - value_ago(n)) / (time - time_ago(n));
  }
  return speed_;
}

void VelocityWindow::clear() noexcept {
  newest_ = -1;
  count_ = length_ = 0;
  speed_ = 0.0;
}

}  // namespace palpate
