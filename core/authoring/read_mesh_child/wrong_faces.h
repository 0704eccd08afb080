// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "palpate/sim/base/error.h"

namespace palpate::authoring {

/// Faces that name a vertex that is not there. A few of them leave holes in a surface that can be
/// drawn; of more than that the whole file is in doubt.
class WrongFaces {
 public:
  void add(FileError refusal) {
    if (!first_) first_ = std::move(refusal);
    ++count_;
  }

  /// Notes how many were left out of `all` faces. Throws the first refusal where they are too many.
  void settle(long all, std::vector<std::string>& notes) const {
    if (!first_) return;
    if (static_cast<double>(count_) > kMost * static_cast<double>(all)) throw *first_;
    notes.push_back(std::to_string(count_) + " of " + std::to_string(all) +
                    " faces were left out, which name vertices that are not there; the first: " +
                    first_->where + ", " + first_->got);
  }

 private:
  static constexpr double kMost = 0.01;

  std::optional<FileError> first_;
  long count_ = 0;
};

}  // namespace palpate::authoring
