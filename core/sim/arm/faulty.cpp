// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/private/random.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

constexpr std::size_t kRing = 1024;  // of what is in transit
constexpr double kSlack = 1e-9;      // [s] that times are rounded by

void require_share(const char* field, double value) {
  if (!(value >= 0.0 && value <= 1.0)) {
    refuse(std::string("faults: ") + field, write_text(value), "0 to 1");
  }
}

const Faults& validated(const Faults& faults) {
  validate(faults);
  return faults;
}

/// One number of a sample becomes nonsense.
void corrupt(HapticSample& sample, std::uint64_t& random) noexcept {
  const double nonsense[] = {std::nan(""), std::numeric_limits<double>::infinity(), 1e300};
  const double poison = nonsense[static_cast<int>(3.0 * draw(random))];
  switch (static_cast<int>(3.0 * draw(random))) {
    case 0:
      sample.position[static_cast<int>(3.0 * draw(random))] = poison;
      break;
    case 1:
      sample.velocity[static_cast<int>(3.0 * draw(random))] = poison;
      break;
    default:
      sample.orientation.coeffs()[static_cast<int>(4.0 * draw(random))] = poison;
  }
}

}  // namespace

void validate(const Faults& faults) {
  require_share("drop", faults.drop);
  require_share("corrupt", faults.corrupt);
  require_share("reorder", faults.reorder);
  if (!(faults.delay >= 0.0 && faults.delay <= 0.5)) {
    refuse("faults: delay [s]", write_text(faults.delay), "0 to 0.5");
  }
  if (std::isnan(faults.stick_at) || std::isnan(faults.unplug_at) || std::isnan(faults.cut_at)) {
    refuse("faults: stick_at, unplug_at, cut_at [s]", "a number that is not finite", "a time");
  }
}

FaultyDevice::FaultyDevice(HapticDevice& device, const Faults& faults)
    : device_(device),
      faults_(validated(faults)),
      random_(faults.seed),
      samples_(kRing),
      commands_(kRing) {}

HapticSample FaultyDevice::read(double time) noexcept {
  now_.store(time, std::memory_order_relaxed);
  if (failed()) return last_;
  HapticSample sample = device_.read(time);
  if (faults_.delay > 0.0) {
    samples_[next_sample_++ % kRing] = {time, sample, {}};
    // the newest that is old enough; before there is one, the first
    for (std::size_t back = 1; back <= std::min(next_sample_, kRing); ++back) {
      const Late& late = samples_[(next_sample_ - back) % kRing];
      sample = late.sample;
      if (late.time <= time - faults_.delay + kSlack) break;
    }
  }
  if (draw(random_) < faults_.corrupt) corrupt(sample, random_);
  if (draw(random_) < faults_.drop) sample = last_;
  if (holding_) {
    std::swap(sample, held_);
    holding_ = false;
  } else if (draw(random_) < faults_.reorder) {
    held_ = sample;
    holding_ = true;
    sample = last_;
  }
  if (time >= faults_.stick_at) sample = last_;
  last_ = sample;
  sample.time = time;
  return sample;
}

void FaultyDevice::write(const HapticCommand& command) noexcept {
  if (failed() || draw(random_) < faults_.drop) return;
  if (is_cut()) {
    device_.write({});
    return;
  }
  if (!(faults_.delay > 0.0)) {
    device_.write(command);
    return;
  }
  commands_[next_command_++ % kRing] = {time_now(), {}, command};
  for (std::size_t back = 1; back <= std::min(next_command_, kRing); ++back) {
    const Late& late = commands_[(next_command_ - back) % kRing];
    if (late.time > time_now() - faults_.delay + kSlack) continue;
    device_.write(late.command);
    return;
  }
}

void FaultyDevice::rest(double seconds) noexcept {
  if (!failed()) device_.rest(seconds);
}

std::string FaultyDevice::explain_fault() const {
  if (is_unplugged()) return "unplugged";
  return is_cut() ? "motors off: they were cut" : device_.explain_fault();
}

FaultyTransport::FaultyTransport(Transport& transport, const Faults& faults)
    : transport_(transport), faults_(validated(faults)), random_(faults.seed) {
  up_.ring.resize(kRing);
  down_.ring.resize(kRing);
}

bool FaultyTransport::is_open() const noexcept {
  return now_ < faults_.unplug_at && transport_.is_open();
}

void FaultyTransport::push(const Parcel& parcel, Channel& channel) const noexcept {
  if (channel.count < kRing) channel.ring[(channel.first + channel.count++) % kRing] = parcel;
}

/// What a frame suffers on its way.
void FaultyTransport::pass(double time, Parcel parcel, Channel& channel) noexcept {
  if (draw(random_) < faults_.drop) return;
  if (draw(random_) < faults_.corrupt) {
    const auto at = static_cast<std::size_t>(draw(random_) * double(parcel.count));
    parcel.bytes[at] ^= static_cast<std::uint8_t>(1 << static_cast<int>(8.0 * draw(random_)));
  }
  parcel.due = time + faults_.delay;
  if (channel.holding) {
    push(parcel, channel);
    channel.held.due = parcel.due;
    push(channel.held, channel);
    channel.holding = false;
  } else if (draw(random_) < faults_.reorder) {
    channel.held = parcel;
    channel.holding = true;
  } else {
    push(parcel, channel);
  }
}

/// Brings up what has come, frame by frame, and takes down what is due.
void FaultyTransport::pump(double time) noexcept {
  if (time < now_) {  // a new run: what is in transit arrives in it
    for (Channel* channel : {&up_, &down_}) {
      for (std::size_t i = 0; i < channel->count; ++i)
        channel->ring[(channel->first + i) % kRing].due = time;
    }
  }
  now_ = time;
  std::array<std::uint8_t, 256> bytes;
  for (std::size_t count = bytes.size(); count == bytes.size();) {
    count = transport_.read(time, bytes);
    for (std::size_t i = 0; i < count; ++i) {
      if (coming_.count < kLongest) coming_.bytes[coming_.count++] = bytes[i];
      if (bytes[i] != 0) continue;
      if (time < faults_.stick_at) last_ = coming_;
      pass(time, last_, up_);
      coming_.count = 0;
    }
  }
  for (; down_.count > 0 && down_.ring[down_.first].due <= time; --down_.count) {
    const Parcel& parcel = down_.ring[down_.first];
    transport_.write(time, std::span(parcel.bytes).first(parcel.count));
    down_.first = (down_.first + 1) % kRing;
  }
}

std::size_t FaultyTransport::read(double time, std::span<std::uint8_t> bytes) noexcept {
  pump(time);
  std::size_t count = 0;
  while (is_open() && count < bytes.size() && up_.count > 0 && up_.ring[up_.first].due <= time) {
    const Parcel& parcel = up_.ring[up_.first];
    if (parcel.count > 0) bytes[count++] = parcel.bytes[taken_++];
    if (taken_ < parcel.count) continue;
    taken_ = 0;
    up_.first = (up_.first + 1) % kRing;
    --up_.count;
  }
  return count;
}

void FaultyTransport::write(double time, std::span<const std::uint8_t> bytes) noexcept {
  if (!is_open() || bytes.size() > kLongest) return;
  Parcel parcel;
  parcel.count = bytes.size();
  std::copy(bytes.begin(), bytes.end(), parcel.bytes.begin());
  pass(time, parcel, down_);
  pump(time);
}

}  // namespace palpate
