// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

namespace palpate {

/// Takes triangle indices into a buffer of fixed size, the lowest ones when there are too many.
class Collector {
 public:
  explicit Collector(std::span<int> out) noexcept : out_(out) {}

  /// Those of a leaf whose bit is set.
  void add(std::span<const int> triangles, unsigned chosen) noexcept {
    if (found_ + triangles.size() < out_.size()) {
      // all are put down and the chosen ones counted: which they are cannot be guessed
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        out_[found_] = triangles[k];
        found_ += chosen >> k & 1u;
      }
      return;
    }
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if ((chosen >> k & 1u) != 0) add(triangles[k]);
    }
  }
  int finish() noexcept {
    const std::size_t written = std::min(found_, out_.size());
    if (written <= kFew) {
      sort_few(out_.first(written));
    } else {
      std::sort(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(written));
    }
    return static_cast<int>(found_);
  }

 private:
  static constexpr std::size_t kFew = 8;

  void add(int triangle) noexcept {
    if (found_ < out_.size()) {
      out_[found_] = triangle;
      if (found_ + 1 == out_.size()) std::make_heap(out_.begin(), out_.end());
    } else if (!out_.empty() && triangle < out_.front()) {
      std::pop_heap(out_.begin(), out_.end());
      out_.back() = triangle;
      std::push_heap(out_.begin(), out_.end());
    }
    ++found_;
  }

  /// Batcher's network of 19 exchanges [Knuth98], without a branch to guess.
  static void sort_few(std::span<int> few) noexcept {
    static constexpr std::pair<int, int> kExchanges[] = {
        {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {1, 2}, {5, 6},
        {0, 4}, {1, 5}, {2, 6}, {3, 7}, {2, 4}, {3, 5}, {1, 2}, {3, 4}, {5, 6}};
    std::array<int, kFew> all;
    all.fill(std::numeric_limits<int>::max());
    std::copy(few.begin(), few.end(), all.begin());
    for (const auto& [i, j] : kExchanges) {
      int &a = all[static_cast<std::size_t>(i)], &b = all[static_cast<std::size_t>(j)];
      const int lower = std::min(a, b);
      b = std::max(a, b);
      a = lower;
    }
    std::copy_n(all.begin(), few.size(), few.begin());
  }

  std::span<int> out_;
  std::size_t found_ = 0;
};

}  // namespace palpate
