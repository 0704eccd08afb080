// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/serial_device.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "palpate/sim/arm/private/calibration_bytes.h"
#include "palpate/sim/arm/private/local_law.h"
#include "palpate/sim/arm/private/serial_link.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/device/safe_device.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;        // [s]
constexpr int kMostBridged = 3;       // missing reports
constexpr double kLongestGap = 5e-3;  // [s] that a joint goes on without a report
constexpr double kStatusTime = 8e-3;  // [s] between two of them
/// [s] Of a serial port that waits 1 ms, until it is measured.
constexpr double kUsualDelay = 2.2e-3;

// why the motors are cut, beside the firmware's own faults
constexpr int kNoCause = -1;
constexpr int kReset =
    100;  // it is as after a start: someone else spoke to it, or its power failed
constexpr int kUnheard = 101;
constexpr int kLost = 102;

}  // namespace

struct SerialDevice::Impl {
  Impl(Transport& transport, const Vec3& origin_in) : link(transport), origin(origin_in) {}

  void take_report(double time) noexcept;
  void listen(double time) noexcept;
  void watch_motors() noexcept;
  int find_cause() const noexcept;
  void publish(double time) noexcept;
  double bridge() const noexcept;
  Mat3 choose_law(const Vec3& force, const Vec3& torque, double share) noexcept;
  template <class Done>
  void wait_until_done(double timeout, const std::function<bool()>& stopped, Done done);

  SerialLink link;
  const Vec3 origin;
  Arm arm;
  bool has_arm = false, has_sample = false;
  std::array<VelocityWindow, 6> speeds;
  Vec3 joints = Vec3::Zero(), gimbal = Vec3::Zero(), tip = Vec3::Zero();
  HapticSample sample;       // of the last report
  Vec3 told = Vec3::Zero();  // [m] where the hand was said to be
  double device_time = 0.0;  // [s] of the last report
  double run_time = 0.0;     // [s] of the last read; all other times go on while the run is paused
  double rested = 0.0;       // [s] of pauses since the run began
  double report_time = 0.0, last_time = 0.0, last_status = -1.0;
  int missing = 0;  // reports that should have come since the last
  MotorState motors = MotorState::off;
  MotorState told_motors = MotorState::off;  // with the last status
  bool was_on = false;                       // in this run, and nobody has switched them off since
  bool was_clear = false;                    // of faults, in this run
  std::atomic<int> cause{kNoCause};
  bool was_read = false;
  bool has_news = false;  // a report came while it was waited for
  Vec3 force = Vec3::Zero();
  StiffnessWatch watch;
  double late = 0.0;             // [s] as a force is felt, some milliseconds ago
  double local_stiffness = 0.0;  // [N/m] of the last command
  Latest<DeviceStatus> statuses;
};

/// Angles of the newest report, and what the hand does by them: v = J dq/dt, the joints' speeds by
/// windows that adapt to what a count is. Between two counts a joint goes on as it went, never out
/// of what the count leaves open: steps of 0.3 mm would be impacts on the tissue, and this smooths
/// them without being late. The gimbal likewise, whose counts move the end of a shaft by 0.1 mm.
void SerialDevice::Impl::take_report(double time) noexcept {
  const Calibration* calibration = link.calibration();
  if (!calibration) return;
  if (!has_arm) {
    arm = find_arm(*calibration);
    for (std::size_t j = 0; j < 6; ++j) {
      speeds[j] = VelocityWindow(std::abs(calibration->joints[j].scale));
    }
    has_arm = true;
  }
  const std::array<double, 6> angles = compute_angles(*calibration, link.counts());
  const double dt = std::clamp(link.device_time() - device_time, 0.0, kLongestGap);
  device_time = link.device_time();
  Vec3 rates;
  for (int j = 0; j < 6; ++j) {
    const auto i = static_cast<std::size_t>(j);
    double& angle = j < 3 ? joints[j] : gimbal[j - 3];
    const double rate = speeds[i].add(device_time, angles[i]);
    const double half = 0.5 * std::abs(calibration->joints[i].scale);
    angle = std::clamp(angle + dt * rate, angles[i] - half, angles[i] + half);
    if (j < 3) rates[j] = rate;
  }
  tip = compute_tip(arm, joints);
  sample.position = origin + tip - Workspace{}.center;
  sample.orientation = compute_stylus(joints, gimbal);
  sample.velocity = compute_jacobian(arm, joints) * rates;
  sample.buttons = link.buttons();
  report_time = time;
  has_sample = true;
}

