// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/timing.h"

#include <time.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace palpate::bench {
namespace {

double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double percentile(std::vector<double>& sorted, double p) {
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(p * static_cast<double>(sorted.size())))];
}

}  // namespace

BenchRow time_against(const BenchOptions& options, int batch, const std::function<void()>& ours,
                      const std::function<void()>& naive) {
  // a naive form may be a hundred times slower: a fifth of the budget still gives it a median
  constexpr double kNaiveShare = 0.2;
  constexpr double kMostBudgets = 20.0;
  std::vector<double> our_times, naive_times;
  double spent = 0.0, spent_naively = 0.0;
  ours();
  naive();
  const auto goes_on = [&] {
    if (spent < options.budget) return true;
    const int runs = static_cast<int>(our_times.size());
    return runs < options.least_runs && (spent < kMostBudgets * options.budget || runs < 3);
  };
  while (goes_on()) {
    const double start = thread_time();
    ours();
    const double middle = thread_time();
    our_times.push_back((middle - start) / batch);
    spent += middle - start;
    if (naive_times.empty() || spent_naively < kNaiveShare * spent) {
      const double before = thread_time();
      naive();
      naive_times.push_back((thread_time() - before) / batch);
      spent_naively += thread_time() - before;
    }
  }
  std::sort(our_times.begin(), our_times.end());
  std::sort(naive_times.begin(), naive_times.end());
  BenchRow row;
  row.median = percentile(our_times, 0.5);
  row.p99 = percentile(our_times, 0.99);
  row.naive_median = percentile(naive_times, 0.5);
  row.ratio_to_naive = row.naive_median / row.median;
  row.compiler_flags = PALPATE_COMPILER_FLAGS;
  return row;
}

double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = (a[i] - b[i]).norm();
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

void require_agreement(const std::string& work, double difference, double tolerance) {
  if (difference <= tolerance) return;
  std::ostringstream text;
  text << "bench: " << work << ": naive and real form end " << difference
       << " m apart, expected at most " << tolerance << " m";
  throw std::logic_error(text.str());
}

}  // namespace palpate::bench
