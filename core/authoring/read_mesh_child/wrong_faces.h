// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "palpate/sim/base/error.h"

namespace palpate::authoring {

/// Faces that name a vertex that is not there, or are not there themselves where a file ends too
/// soon. A few of them leave holes in a surface that can be drawn; of more than that the whole file
/// is in doubt.
class WrongFaces {
 public:
  void add(FileError refusal, long count = 1) {
    if (!first_) first_ = std::move(refusal);
    count_ += count;
  }

  /// Notes how many were left out of `all` faces. Throws the first refusal where they are too many.
  void settle(long all, std::vector<std::string>& notes) const {
    if (!first_) return;
    if (static_cast<double>(count_) > kMost * static_cast<double>(all)) throw *first_;
    notes.push_back(std::to_string(count_) + " of " + std::to_string(all) +
                    " faces cannot be read and were left out; the first: " + first_->where +
                    ", got " + first_->got);
  }

 private:
  static constexpr double kMost = 0.01;

  std::optional<FileError> first_;
  long count_ = 0;
};

}  // namespace palpate::authoring
