// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/model/load.h"

namespace palpate {

/// The mean of the pushes of several substeps on a surface that stands still meanwhile, as one push
/// on each vertex: force and moment of the mean are kept exactly.
class MeanLoad {
 public:
  MeanLoad() = default;
  MeanLoad(std::span<const Triangle> triangles, std::size_t vertex_count);

  void add(std::span<const Push> pushes) noexcept;

  /// Writes what was added, divided by `substeps`, as the pushes of `load`, and begins again. No
  /// more pushes than there are vertices.
  void take(int substeps, Load& load) noexcept;

 private:
  std::vector<Triangle> triangles_;
  std::vector<std::array<int, 2>> corner_;  // per vertex: a triangle, and which corner of it
  Vec3Array force_;                         // [N] per vertex; zero where nothing was added
  std::vector<int> pushed_;                 // vertices; capacity
  std::size_t pushed_count_ = 0;
  std::vector<unsigned char> is_pushed_;
};

}  // namespace palpate
