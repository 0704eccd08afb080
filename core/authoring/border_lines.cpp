// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/border_lines.h"

#include <algorithm>
#include <limits>

#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {

BorderLines::BorderLines(const SurfaceMesh& mesh) {
  for (const auto& loop : find_border_loops(mesh.triangles)) {
    Vec3Array line;
    for (const int v : loop) line.push_back(mesh.vertices[v]);
    loops_.push_back(std::move(line));
  }
}

int BorderLines::find_loop(const Vec3& p) const {
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (int loop = 0; loop < static_cast<int>(loops_.size()); ++loop) {
    const double d = (find_closest(loop, p) - p).squaredNorm();
    if (d >= distance) continue;
    distance = d;
    nearest = loop;
  }
  return nearest;
}

Vec3 BorderLines::find_closest(int loop, const Vec3& p) const {
  const Vec3Array& line = loops_[loop];
  Vec3 closest = line.front();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec3 &a = line[i], along = line[(i + 1) % line.size()] - a;
    const double length2 = along.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    const Vec3 q = a + s * along;
    if ((q - p).squaredNorm() < (closest - p).squaredNorm()) closest = q;
  }
  return closest;
}

}  // namespace palpate::authoring
