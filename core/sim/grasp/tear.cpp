// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/grasp/private/tear.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/elastic_energy.h"
#include "palpate/sim/model/private/surface_particles.h"

namespace palpate {
namespace {

/// [-] What is stretched less far tears under any press; at ten times its length a run ends.
constexpr double kLeastStretch = 1.01, kMostStretch = 10.0;

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

/// Which row of Angles has these corners.
using RowOfCorners = std::map<std::array<int, 3>, int>;

std::array<int, 3> sorted(std::array<int, 3> corners) {
  std::ranges::sort(corners);
  return corners;
}

TearPart make_link(int link, const std::array<int, 2>& ends) {
  TearPart part{.link = link, .corner_count = 2};
  part.corners[0] = ends[0];
  part.corners[1] = ends[1];
  return part;
}

TearPart make_triangle(int row, const Triangle& corners) {
  TearPart part{.triangles = {row, -1}, .corner_count = 3};
  std::ranges::copy(corners, part.corners.begin());
  return part;
}

/// The faces of a prism are triangles of the molecular model, where they have rows there.
TearPart make_prism(int row, const std::array<int, 6>& corners, const RowOfCorners& rows) {
  TearPart part{.prism = row, .corners = corners, .corner_count = 6};
  std::size_t faces = 0;
  for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
    const auto found = rows.find(sorted({corners[first], corners[first + 1], corners[first + 2]}));
    if (found != rows.end()) part.triangles[faces++] = found->second;
  }
  return part;
}

std::vector<TearPart> list_parts(const TissueModel& tissue, const BondShares& shares) {
  std::vector<TearPart> parts;
  RowOfCorners rows;
  for (std::size_t r = 0; r < tissue.angles.corners.size(); ++r) {
    rows[sorted(tissue.angles.corners[r])] = static_cast<int>(r);
  }
  std::vector<bool> in_prism(tissue.angles.corners.size(), false);
  for (std::size_t p = 0; p < tissue.prisms.corners.size(); ++p) {
    parts.push_back(make_prism(static_cast<int>(p), tissue.prisms.corners[p], rows));
    for (const int row : parts.back().triangles) {
      if (row >= 0) in_prism[at(row)] = true;
    }
  }
  for (std::size_t r = 0; r < tissue.angles.corners.size(); ++r) {
    if (!in_prism[r]) parts.push_back(make_triangle(static_cast<int>(r), tissue.angles.corners[r]));
  }
  // springs of a wall of prisms are the pillars between its faces, across which nothing pulls
  const auto springs = static_cast<int>(tissue.springs.ends.size());
  for (int l = 0; tissue.prisms.corners.empty() && l < springs; ++l) {
    parts.push_back(make_link(l, tissue.springs.ends[at(l)]));
  }
  for (std::size_t l = 0; l < tissue.bonds.ends.size(); ++l) {
    if (shares.left[l])
      parts.push_back(make_link(springs + static_cast<int>(l), tissue.bonds.ends[l]));
  }
  return parts;
}

struct LinkRow {
  const Links& table;
  std::size_t row;
};

LinkRow find_link(const TissueModel& tissue, int link) noexcept {
  const std::size_t springs = tissue.springs.ends.size();
  if (at(link) < springs) return {tissue.springs, at(link)};
  return {tissue.bonds, at(link) - springs};
}

/// A guard that knows of no links, as one that was set from outside may, says of them what it says.
void mark_torn(std::size_t link, Guard& guard) noexcept {
  if (link < guard.torn_links.size()) guard.torn_links[link] = 1;
}

template <class Row>
void scale(const std::array<Row, 3>& from, double by, std::array<Row, 3>& to) noexcept {
  for (std::size_t c = 0; c < 3; ++c) to[c] = by * from[c];
}

}  // namespace

Tear::Tear(const TissueModel& tissue, double stretch) {
  limit_ = stretch;
  if (!may_tear()) return;
  const BondShares shares = share_bonds(tissue);
  parts_ = list_parts(tissue, shares);
  side_stiffness_ = shares.stiffness;
  side_bond_ = shares.bond;
  sides_left_ = shares.side_count;
  const std::size_t n = tissue.mass.size();
  first_around_.assign(n + 1, 0);
  for (const TearPart& part : parts_) {
    for (int c = 0; c < part.corner_count; ++c) ++first_around_[at(part.corners[at(c)]) + 1];
  }
  for (std::size_t i = 0; i < n; ++i) first_around_[i + 1] += first_around_[i];
  around_.resize(at(first_around_[n]));
  std::vector<int> next(first_around_.begin(), first_around_.end() - 1);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    for (int c = 0; c < parts_[p].corner_count; ++c) {
      around_[at(next[at(parts_[p].corners[at(c)])]++)] = static_cast<int>(p);
    }
  }
  held_.assign(n, 0);
  for (const int i : tissue.fixed) held_[at(i)] = 1;
  is_torn_.assign(parts_.size(), 0);
  stretched_.assign(parts_.size(), 0.0);
  seen_at_.assign(parts_.size(), -1);
  torn_triangles_.assign(tissue.angles.corners.size(), 0);
  pulled_.assign(n, 0);
  scratch_.assign(n, Vec3::Zero());
  reserve();
}

