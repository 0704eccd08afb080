// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/limits.h"

#include <algorithm>
#include <chrono>

#include "palpate/sim/base/private/vector_targets.h"
#include "palpate/sim/base/types.h"

#ifdef PALPATE_SIMD

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/bench/limits.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace palpate::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Ten chains, enough to keep two units of four or five cycles latency busy. Returns the count of
/// operations done; `out` keeps the compiler from leaving them out.
double multiply_and_add(int rounds, float* out) {
  const hn::CappedTag<float, 16> d;
  const auto factor = hn::Set(d, 0.999f), more = hn::Set(d, 1e-3f);
  auto a = hn::Iota(d, 0), b = a, c = a, e = a, f = a, g = a, h = a, i = a, j = a, k = a;
  for (int r = 0; r < rounds; ++r) {
    a = hn::MulAdd(a, factor, more), b = hn::MulAdd(b, factor, more);
    c = hn::MulAdd(c, factor, more), e = hn::MulAdd(e, factor, more);
    f = hn::MulAdd(f, factor, more), g = hn::MulAdd(g, factor, more);
    h = hn::MulAdd(h, factor, more), i = hn::MulAdd(i, factor, more);
    j = hn::MulAdd(j, factor, more), k = hn::MulAdd(k, factor, more);
  }
  const auto ab = hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)), hn::Add(f, g));
  hn::StoreU(hn::Add(ab, hn::Add(hn::Add(h, i), hn::Add(j, k))), d, out);
  return 20.0 * rounds * static_cast<double>(hn::Lanes(d));
}

void read_all(const float* from, std::size_t count, float* out) {
  const hn::CappedTag<float, 16> d;
  const std::size_t width = hn::Lanes(d);
  auto a = hn::Zero(d), b = a, c = a, e = a;
  for (std::size_t i = 0; i + 4 * width <= count; i += 4 * width) {
    a = hn::Add(a, hn::Load(d, from + i)), b = hn::Add(b, hn::Load(d, from + i + width));
    c = hn::Add(c, hn::Load(d, from + i + 2 * width));
    e = hn::Add(e, hn::Load(d, from + i + 3 * width));
  }
  hn::StoreU(hn::Add(hn::Add(a, b), hn::Add(c, e)), d, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace palpate::bench {
namespace {

struct Work {
  std::int64_t target;
  double (*multiply_and_add)(int rounds, float* out);
  void (*read_all)(const float* from, std::size_t count, float* out);
};

constexpr Work kWorks[] = {
#if HWY_ARCH_X86
    {HWY_AVX3, HWY_CHOOSE_AVX3(multiply_and_add), HWY_CHOOSE_AVX3(read_all)},
    {HWY_AVX2, HWY_CHOOSE_AVX2(multiply_and_add), HWY_CHOOSE_AVX2(read_all)},
    {HWY_SSE4, HWY_CHOOSE_SSE4(multiply_and_add), HWY_CHOOSE_SSE4(read_all)},
#elif HWY_ARCH_ARM
    {HWY_NEON, HWY_CHOOSE_NEON(multiply_and_add), HWY_CHOOSE_NEON(read_all)},
#endif
};

/// [1/s] The best of some tries: a limit is what nothing disturbed.
template <class Action>
double measure_rate(double amount, Action action) {
  double best = 0.0;
  for (int i = 0; i < 15; ++i) {
    const auto start = std::chrono::steady_clock::now();
    action();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    best = std::max(best, amount / taken.count());
  }
  return best;
}

}  // namespace

Limits measure_limits(std::string_view target, std::size_t working_set) {
  Limits limits;
  for (const Work& work : kWorks) {
    if (work.read_all == nullptr || target != hwy::TargetName(work.target)) continue;
    float out[16];
    constexpr int kRounds = 20000;
    const double operations = work.multiply_and_add(kRounds, out);
    limits.operations = measure_rate(operations, [&] { work.multiply_and_add(kRounds, out); });
    const CacheAligned<float> memory(working_set / sizeof(float), 1.0f);
    const auto passes = static_cast<int>(1 + (std::size_t{4} << 20) / (working_set + 1));
    limits.bytes = measure_rate(double(working_set) * passes, [&] {
      for (int p = 0; p < passes; ++p) work.read_all(memory.data(), memory.size(), out);
    });
  }
  return limits;
}

}  // namespace palpate::bench
#endif

#else

namespace palpate::bench {

Limits measure_limits(std::string_view, std::size_t) { return {}; }

}  // namespace palpate::bench

#endif

#if !defined(HWY_ONCE) || HWY_ONCE
namespace palpate::bench {

double compute_bound(const Limits& limits, double operations, double bytes) {
  if (!(limits.operations > 0.0)) return 0.0;
  return std::max(operations / limits.operations, bytes / limits.bytes);
}

}  // namespace palpate::bench
#endif
