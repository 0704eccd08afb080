// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/simulated_devices.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace palpate {
namespace {

constexpr double kGlideTime = 15e-3;   // [s]
constexpr double kFastestGlide = 1.0;  // [m/s]

/// [s] The hand makes up no more than this at once. Where ticks are missed it falls behind instead:
/// a longer path in one tick asks for more substeps, and those would cost the next ticks too.
constexpr double kLongestGlide = 1.5e-3;

/// Throws std::invalid_argument naming the first frame that is wrong.
void validate(const std::vector<KeyFrame>& frames) {
  if (frames.empty()) {
    throw std::invalid_argument("script: got no key frames, expected at least one");
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const KeyFrame& frame = frames[i];
    const std::string where = "script: key frame " + std::to_string(i);
    if (!std::isfinite(frame.time) || !frame.position.allFinite()) {
      throw std::invalid_argument(where +
                                  ": got a number that is not finite, expected finite ones");
    }
    if (i > 0 && !(frame.time > frames[i - 1].time)) {
      throw std::invalid_argument(where + ": time: got " + std::to_string(frame.time) +
                                  " s, expected more than " + std::to_string(frames[i - 1].time) +
                                  " s of the frame before");
    }
  }
}

}  // namespace

ScriptedDevice::ScriptedDevice(std::vector<KeyFrame> frames) : frames_(std::move(frames)) {
  validate(frames_);
}

/// Between frames a and b the hand takes the path of least jerk [FlashHogan85],
///
///     x = a + (b - a) (10 u^3 - 15 u^4 + 6 u^5),   u = (t - t_a) / (t_b - t_a),
///
/// which starts and ends without speed or acceleration.
HapticSample ScriptedDevice::read(double time) noexcept {
  const auto next =
      std::upper_bound(frames_.begin(), frames_.end(), time,
                       [](double t, const KeyFrame& frame) { return t < frame.time; });
  HapticSample sample;
  sample.time = time;
  if (next == frames_.begin()) {
    sample.position = frames_.front().position;
    return sample;
  }
  const KeyFrame& a = *(next - 1);
  sample.position = a.position;
  sample.buttons = a.buttons;
  if (next == frames_.end()) return sample;

  const Vec3 displacement = next->position - a.position;
  const double duration = next->time - a.time;
  const double u = (time - a.time) / duration;
  sample.position += u * u * u * (10.0 + u * (6.0 * u - 15.0)) * displacement;
  sample.velocity = 30.0 * u * u * (1.0 - u) * (1.0 - u) / duration * displacement;
  return sample;
}

void PointerDevice::set(const HapticSample& sample) {
  samples_.back() = sample;
  samples_.publish();
}

HapticSample PointerDevice::read(double time) noexcept {
  const bool is_new = samples_.take();
  const HapticSample& wanted = samples_.front();
  const double dt = std::max(0.0, time - hand_.time);
  Vec3 position = hand_.position;
  Vec3 velocity = Vec3::Zero();
  if (!has_hand_) {
    position = wanted.position;
  } else if (dt > 0.0) {
    const Vec3 displacement = wanted.position - position;
    const double glide = std::min(dt, kLongestGlide);
    const Vec3 part = displacement * (1.0 - std::exp(-glide / kGlideTime));
    const double most = kFastestGlide * glide;
    const Vec3 move = part.norm() > most ? Vec3(part * (most / part.norm())) : part;
    // the last nanometre at once: a hand that rests must not creep for ever
    position = displacement.norm() < 1e-9 ? wanted.position : Vec3(position + move);
    velocity = (position - hand_.position) / dt;
  }
  has_hand_ = has_hand_ || is_new;
  hand_ = wanted;
  hand_.time = time;
  hand_.position = position;
  hand_.velocity = velocity;
  return hand_;
}

void PointerDevice::write(const HapticCommand& command) noexcept {
  commands_.back() = command;
  commands_.publish();
}

HapticCommand PointerDevice::take_command() noexcept {
  commands_.take();
  return commands_.front();
}

ReplayDevice::ReplayDevice(std::vector<HapticSample> samples) : samples_(std::move(samples)) {
  if (samples_.empty()) {
    throw std::invalid_argument("replay: got no samples, expected at least one");
  }
}

HapticSample ReplayDevice::read(double) noexcept {
  if (next_ < samples_.size()) return samples_[next_++];
  return samples_.back();
}

}  // namespace palpate
