// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/conformance.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

constexpr double kLongest = 24 * 3600.0;  // [s]
constexpr double kFastestRate = 1e5;      // [Hz]
constexpr double kFastestHand = 5.0;      // [m/s] a device that says more jumps
constexpr double kUnit = 1e-6;            // how far from 1 the norm of an orientation may be
constexpr double kVelocitySlack = 0.05;   // [m/s] mean difference of velocity and motion
constexpr double kVelocityShare = 0.25;   // of the mean speed, on top

/// What was seen in one run of ticks.
struct Seen {
  long ticks = 0, not_finite = 0, wrong_time = 0, not_unit = 0, came_back = 0;
  double fastest = 0.0;    ///< [m/s] from one sample to the next
  double travelled = 0.0;  ///< [m]
  double time = 0.0;       ///< [s]
  Vec3 moved = Vec3::Zero(), integrated = Vec3::Zero();
};

bool is_finite(const HapticSample& sample) noexcept {
  return std::isfinite(sample.time) && sample.position.allFinite() &&
         sample.orientation.coeffs().allFinite() && sample.velocity.allFinite() &&
         std::isfinite(sample.grip);
}

/// Runs the device as the loop would; `force` says what is sent at each tick.
class Runner {
 public:
  Runner(HapticDevice& device, const ConformanceOptions& options,
         const std::function<bool()>& stopped)
      : device_(device), options_(options), stopped_(stopped), begun_(read_clock()) {}

  template <class Force>
  Seen run(Force force) {
    const double dt = 1.0 / options_.rate;
    Seen seen;
    HapticSample last;
    for (long k = 0; k < std::lround(options_.duration * options_.rate); ++k, time_ += dt) {
      if (stopped_ && stopped_()) break;
      if (options_.live) wait_until(begun_ + std::llround(1e9 * time_), 0);
      const HapticSample sample = device_.read(time_);
      device_.write({.force = force(k)});
      failed_before_ = failed_before_ || device_.failed();
      seen.came_back += failed_before_ && !device_.failed();
      seen.not_finite += !is_finite(sample);
      seen.wrong_time += std::abs(sample.time - time_) > 1e-9;
      seen.not_unit += std::abs(sample.orientation.norm() - 1.0) > kUnit;
      if (k > 0 && is_finite(sample)) note_motion(last, sample, dt, seen);
      if (is_finite(sample)) last = sample;
      ++seen.ticks;
    }
    return seen;
  }

 private:
  static void note_motion(const HapticSample& last, const HapticSample& now, double dt,
                          Seen& seen) noexcept {
    const Vec3 step = now.position - last.position;
    seen.fastest = std::max(seen.fastest, step.norm() / dt);
    seen.travelled += step.norm();
    seen.moved += step;
    seen.integrated += 0.5 * dt * (last.velocity + now.velocity);
    seen.time += dt;
  }

  HapticDevice& device_;
  const ConformanceOptions& options_;
  const std::function<bool()>& stopped_;
  const std::int64_t begun_;
  double time_ = 0.0;
  bool failed_before_ = false;
};

void note(std::vector<DeviceCheck>& checks, const std::string& name, bool passed,
          const std::string& detail) {
  checks.push_back({name, passed, detail});
}

void judge_samples(const Seen& seen, std::vector<DeviceCheck>& checks) {
  const auto of = [&seen](long count) { return write_text(count, " of ", seen.ticks, " samples"); };
  note(checks, "every number of a sample is finite", seen.not_finite == 0, of(seen.not_finite));
  note(checks, "a sample carries the time it was asked for", seen.wrong_time == 0,
       of(seen.wrong_time) + " do not");
  note(checks, "the orientation is a unit quaternion", seen.not_unit == 0,
       of(seen.not_unit) + " are none");
  note(checks, "the hand never jumps", seen.fastest <= kFastestHand,
       write_text("at most ", seen.fastest, " m/s, allowed ", kFastestHand));
  const double off = seen.time > 0.0 ? (seen.moved - seen.integrated).norm() / seen.time : 0.0;
  const double allowed =
      kVelocitySlack + (seen.time > 0.0 ? kVelocityShare * seen.travelled / seen.time : 0.0);
  note(checks, "the velocity is that of the position", off <= allowed,
       write_text("off by ", off, " m/s on the mean, allowed ", allowed));
}

}  // namespace

std::vector<DeviceCheck> check_conformance(HapticDevice& device, const ConformanceOptions& options,
                                           const std::function<bool()>& stopped) {
  if (!(options.duration > 0.0) || !(options.rate > 0.0) || !(options.force >= 0.0) ||
      !std::isfinite(options.duration * options.rate * options.force)) {
    refuse("conformance: options",
           write_text(options.duration, " s, ", options.rate, " Hz, ", options.force, " N"),
           "a duration and a rate above 0, a force of 0 or more");
  }
  if (options.duration > kLongest || options.rate > kFastestRate) {
    refuse("conformance: options", write_text(options.duration, " s at ", options.rate, " Hz"),
           write_text("at most a day at ", kFastestRate, " Hz"));
  }
  std::vector<DeviceCheck> checks;
  note(checks, "it has a name", !device.name().empty(), device.name());
  Runner runner(device, options, stopped);
  judge_samples(runner.run([](long) { return Vec3::Zero(); }), checks);

  const Seen pushed = runner.run([&options](long k) {
    const double size = options.force * std::sin(0.02 * double(k));
    return Vec3(size, 0.5 * size, -size);
  });
  note(checks, "forces leave its samples finite and in time",
       pushed.not_finite == 0 && pushed.wrong_time == 0,
       write_text(pushed.not_finite, " not finite, ", pushed.wrong_time, " out of time"));
  note(checks, "forces do not make the hand jump", pushed.fastest <= kFastestHand,
       write_text("at most ", pushed.fastest, " m/s, allowed ", kFastestHand));
  note(checks, "a failure stays one", pushed.came_back == 0,
       write_text("came back ", pushed.came_back, " times"));
  note(checks, "it has not failed", !device.failed(), device.failed() ? "failed" : "in order");
  device.write({});
  return checks;
}

}  // namespace palpate
