// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/triangulate.h"

#include <algorithm>

namespace palpate::authoring {
namespace {

/// A polygon of more than this is fanned out: ears are looked for in the square of the corners.
constexpr std::size_t kMostCorners = 2000;

/// A corner of the polygon that is left: which vertex, and where it lies in the polygon's plane.
struct Corner {
  int vertex;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Corners without repetitions, seen along the vector area, half the sum of p_i x p_i+1.
std::vector<Corner> flatten(std::span<const int> corners, const Vec3Array& vertices) {
  std::vector<Corner> left;
  for (const int vertex : corners) {
    if (left.empty() || left.back().vertex != vertex) left.push_back({vertex});
  }
  while (left.size() > 1 && left.back().vertex == left.front().vertex) left.pop_back();
  if (left.empty()) return left;

  const Vec3 origin = vertices[left.front().vertex];
  const auto from_origin = [&](std::size_t i) -> Vec3 {
    return vertices[left[i % left.size()].vertex] - origin;
  };
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < left.size(); ++i) area += from_origin(i).cross(from_origin(i + 1));
  const Vec3 normal = area.norm() > 0.0 ? Vec3(area.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i].place = {from_origin(i).dot(x), from_origin(i).dot(y)};
  }
  return left;
}

bool lies_in(const Eigen::Vector2d& p, const Corner& a, const Corner& b, const Corner& c) {
  return cross(b.place - a.place, p - a.place) >= 0.0 &&
         cross(c.place - b.place, p - b.place) >= 0.0 &&
         cross(a.place - c.place, p - c.place) >= 0.0;
}

/// Whether the corner sticks out and no other corner lies in its triangle.
bool is_ear(const std::vector<Corner>& left, std::size_t i) {
  const std::size_t count = left.size();
  const Corner &a = left[(i + count - 1) % count], &b = left[i], &c = left[(i + 1) % count];
  if (cross(b.place - a.place, c.place - b.place) <= 0.0) return false;
  for (const Corner& other : left) {
    const bool is_corner =
        other.vertex == a.vertex || other.vertex == b.vertex || other.vertex == c.vertex;
    if (!is_corner && lies_in(other.place, a, b, c)) return false;
  }
  return true;
}

}  // namespace

void triangulate_polygon(std::span<const int> corners, const Vec3Array& vertices,
                         std::vector<Triangle>& triangles) {
  std::vector<Corner> left = flatten(corners, vertices);
  const auto cut = [&](std::size_t i) {
    const std::size_t count = left.size();
    triangles.push_back(
        {left[(i + count - 1) % count].vertex, left[i].vertex, left[(i + 1) % count].vertex});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  };
  const std::size_t searched = left.size() > kMostCorners ? 0 : left.size();
  while (left.size() > 3) {
    std::size_t ear = 1;  // where there is none: the fan of the first corner
    for (std::size_t i = 0; i < std::min(searched, left.size()); ++i) {
      if (!is_ear(left, (i + 1) % left.size())) continue;
      ear = (i + 1) % left.size();
      break;
    }
    cut(ear);
  }
  if (left.size() == 3) triangles.push_back({left[0].vertex, left[1].vertex, left[2].vertex});
}

}  // namespace palpate::authoring
