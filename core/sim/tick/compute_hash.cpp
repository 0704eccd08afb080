// SPDX-License-Identifier: BSD-3-Clause
#include <bit>

#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

/// MurmurHash3 x64 128 [Appleby] over 64-bit words. Not against forgers: it finds the second in
/// which a replay departs.
class Hash {
 public:
  void add(std::uint64_t word) noexcept {
    if (count_++ % 2 == 0) {
      h_[0] ^= std::rotl(word * kC1, 31) * kC2;
      h_[0] = (std::rotl(h_[0], 27) + h_[1]) * 5 + 0x52dce729;
    } else {
      h_[1] ^= std::rotl(word * kC2, 33) * kC1;
      h_[1] = (std::rotl(h_[1], 31) + h_[0]) * 5 + 0x38495ab5;
    }
  }
  void add(double value) noexcept { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) noexcept {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }

  std::array<std::uint64_t, 2> finish() const noexcept {
    std::uint64_t a = h_[0] ^ count_ * 8, b = h_[1] ^ count_ * 8;
    a += b;
    b += a;
    a = mix(a);
    b = mix(b);
    a += b;
    b += a;
    return {a, b};
  }

 private:
  static constexpr std::uint64_t kC1 = 0x87c37b91114253d5, kC2 = 0x4cf5ad432745937f;

  static std::uint64_t mix(std::uint64_t k) noexcept {
    k = (k ^ (k >> 33)) * 0xff51afd7ed558ccd;
    k = (k ^ (k >> 33)) * 0xc4ceb9fe1a85ec53;
    return k ^ (k >> 33);
  }

  std::array<std::uint64_t, 2> h_{};
  std::uint64_t count_ = 0;
};

/// A record of one body has no numbers of bodies in its hashes.
void add_holds(const ToolState& tool, bool with_body, Hash& hash) noexcept {
  for (int h = 0; h < tool.hold_count; ++h) {
    const ToolState::Hold& hold = tool.holds[static_cast<std::size_t>(h)];
    if (with_body) hash.add(static_cast<std::uint64_t>(hold.body));
    hash.add(static_cast<std::uint64_t>(hold.triangle));
    hash.add(hold.weights);
    hash.add(hold.offset);
    hash.add(hold.stiffness);
    // those of before there were tied ones have none of this in their hashes
    if (hold.is_tied()) {
      hash.add(hold.normal);
      hash.add(hold.sideways);
    }
  }
}

/// A ball has no directions.
void add_orientation(const ToolState& tool, Hash& hash) noexcept {
  if (tool.orientation.coeffs() == Quaternion::Identity().coeffs()) return;
  for (int k = 0; k < 4; ++k) hash.add(tool.orientation.coeffs()[k]);
}

/// A tool without friction has no patch: its records have the hashes that they had.
void add_patch(const ToolState& tool, Hash& hash) noexcept {
  for (int k = 0; k < tool.patch_count; ++k) {
    const ToolState::PatchPoint& point = tool.patch[static_cast<std::size_t>(k)];
    hash.add(static_cast<std::uint64_t>(point.body));
    hash.add(static_cast<std::uint64_t>(point.triangle));
    hash.add(point.weights);
    hash.add(point.share);
  }
  if (tool.patch_count > 0) hash.add(tool.patch_position);
}

/// So has one without jaws.
void add_jaws(const ToolState& tool, Hash& hash) noexcept {
  if (tool.grip_limit == 0.0) return;
  hash.add(tool.jaw_angle);
  hash.add(tool.jaw_wanted);
  hash.add(tool.grip_limit);
  for (int k = 0; k < tool.anchor_count; ++k) {
    const ToolState::Anchor& anchor = tool.anchors[static_cast<std::size_t>(k)];
    hash.add(static_cast<std::uint64_t>(anchor.body));
    hash.add(static_cast<std::uint64_t>(anchor.triangle));
    hash.add(static_cast<std::uint64_t>(anchor.jaw));
    hash.add(anchor.weights);
    hash.add(anchor.place);
  }
  if (tool.felt_change == 0.0) return;
  hash.add(tool.felt_change);
  hash.add(tool.felt_before);
}

/// Of tissue that has torn.
void add_tears(const SoftState& body, Hash& hash) noexcept {
  const Tear& tear = internals(body).tear;
  for (std::size_t k = 0; k < tear.damage().size(); ++k) {
    const TearPart& part = tear.torn_part(k);
    for (int c = 0; c < part.corner_count; ++c) {
      hash.add(static_cast<std::uint64_t>(part.corners[static_cast<std::size_t>(c)]));
    }
    hash.add(tear.damage()[k]);
  }
}

/// Only where a device bounds it.
void add_coupling(const DeviceCoupling& device, Hash& hash) noexcept {
  if (device.stiffness == 0.0) return;
  hash.add(device.stiffness);
  hash.add(device.tissue);
}

}  // namespace

std::array<std::uint64_t, 2> compute_hash(const World& world) noexcept {
  Hash hash;
  for (const SoftState& body : world.bodies) {
    for (const Vec3& x : body.tissue.position) hash.add(x);
    for (const Vec3& v : body.tissue.velocity) hash.add(v);
  }
  for (const InstrumentState& instrument : world.instruments) {
    hash.add(instrument.tool.position);
    hash.add(static_cast<std::uint64_t>(instrument.tool.placed));
  }
  hash.add(static_cast<std::uint64_t>(world.alarm.kind));
  // records made before there were any have none in their hashes
  for (const SoftState& body : world.bodies) {
    if (body.safeguard != Safeguard::none) hash.add(static_cast<std::uint64_t>(body.safeguard));
  }
  for (const InstrumentState& instrument : world.instruments) {
    add_holds(instrument.tool, world.bodies.size() > 1, hash);
    add_orientation(instrument.tool, hash);
    add_patch(instrument.tool, hash);
    add_jaws(instrument.tool, hash);
    add_coupling(instrument.device, hash);
  }
  for (const SoftState& body : world.bodies) add_tears(body, hash);
  for (const RigidState& state : world.rigid) {
    hash.add(state.position);
    for (int k = 0; k < 4; ++k) hash.add(state.orientation.coeffs()[k]);
    hash.add(state.velocity);
    hash.add(state.angular_velocity);
  }
  return hash.finish();
}

}  // namespace palpate