/// Takes what has come by `time`, and sees whether the motors are on.
void SerialDevice::Impl::listen(double time) noexcept {
  last_time = time;
  const bool came = link.receive(time);
  if (std::exchange(has_news, false) || came) take_report(time);
  const double since = std::clamp(time - report_time, 0.0, (kMostBridged + 1) * kTick);
  missing = static_cast<int>(std::floor(since / kTick + 0.01));
  watch_motors();
}

/// By the newest report. What ended the last host's run is cleared at the begin of ours, so it is
/// no fault of it; a silence after that is our own, even if the motors were never seen on.
void SerialDevice::Impl::watch_motors() noexcept {
  const bool heard = link.state() == LinkState::ready && link.has_report();
  if (heard && link.driving()) {
    motors = missing > kMostBridged ? MotorState::silent : MotorState::on;
    was_on = true;
    cause.store(kNoCause, std::memory_order_relaxed);
    return;
  }
  was_on = was_on && link.is_enabled();
  was_clear = was_clear || (heard && !link.faulted());
  const bool inherited = !was_clear && link.first_fault() == PALPATE_FAULT_HOST_SILENT;
  const bool faulted = heard && link.faulted() && !inherited;
  const bool cut = was_on || link.state() == LinkState::lost || (faulted && link.is_enabled());
  // a fault that was cleared is still why they are off until they are on
  if (cut && (motors != MotorState::cut || link.state() == LinkState::lost)) {
    cause.store(find_cause(), std::memory_order_relaxed);
  }
  motors = cut ? MotorState::cut : MotorState::off;
}

int SerialDevice::Impl::find_cause() const noexcept {
  if (link.state() == LinkState::lost) return kLost;
  if (link.state() != LinkState::ready || !link.has_report()) return kUnheard;
  return link.faulted() ? link.first_fault() : kReset;
}

/// 1 while reports come, or are but a little late, falling to 0 over the ones that may be missing.
double SerialDevice::Impl::bridge() const noexcept {
  return std::clamp(1.0 - double(missing - 1) / kMostBridged, 0.0, 1.0);
}

/// The joints' stiffness [N·m/rad] that goes out beside `torque`, of J^T K J. None where a report
/// is missing, for that would be taken for motion, nor where the motors give all they have, for
/// then the force does not grow. The motors brake at least as those of the design do, which are the
/// weakest of firmware/BUILDING.md.
Mat3 SerialDevice::Impl::choose_law(const Vec3& wanted, const Vec3& torque, double share) noexcept {
  local_stiffness = 0.0;
  const Mat3 stiffness = share * watch.add(told, wanted);
  const Vec3 most = link.torque_max();
  const bool spent = (torque.cwiseAbs().array() > 0.999 * most.array()).any();
  if (missing > 0 || spent || stiffness.isZero(0.0) || !link.obeys_law()) return Mat3::Zero();
  const Mat3 jacobian = compute_jacobian(arm, joints);
  const Mat3 law = choose_local_stiffness(Mat3(jacobian.transpose() * stiffness * jacobian), late,
                                          compute_motor_damping(Motor{}));
  const Vec3 turned = jacobian.inverse() * wanted.normalized();
  local_stiffness = turned.dot(law * turned);
  return law;
}

