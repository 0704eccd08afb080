// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>

namespace palpate {

/// Takes triangle indices into a buffer of fixed size, the lowest ones when there are too many.
class Collector {
 public:
  explicit Collector(std::span<int> out) noexcept : out_(out) {}

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
  int finish() noexcept {
    const std::size_t written = std::min(found_, out_.size());
    std::sort(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(written));
    return static_cast<int>(found_);
  }

 private:
  std::span<int> out_;
  std::size_t found_ = 0;
};

}  // namespace palpate
