// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <cstdlib>

namespace palpate::fuzz {

/// Ends the process where a claim does not hold: that is what a fuzzer searches for.
inline void insist(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", claim);
  std::abort();
}

/// Takes the bytes of a fuzzer's input one number after the other; zeros once they are spent.
class Input {
 public:
  Input(const unsigned char* data, unsigned long size) : at_(data), left_(size) {}

  bool empty() const { return left_ == 0; }
  unsigned char byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  short word() {
    const unsigned low = byte(), high = byte();
    return static_cast<short>(low | high << 8);
  }

 private:
  const unsigned char* at_;
  unsigned long left_;
};

}  // namespace palpate::fuzz