/// Room for all there is to tear: the haptic thread never allocates.
void Tear::reserve() {
  const std::size_t triangles = torn_triangles_.size(), parts = parts_.size();
  watched_.reserve(parts);
  torn_.reserve(parts);
  damage_.reserve(parts);
  rows_.reserve(parts);
  forces_.reserve(pulled_.size());
  const std::size_t links = parts + 3 * triangles;
  links_.ends.reserve(links);
  for (auto* column : {&links_.rest_length, &links_.stiffness, &links_.damping}) {
    column->reserve(links);
  }
  angles_.corners.reserve(triangles);
  for (auto* column : {&angles_.rest_cosine, &angles_.rest_length, &angles_.bend_stiffness,
                       &angles_.stretch_coupling}) {
    column->reserve(triangles);
  }
  prisms_.corners.reserve(parts);
  for (auto* column :
       {&prisms_.rest_difference, &prisms_.shear_stiffness, &prisms_.shear_damping}) {
    column->reserve(parts);
  }
}

void Tear::write_damage(std::span<float> damage) const noexcept {
  std::ranges::fill(damage, 0.0F);
  for (std::size_t which = 0; which < torn_.size(); ++which) {
    const TearPart& torn = torn_part(which);
    for (int c = 0; c < torn.corner_count; ++c) {
      float& worst = damage[at(torn.corners[at(c)])];
      worst = std::max(worst, static_cast<float>(damage_[which]));
    }
  }
}

void Tear::begin_watch(long tick) noexcept {
  // a tick that is begun again has watched nothing yet
  for (const int part : watched_) seen_at_[at(part)] = std::min(seen_at_[at(part)], tick - 1);
  tick_ = tick;
  watched_.clear();
  for (const int part : torn_) {
    const TearPart& torn = parts_[at(part)];
    for (int c = 0; c < torn.corner_count; ++c) watch(torn.corners[at(c)]);
  }
}

void Tear::watch(int particle) noexcept {
  const int end = first_around_[at(particle) + 1];
  for (int k = first_around_[at(particle)]; k < end; ++k) {
    const int part = around_[at(k)];
    long& seen = seen_at_[at(part)];
    if (seen == tick_) continue;
    if (seen != tick_ - 1) stretched_[at(part)] = 0.0;
    seen = tick_;
    watched_.push_back(part);
  }
}

std::span<const ParticleForce> Tear::cancel(const TissueModel& tissue,
                                            std::span<const Vec3> x) noexcept {
  // without damping: any velocities will do
  accumulate_link_forces(links_, tissue.damping_law, x, x, scratch_);
  if (tissue.angle_law == AngleLaw::gradient) {
    accumulate_angle_forces(angles_, x, scratch_);
  } else {
    accumulate_eq10_forces(angles_, x, scratch_);
  }
  accumulate_prism_forces(prisms_, x, x, scratch_);
  for (ParticleForce& each : forces_) each.force = -scratch_[at(each.particle)];
  for (const int part : torn_) {
    const TearPart& torn = parts_[at(part)];
    for (int c = 0; c < torn.corner_count; ++c) scratch_[at(torn.corners[at(c)])].setZero();
  }
  return forces_;
}

double Tear::compute_energy(std::span<const Vec3> x) const noexcept {
  const auto now = [x](int i) -> const Vec3& { return x[at(i)]; };
  return compute_link_energy(links_, now) + compute_angle_energy(angles_, now) +
         compute_prism_energy(prisms_, now);
}

/// [-] The longest side over its length at rest.
double Tear::measure(const TissueModel& tissue, const TearPart& part,
                     std::span<const Vec3> x) const noexcept {
  if (part.link >= 0) {
    const auto [table, row] = find_link(tissue, part.link);
    return measure_distance(x, part.corners[0], part.corners[1]) / table.rest_length[row];
  }
  double longest = 0.0;
  for (const int row : part.triangles) {
    if (row < 0) continue;
    const Triangle& corners = tissue.angles.corners[at(row)];
    for (std::size_t c = 0; c < 3; ++c) {
      const double length = measure_distance(x, corners[(c + 1) % 3], corners[(c + 2) % 3]);
      longest = std::max(longest, length / tissue.angles.rest_length[at(row)][c]);
    }
  }
  return longest;
}

