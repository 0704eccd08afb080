// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/cut_out.h"

#include <algorithm>
#include <array>

#include "palpate/sim/model/private/law_tables.h"

namespace palpate {
namespace {

/// How far from what moves a particle is, in rows of laws that join particles; 0 for beyond.
using Levels = std::vector<unsigned char>;
constexpr unsigned char kMoved = 1, kRing = 2, kOuterRing = 3;

/// visit(row's particles) for every row of every law.
template <class Visit>
void for_each_row(const TissueModel& model, Visit visit) {
  laws::for_each_law([&](const auto& table) {
    using T = typename std::decay_t<decltype(table)>::Rows;
    const T& rows = model.*table.of;
    laws::for_each_column(table,
                          laws::Overloaded{[&]<std::size_t N>(const laws::Corners<T, N>& column) {
                                             for (const auto& row : rows.*column.rows) visit(row);
                                           },
                                           [](const auto&) {}});
  });
}

/// Marks what rows join to particles of a level, as of the next one.
void grow(const TissueModel& model, unsigned char level, Levels& levels) {
  for_each_row(model, [&](const auto& row) {
    const auto marked = [&](int i) {
      const unsigned char at = levels[static_cast<std::size_t>(i)];
      return at > 0 && at <= level;
    };
    if (std::ranges::none_of(row, marked)) return;
    for (const int i : row) {
      unsigned char& at = levels[static_cast<std::size_t>(i)];
      if (at == 0) at = static_cast<unsigned char>(level + 1);
    }
  });
}

/// Two rings around what moves: the mean volume around a particle of the inner one needs all of
/// its tetrahedra.
Levels find_levels(const TissueModel& model, std::span<const Vec3> x, const Vec3& centre, int most,
                   std::span<const int> always) {
  std::vector<bool> free(x.size(), true);
  for (const int i : model.fixed) free[static_cast<std::size_t>(i)] = false;
  std::vector<int> nearest;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (free[i]) nearest.push_back(static_cast<int>(i));
  }
  const auto count = std::min(nearest.size(), static_cast<std::size_t>(std::max(0, most)));
  const auto distance = [&](int i) {
    return (x[static_cast<std::size_t>(i)] - centre).squaredNorm();
  };
  if (count < nearest.size()) {
    std::ranges::nth_element(nearest, nearest.begin() + static_cast<std::ptrdiff_t>(count), {},
                             distance);
  }
  Levels levels(x.size(), 0);
  for (std::size_t k = 0; k < count; ++k) levels[static_cast<std::size_t>(nearest[k])] = kMoved;
  for (const int i : always) {
    if (free[static_cast<std::size_t>(i)]) levels[static_cast<std::size_t>(i)] = kMoved;
  }
  grow(model, kMoved, levels);
  grow(model, kRing, levels);
  return levels;
}

/// The rows of a table whose particles were all cut out, by their new numbers.
template <class SomeTable>
void cut_table(const TissueModel& model, const SomeTable& table, const std::vector<int>& number,
               TissueModel& part) {
  using T = typename SomeTable::Rows;
  const T& rows = model.*table.of;
  T& kept = part.*table.of;
  std::vector<std::size_t> keep;
  laws::for_each_column(
      table, laws::Overloaded{
                 [&]<std::size_t N>(const laws::Corners<T, N>& column) {
                   const auto& all = rows.*column.rows;
                   for (std::size_t row = 0; row < all.size(); ++row) {
                     std::array<int, N> corners = all[row];
                     for (int& i : corners) i = number[static_cast<std::size_t>(i)];
                     if (std::ranges::find(corners, -1) != corners.end()) continue;
                     (kept.*column.rows).push_back(corners);
                     keep.push_back(row);
                   }
                 },
                 [&]<class Row>(const laws::Numbers<T, Row>& column) {
                   for (const std::size_t row : keep) {
                     (kept.*column.rows).push_back((rows.*column.rows)[row]);
                   }
                 },
                 [&](const laws::Scalar<T>& scalar) { kept.*scalar.value = rows.*scalar.value; },
                 [](const auto&) {}});
}

/// What follows from the other columns.
void derive(TissueModel& part) {
  const int count = particle_count(part);
  if (!part.volumes.corners.empty()) {
    Volumes& its = part.volumes;
    its = build_volumes(count, its.corners, its.rest_volume, its.bulk, its.nodal_share);
  }
  if (!part.elastic.corners.empty()) {
    Elastic& its = part.elastic;
    its = build_elastic(count, its.corners, its.lame, its.shear, its.nodal_share, its.damping_time);
  }
  for (Hyperelastic* its : {&part.corotated, &part.neo_hookean}) {
    if (its->corners.empty()) continue;
    *its = build_hyperelastic(count, its->corners, its->lame, its->shear, its->viscosity,
                              its->nodal_share);
  }
}

}  // namespace

std::vector<int> number_particles(const CutOut& cut, std::size_t count) {
  std::vector<int> number(count, -1);
  for (std::size_t i = 0; i < cut.particle.size(); ++i) {
    number[static_cast<std::size_t>(cut.particle[i])] = static_cast<int>(i);
  }
  return number;
}

CutOut cut_out(const TissueModel& model, std::span<const Vec3> x, const Vec3& centre, int most,
               std::span<const int> always) {
  const Levels levels = find_levels(model, x, centre, most, always);
  CutOut cut;
  TissueModel& part = cut.model;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] == 0) continue;
    cut.particle.push_back(static_cast<int>(i));
    cut.x.push_back(x[i]);
    part.rest_position.push_back(model.rest_position[i]);
    part.mass.push_back(model.mass[i]);
    if (!model.home.empty()) part.home.push_back(model.home[i]);
    if (levels[i] != kMoved) part.fixed.push_back(static_cast<int>(cut.particle.size()) - 1);
  }
  const std::vector<int> number = number_particles(cut, levels.size());
  laws::for_each_law([&](const auto& table) { cut_table(model, table, number, part); });
  derive(part);
  part.drag = model.drag;
  part.damping_law = model.damping_law;
  part.angle_law = model.angle_law;
  return cut;
}

}  // namespace palpate