void SerialDevice::Impl::publish(double time) noexcept {
  const bool is_due = time - last_status >= kStatusTime || time < last_status;
  if (!is_due && motors == told_motors) return;
  last_status = time;
  told_motors = motors;
  DeviceStatus& status = statuses.back();
  link.fill(status);
  // half a tick of holding it, if the acknowledgement did not wait for the next one
  late = status.round_trip_median > 0.0 ? status.round_trip_median + 0.5 * kTick : 0.0;
  status.local_stiffness = local_stiffness;
  status.degraded = missing > 0 && link.state() == LinkState::ready;
  status.buttons = link.buttons();
  status.joints = joints;
  status.gimbal = gimbal;
  status.tip = tip;
  status.force_commanded = force;
  if (const Calibration* calibration = link.calibration(); calibration && has_arm) {
    Vec3 torque;
    for (int m = 0; m < 3; ++m) {
      torque[m] = calibration->torque_full[m] * link.duty(m) / 255.0;
    }
    status.force_applied = link.driving() ? compute_tip_force(arm, joints, torque) : Vec3::Zero();
  }
  statuses.publish();
}

/// Listens and asks until `done`, in the transport's own time: a simulated device has passed
/// through all of it at once, a real one keeps the caller waiting.
template <class Done>
void SerialDevice::Impl::wait_until_done(double timeout, const std::function<bool()>& stopped,
                                         Done done) {
  const double begun = link.now(0.0);
  run_time = rested = 0.0;
  for (double time = 0.0; time < timeout; time += kTick) {
    link.receive(time);
    last_time = time;
    if (done()) return;
    if (link.state() == LinkState::lost || (stopped && stopped())) break;
    // none to wait for where the transport goes by our time
    const double early = time + kTick - (link.now(time + kTick) - begun);
    if (early > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(early));
  }
  throw DeviceError(link.name() + ": " + link.explain_silence());
}

SerialDevice::SerialDevice(Transport& transport, const Vec3& origin)
    : impl_(std::make_unique<Impl>(transport, origin)) {
  impl_->sample.position = origin;
}

SerialDevice::~SerialDevice() { impl_->link.disable(impl_->last_time); }

HapticSample SerialDevice::read(double time) noexcept {
  Impl& my = *impl_;
  my.was_read = true;
  if (time < my.run_time || time + my.rested < my.last_time) {  // a new run begins
    my.rested = 0.0;
    my.report_time = time;
    my.was_on = my.was_clear = false;
  }
  my.run_time = time;
  const double now = time + my.rested;
  my.listen(now);

  const double since = std::clamp(now - my.report_time, 0.0, (kMostBridged + 1) * kTick);
  HapticSample sample = my.sample;
  sample.time = time;
  sample.position += std::min(since, kMostBridged * kTick) * sample.velocity;
  if (my.missing > kMostBridged) sample.velocity.setZero();
  my.told = sample.position;
  my.publish(now);
  return sample;
}

void SerialDevice::write(const HapticCommand& command) noexcept {
  Impl& my = *impl_;
  if (!my.was_read) my.link.receive(my.last_time);  // a pause, in which nobody asks for the hand
  const bool paused = !std::exchange(my.was_read, false);
  my.force = command.force;
  Vec3 torque = Vec3::Zero();
  Mat3 law = Mat3::Zero();
  if (my.has_arm) {
    const double share = paused ? 0.0 : my.bridge() * compute_edge_fade(my.arm, my.joints);
    torque = compute_torque(my.arm, my.joints, share * command.force, my.link.torque_max());
    law = my.choose_law(command.force, torque, share);
  }
  if (my.missing <= kMostBridged || paused) my.link.command(my.last_time, torque, law);
}

void SerialDevice::end() noexcept {
  write({});
  impl_->link.disable(impl_->last_time);
  impl_->was_on = false;
}

