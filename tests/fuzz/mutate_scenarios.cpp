// SPDX-License-Identifier: BSD-3-Clause
// The fuzz harness without a fuzzer: the same inputs on every run, for compilers that have none.
//
//     test_mutated_scenarios COUNT
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "palpate/scenario/container.h"
#include "palpate/scenario/read.h"
#include "palpate/scenario/whole_file.h"
#include "palpate/sim/base/error.h"

using palpate::scenario::Bytes;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// xorshift (Marsaglia 2003).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 1) {}

  std::size_t below(std::size_t limit) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>((state_ >> 11) % limit);
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }

 private:
  std::uint64_t state_;
};

/// What breaks parsers: none, all, the sign, one more than the largest.
constexpr std::uint32_t kEdges[] = {0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x7ff00000, 65535};

void put_edge(Random& random, Bytes& bytes, std::size_t at) {
  const std::uint32_t edge = kEdges[random.below(std::size(kEdges))];
  for (std::size_t b = 0; b < 4 && at + b < bytes.size(); ++b) {
    bytes[at + b] = static_cast<std::uint8_t>(edge >> (8 * b));
  }
}

/// A good file with one to four wounds. Those near its end are in the archive's directory.
Bytes wound(Random& random, Bytes bytes) {
  const std::size_t wounds = 1 + random.below(4);
  for (std::size_t i = 0; i < wounds && bytes.size() > 8; ++i) {
    const std::size_t reach =
        random.below(2) ? bytes.size() : std::min<std::size_t>(2500, bytes.size());
    const std::size_t at = bytes.size() - 1 - random.below(reach);
    const std::size_t end = at + random.below(bytes.size() - at);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(6)) {
      case 0:
        bytes[at] ^= static_cast<std::uint8_t>(1 << random.below(8));
        break;
      case 1:
        bytes[at] = random.byte();
        break;
      case 2:
        put_edge(random, bytes, at);
        break;
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes.erase(begin, bytes.begin() + static_cast<std::ptrdiff_t>(end));
        break;
      case 5:
        bytes.insert(begin, 1 + random.below(64), random.byte());
        break;
    }
  }
  if (bytes.size() > 1) bytes[0] = 'P', bytes[1] = 'K';
  return bytes;
}

/// Orders to the harness to change a good container behind its checksums.
Bytes give_orders(Random& random) {
  Bytes orders(12 * (1 + random.below(3)));
  for (std::uint8_t& byte : orders) byte = random.byte();
  for (std::size_t at = 4; at < orders.size(); at += 12) {
    if (random.below(2)) put_edge(random, orders, at + 4 * random.below(2));
  }
  return orders;
}

}  // namespace

int main(int count, char** words) {
  const int inputs = count > 1 ? std::atoi(words[1]) : 2000;
  const Bytes kept = palpate::scenario::read_whole(PALPATE_PUBLISHED "/v1.palpate",
                                                   palpate::scenario::kMostFileBytes);
  for (int i = 0; i < inputs; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Bytes input = i % 2 ? give_orders(random) : wound(random, kept);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%d inputs: each was read or refused\n", inputs);
}