void Tear::add_triangle(const TissueModel& tissue, int row, Guard& guard) noexcept {
  const std::size_t springs = tissue.springs.ends.size();
  const Triangle& corners = tissue.angles.corners[at(row)];
  torn_triangles_[at(row)] = 1;
  angles_.corners.push_back(corners);
  angles_.rest_cosine.push_back(tissue.angles.rest_cosine[at(row)]);
  angles_.rest_length.push_back(tissue.angles.rest_length[at(row)]);
  angles_.bend_stiffness.push_back({});
  angles_.stretch_coupling.push_back({});
  for (std::size_t c = 0; c < 3; ++c) {
    links_.ends.push_back({corners[(c + 1) % 3], corners[(c + 2) % 3]});
    links_.rest_length.push_back(tissue.angles.rest_length[at(row)][c]);
    links_.stiffness.push_back(0.0);
    links_.damping.push_back(0.0);
    const int bond = side_bond_[at(row)][c];
    if (bond >= 0 && --sides_left_[at(bond)] == 0) mark_torn(springs + at(bond), guard);
  }
}

void Tear::tear(const TissueModel& tissue, int which, Guard& guard) noexcept {
  const TearPart& part = parts_[at(which)];
  is_torn_[at(which)] = 1;
  torn_.push_back(which);
  damage_.push_back(0.0);
  rows_.push_back({static_cast<int>(links_.ends.size()), static_cast<int>(angles_.corners.size()),
                   static_cast<int>(prisms_.corners.size())});
  if (part.link >= 0) {
    const auto [table, row] = find_link(tissue, part.link);
    links_.ends.push_back(table.ends[row]);
    links_.rest_length.push_back(table.rest_length[row]);
    links_.stiffness.push_back(0.0);
    links_.damping.push_back(0.0);
    mark_torn(at(part.link), guard);
  }
  for (const int row : part.triangles) {
    if (row >= 0) add_triangle(tissue, row, guard);
  }
  if (part.prism >= 0) {
    prisms_.corners.push_back(tissue.prisms.corners[at(part.prism)]);
    prisms_.rest_difference.push_back(tissue.prisms.rest_difference[at(part.prism)]);
    prisms_.shear_stiffness.push_back({});
    prisms_.shear_damping.push_back({});
  }
  for (int c = 0; c < part.corner_count; ++c) {
    const int particle = part.corners[at(c)];
    if (held_[at(particle)] != 0 || std::exchange(pulled_[at(particle)], 1) != 0) continue;
    forces_.push_back({particle, Vec3::Zero()});
  }
}

/// The stiffness of what has torn, times its damage. Its damping stays.
void Tear::fade(const TissueModel& tissue, std::size_t which) noexcept {
  const TearPart& part = torn_part(which);
  const double damage = damage_[which];
  const Rows& first = rows_[which];
  if (part.link >= 0) {
    const auto [table, row] = find_link(tissue, part.link);
    links_.stiffness[at(first.link)] = damage * table.stiffness[row];
  }
  std::size_t triangle = at(first.triangle), side = at(first.link);
  for (const int row : part.triangles) {
    if (row < 0) continue;
    scale(tissue.angles.bend_stiffness[at(row)], damage, angles_.bend_stiffness[triangle]);
    scale(tissue.angles.stretch_coupling[at(row)], damage, angles_.stretch_coupling[triangle]);
    ++triangle;
    for (std::size_t c = 0; c < 3; ++c, ++side) {
      links_.stiffness[side] = damage * side_stiffness_[at(row)][c];
    }
  }
  if (part.prism < 0) return;
  const std::size_t prism = at(first.prism);
  scale(tissue.prisms.shear_stiffness[at(part.prism)], damage, prisms_.shear_stiffness[prism]);
}

void Tear::grow(const TissueModel& tissue, std::span<const Vec3> x, double dt,
                Guard& guard) noexcept {
  for (const int p : watched_) {
    if (is_torn_[at(p)] != 0) continue;
    double& stretched = stretched_[at(p)];
    stretched = measure(tissue, parts_[at(p)], x) > limit_ ? stretched + dt : 0.0;
    // a whole number of ticks, whatever their rounded sum
    if (stretched >= kTearTime - 0.5 * dt) tear(tissue, p, guard);
  }
  for (std::size_t which = 0; which < torn_.size(); ++which) {
    if (damage_[which] == 1.0) continue;
    damage_[which] = std::min(1.0, damage_[which] + dt / kTearFade);
    fade(tissue, which);
  }
}

void check_tear(const TissueModel& tissue, double stretch, const std::string& field) {
  if (stretch == 0.0) return;
  if (!(stretch >= kLeastStretch && stretch <= kMostStretch)) {
    refuse(field, write_text(stretch),
           "0 for tissue that does not tear, or " + write_text(kLeastStretch) + " to " +
               write_text(kMostStretch) + " times the length at rest");
  }
  if (tissue.springs.ends.empty() && tissue.bonds.ends.empty()) {
    refuse(field, write_text(stretch) + " of tetrahedra at finite or linear strain",
           "0: only springs, bonds and the triangles that they hold tear");
  }
  if (tissue.maxwell.ratio > 0.0) {
    refuse(field, write_text(stretch) + " of a tissue that relaxes",
           "0: what has torn would go on to relax; or a maxwell ratio of 0");
  }
}

}  // namespace palpate
