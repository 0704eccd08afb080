// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/task/private/measure.h"
#include "palpate/sim/task/private/objects.h"

namespace palpate {
namespace {

/// Two sides of a triangle by their squares and their product [m²].
struct Metric {
  double first, both, second;
};

Metric measure_sides(const Triangle& t, std::span<const Vec3> x) noexcept {
  const Vec3& corner = x[static_cast<std::size_t>(t[0])];
  const Vec3 a = x[static_cast<std::size_t>(t[1])] - corner;
  const Vec3 b = x[static_cast<std::size_t>(t[2])] - corner;
  return {a.squaredNorm(), a.dot(b), b.squaredNorm()};
}

/// Of a region any corner, of a ball or a path the middle.
bool lies_at(const TaskPlace& place, const TaskSurface& surface, const Triangle& t) noexcept {
  if (place.kind == PlaceKind::region) {
    return std::ranges::any_of(
        t, [&](int v) noexcept { return place.members[static_cast<std::size_t>(v)] != 0; });
  }
  Vec3 middle = Vec3::Zero();
  for (const int v : t) middle += surface.vertices[static_cast<std::size_t>(v)] / 3.0;
  const double reach = place.kind == PlaceKind::path ? place.radius : 0.0;
  return find_distance(place, middle) <= reach;
}

/// What one body has of the largest strain at a place.
class Largest {
 public:
  Largest(const TaskSurface& surface, std::span<const Vec3> now, const TaskPlace* place) noexcept
      : surface_(surface), now_(now), place_(place) {}

  void take(int triangle) noexcept {
    const Triangle& t = surface_.triangles[static_cast<std::size_t>(triangle)];
    if (place_ && !lies_at(*place_, surface_, t)) return;
    strain_ = std::max(strain_, find_strain(t, surface_.vertices, now_));
  }
  double strain() const noexcept { return strain_; }

 private:
  const TaskSurface& surface_;
  std::span<const Vec3> now_;
  const TaskPlace* place_;
  double strain_ = 0.0;
};

/// [m] What is pushed this near to an object is pushed by it, or beside it.
constexpr double kBeside = 2e-3;

/// Of all that is pushed next to an object, whatever pushes: a stone that is pulled through a neck
/// stretches it, though no tool touches that.
double find_strain_at_object(const Task& task, const World& world, int rigid) noexcept {
  const TaskObject& object = find_rigid(task, rigid);
  const auto is_near = [&](const Vec3& point) noexcept {
    for (std::size_t s = 0; s < object.radii.size(); ++s) {
      const Vec3 centre = find_now(object, world, object.sphere_centres[s]);
      if ((centre - point).norm() <= object.radii[s] + kBeside) return true;
    }
    return false;
  };
  double strain = 0.0;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const std::span<const Vec3> x = surface_position(world.bodies[b]);
    const TaskSurface& surface = task.surfaces[b];
    for (const Push& push : world.bodies[b].load.pushes()) {
      const Triangle& t = surface.triangles[static_cast<std::size_t>(push.triangle)];
      if (!is_near(compute_point(t, push.weights, x))) continue;
      strain = std::max(strain, find_strain(t, surface.vertices, x));
    }
  }
  return strain;
}

}  // namespace

double find_strain(const Triangle& t, std::span<const Vec3> at_rest,
                   std::span<const Vec3> now) noexcept {
  const Metric rest = measure_sides(t, at_rest), m = measure_sides(t, now);
  const double area = rest.first * rest.second - rest.both * rest.both;
  if (!(area > 0.0)) return 0.0;
  // the squares of the principal stretches are the eigenvalues of rest⁻¹ m
  const double half_trace =
      (rest.second * m.first - 2.0 * rest.both * m.both + rest.first * m.second) / (2.0 * area);
  const double determinant = (m.first * m.second - m.both * m.both) / area;
  const double root = std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
  return std::max(0.0, std::sqrt(std::max(0.0, half_trace + root)) - 1.0);
}

double find_strain(const Task& task, const World& world, std::size_t instrument,
                   const TaskPlace* place) noexcept {
  if (place && place->kind == PlaceKind::object) {
    return find_strain_at_object(task, world, place->body);
  }
  const ToolState& tool = world.instruments[instrument].tool;
  double strain = 0.0;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    if (place && place->body != body) continue;
    Largest largest(task.surfaces[b], surface_position(world.bodies[b]), place);
    for (const Push& push : list_pushes(world, instrument, b).contacts) largest.take(push.triangle);
    for (const ToolState::Hold& hold : list_holds(tool)) {
      if (hold.body == body) largest.take(hold.triangle);
    }
    for (const ToolState::Anchor& anchor : list_anchors(tool)) {
      if (anchor.body == body) largest.take(anchor.triangle);
    }
    strain = std::max(strain, largest.strain());
  }
  return strain;
}

}  // namespace palpate