/// Time goes on for the link: orders are given and asked for again, and the device hears its host.
void SerialDevice::rest(double seconds) noexcept {
  Impl& my = *impl_;
  my.rested += std::max(seconds, 0.0);
  my.listen(my.last_time + std::max(seconds, 0.0));
  my.force.setZero();
  my.publish(my.last_time);
  my.was_read = false;
  write({});
}

MotorState SerialDevice::motors() const noexcept { return impl_->motors; }

std::string SerialDevice::explain_fault() const {
  const int cause = impl_->cause.load(std::memory_order_relaxed);
  DeviceStatus status;
  status.link = cause == kLost ? LinkState::lost : LinkState::ready;
  switch (cause) {
    case kNoCause:
      return {};
    case kReset:
      return "motors off: the device was reset, or another program speaks with it";
    case kUnheard:
      return "motors off: the device does not report any more";
    default:
      status.mode = DeviceMode::faulted;
      status.first_fault = cause;
      return describe_status(status);
  }
}

std::string SerialDevice::name() const { return "serial device on " + impl_->link.name(); }
bool SerialDevice::failed() const noexcept { return impl_->link.state() == LinkState::lost; }

/// A tip that moves by v turns the joints by J^-1 v, and is braked by b J^-T J^-1 v: the least of
/// that is b over the largest square of J.
DeviceDynamics SerialDevice::dynamics() const noexcept {
  const Impl& my = *impl_;
  if (!my.has_arm) return {};
  const Mat3 jacobian = compute_jacobian(my.arm, my.joints);
  const Mat3 squares = jacobian.transpose() * jacobian;
  const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(squares).eigenvalues()[2];
  return {.damping = compute_motor_damping(Motor{}) / largest,
          .delay = my.late > 0.0 ? my.late - 0.5 * kTick : kUsualDelay};
}

double SerialDevice::report_rate() const noexcept {
  const bool can_wait = impl_->link.can_wait() && impl_->link.state() == LinkState::ready;
  return can_wait ? double(PALPATE_TICK_HZ) : 0.0;
}

bool SerialDevice::wait_for_report(std::int64_t latest) noexcept {
  Impl& my = *impl_;
  // a frame comes in pieces
  while (!my.has_news && my.link.wait(latest)) {
    my.has_news = my.link.receive(my.last_time);
    if (my.link.state() == LinkState::lost) return false;
  }
  return my.has_news;
}

void SerialDevice::clear_fault() noexcept { impl_->link.clear_fault(); }
void SerialDevice::enable(bool on) noexcept { impl_->link.enable(on); }
bool SerialDevice::take_status() noexcept { return impl_->statuses.take(); }
const DeviceStatus& SerialDevice::status() const noexcept { return impl_->statuses.front(); }

void SerialDevice::open(double timeout, const std::function<bool()>& stopped) {
  Impl& my = *impl_;
  my.link.greet();
  my.wait_until_done(timeout, stopped, [&my] {
    return (my.link.state() == LinkState::ready || my.link.state() == LinkState::uncalibrated) &&
           my.link.has_report();
  });
  my.take_report(my.last_time);
  my.missing = 0;
  my.last_status = -1.0;
  my.publish(my.last_time);
}

Calibration SerialDevice::calibration() const {
  const Calibration* found = impl_->link.calibration();
  if (!found) throw DeviceError(name() + ": has no calibration");
  return *found;
}

void SerialDevice::store(const Calibration& calibration, double timeout,
                         const std::function<bool()>& stopped) {
  Impl& my = *impl_;
  my.link.begin_store(write_calibration(calibration));
  my.wait_until_done(timeout, stopped,
                     [&my] { return my.link.store_result() != StoreResult::under_way; });
  if (my.link.store_result() == StoreResult::refused) {
    throw DeviceError(name() + ": did not take the calibration: " + my.link.store_refusal());
  }
  my.has_arm = false;
  open(timeout, stopped);
}

}  // namespace palpate
