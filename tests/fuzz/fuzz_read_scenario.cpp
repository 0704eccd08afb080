// SPDX-License-Identifier: BSD-3-Clause
// Whatever the bytes, the reader gives a scene that ticks or a FileError. Linked with libFuzzer
// (./run fuzz), and with mutate_scenarios.cpp as an ordinary test.
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "palpate/scenario/read.h"
#include "palpate/scenario/write.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

namespace {

using scenario::Array;
using scenario::Container;

/// Of one body through every migration, and of two as it is written today.
constexpr std::array kKept = {PALPATE_PUBLISHED "/v1.palpate", PALPATE_PUBLISHED "/v7.palpate"};
constexpr int kNewestVersion = 1 << 20;  // unpack() refuses no version, so neither does this

/// What is accepted must also run. A scene may ask for many substeps; that is slow, not wrong.
void run_ticks(const Scene& scene) {
  constexpr int kFewSubsteps = 50;
  for (const SoftBody& body : scene.bodies) {
    if (body.substeps_max > kFewSubsteps) return;
  }
  World world(scene);
  std::vector<HapticSample> hands(scene.instruments.size());
  std::vector<HapticCommand> commands(hands.size());
  for (int i = 0; i < 3; ++i) {
    for (HapticSample& hand : hands) {
      hand.position =
          scene.bodies.back().tissue.rest_position.front() + Vec3(0.0, 0.0, 0.002 - 0.001 * i);
    }
    tick(scene, hands, 1.0 / scene.rate, world, commands);
  }
}

/// Changes of a good container, behind the checksums that random bytes do not get past. Each takes
/// 12 bytes: what is changed, which one, where (2 bytes), and up to 8 bytes to put there. Whether
/// the first of them is above 127 says of which of the kept files.
void change(std::span<const std::uint8_t> order, Container& container) {
  const std::size_t where = order[2] | std::size_t{order[3]} << 8;
  auto at = container.arrays.begin();
  std::advance(at, order[1] % container.arrays.size());
  Array& array = at->second;
  const auto put = [&](auto& bytes, std::size_t count) {
    if (!bytes.empty()) {
      const std::size_t begin = where % bytes.size();
      std::memcpy(bytes.data() + begin, order.data() + 4, std::min(count, bytes.size() - begin));
    }
  };
  switch (order[0] % 6) {
    case 0:
      return put(array.bytes, 8);
    case 1:
      return put(array.bytes, 1);
    case 2:
      return put(container.content, 1);
    case 3:  // as many rows fewer as the first array had, or whatever else its bytes allow
      array.bytes.resize(array.bytes.size() - where % (array.bytes.size() + 1));
      array.shape = {static_cast<std::int64_t>(array.bytes.size() / width_of(array.dtype))};
      array.bytes.resize(static_cast<std::size_t>(array.shape[0]) * width_of(array.dtype));
      return;
    case 4:
      if (container.arrays.size() > 1) container.arrays.erase(at);
      return;
    case 5:
      container.content.insert(where % (container.content.size() + 1), 1,
                               static_cast<char>(order[4]));
      return;
  }
}

void read_bytes(std::span<const std::uint8_t> bytes) {
  run_ticks(scenario::unpack(scenario::unpack_container(bytes, "fuzzed", "palpate", kNewestVersion),
                             "fuzzed")
                .scene);
}

void read_changed(std::span<const std::uint8_t> orders) {
  static const std::array kept = {scenario::read_container(kKept[0], "palpate", kNewestVersion),
                                  scenario::read_container(kKept[1], "palpate", kNewestVersion)};
  constexpr std::size_t kOrderBytes = 12;
  Container changed = kept[!orders.empty() && orders[0] > 127];
  for (; orders.size() >= kOrderBytes; orders = orders.subspan(kOrderBytes)) {
    change(orders.first(kOrderBytes), changed);
  }
  run_ticks(scenario::unpack(std::move(changed), "fuzzed").scene);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  try {
    if (size >= 2 && data[0] == 'P' && data[1] == 'K') {
      read_bytes(bytes);
    } else {
      read_changed(bytes);
    }
  } catch (const FileError&) {
    // the one thing a reader may throw; anything else ends the process
  }
  return 0;
}
