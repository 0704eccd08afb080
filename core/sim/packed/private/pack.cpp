// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/model/private/law_tables.h"
#include "palpate/sim/model/private/surface_particles.h"
#include "palpate/sim/packed/private/pack_links.h"
#include "palpate/sim/packed/private/pack_prisms.h"
#include "palpate/sim/packed/private/pack_solid.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/private/packed_kernels.h"
#include "palpate/sim/packed/private/packed_order.h"

namespace palpate {
namespace {

// triangles to choose from for each lane of a pack
constexpr int kLookaheadPerLane = 12;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Numbers the particles and lays out what each of them has.
void pack_particles(const TissueModel& model, PackedOrder order, PackedModel& packed) {
  const int n = particle_count(model), width = packed.width;
  packed.particle = order == PackedOrder::bands ? find_bands(model) : find_patches(model);
  packed.slice_count = (n + width - 1) / width;
  const std::size_t rows = at(packed.slice_count * width);
  packed.row.resize(at(n));
  for (int r = 0; r < n; ++r) packed.row[at(packed.particle[at(r)])] = r;
  packed.particle.resize(rows, -1);
  packed.self.resize(rows);
  std::iota(packed.self.begin(), packed.self.end(), 0);

  Vec3 low = model.rest_position.front(), high = low;
  for (const Vec3& x : model.rest_position) low = low.cwiseMin(x), high = high.cwiseMax(x);
  packed.origin = 0.5 * (low + high);
  packed.rest.assign(3 * rows, 0.0f);
  packed.inverse_mass.assign(rows, 0.0f);
  packed.mass.assign(rows, 0.0f);
  packed.home.assign(rows, 0.0f);
  for (int r = 0; r < n; ++r) {
    const auto i = at(packed.particle[at(r)]);
    const Eigen::Vector3f rest = (model.rest_position[i] - packed.origin).cast<float>();
    for (int k = 0; k < 3; ++k)
      packed.rest[at(3 * (r - r % width) + r % width + k * width)] = rest[k];
    packed.mass[at(r)] = static_cast<float>(model.mass[i]);
    packed.inverse_mass[at(r)] = static_cast<float>(1.0 / model.mass[i]);
    if (!model.home.empty()) packed.home[at(r)] = static_cast<float>(model.home[i]);
  }
  for (const int i : model.fixed) {
    packed.mass[at(packed.row[at(i)])] = packed.inverse_mass[at(packed.row[at(i)])] = 0.0f;
  }
}

/// Packs of triangles by the rows of their corners, and which triangle each lane holds.
std::vector<int> pack_corners(const PackedModel& packed, std::span<const Triangle> triangles,
                              PackedTriangles& packs) {
  const int width = packed.width;
  const std::vector<int> order = find_pack_order<3>(triangles, width, kLookaheadPerLane * width);
  packs.pack_count = static_cast<int>(order.size()) / width;
  packs.corner.assign(3 * order.size(), 0);
  for (int lane = 0; lane < static_cast<int>(order.size()); ++lane) {
    if (order[at(lane)] < 0) continue;
    for (int c = 0; c < 3; ++c) {
      packs.corner[at(3 * (lane - lane % width) + lane % width + c * width)] =
          triangles[at(order[at(lane)])][at(c)];
    }
  }
  return order;
}

/// A table of Angles in the order of the packs. `filler` stands in lanes without a triangle.
template <class Number>
PackedColumn pack_column(const std::vector<int>& order, int width,
                         const std::vector<std::array<Number, 3>>& table, float filler = 0.0f) {
  std::vector<float> values(3 * order.size(), kNoNumber);
  for (int lane = 0; lane < static_cast<int>(order.size()); ++lane) {
    if (order[at(lane)] < 0) continue;
    for (int c = 0; c < 3; ++c) {
      values[at(3 * (lane - lane % width) + lane % width + c * width)] =
          static_cast<float>(table[at(order[at(lane)])][at(c)]);
    }
  }
  return make_column(std::move(values), 3 * at(width), filler);
}

void pack_triangles(const TissueModel& model, const BondShares& shares, PackedModel& packed) {
  const Angles& angles = model.angles;
  if (!angles.corners.empty()) {
    PackedTriangles& packs = packed.triangles;
    const auto order = pack_corners(packed, map_rows(packed, angles.corners), packs);
    const auto column = [&](const auto& table, float filler) {
      return pack_column(order, packed.width, table, filler);
    };
    packs.rest_length = column(angles.rest_length, 1.0f);
    packs.rest_cosine = column(angles.rest_cosine, 0.5f);
    packs.bond_stiffness = column(shares.stiffness, 0.0f);
    packs.bond_damping = column(shares.damping, 0.0f);
    packs.bend_stiffness = column(angles.bend_stiffness, 0.0f);
    packs.stretch_coupling = column(angles.stretch_coupling, 0.0f);
  }
  packed.surface = model.skin.corners.empty() ? map_rows(packed, model.triangles) : model.triangles;
  packed.pressure = static_cast<float>(model.pressure);
  if (model.pressure != 0.0) pack_corners(packed, packed.surface, packed.skin);
}

/// Columns of nothing but zeros need no kernel that reads them.
void drop_zeros(PackedColumn& column) {
  const auto is_zero = [](float value) { return value == 0.0f; };
  if (std::all_of(column.values.begin(), column.values.end(), is_zero)) column = {};
}

const packed_kernels::Kernels& find_kernels(std::string_view target) {
  for (const packed_kernels::Kernels* kernels : packed_kernels::available()) {
    if (target.empty() || target == kernels->target) return *kernels;
  }
  std::string expected = "one of";
  for (const std::string& name : simd_targets()) expected += " " + name;
  refuse("pack: target", target.empty() ? "a Palpate without vector code" : std::string(target),
         simd_targets().empty() ? "one built with PALPATE_SIMD" : expected);
}

}  // namespace

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const packed_kernels::Kernels* kernels : packed_kernels::available()) {
    names.emplace_back(kernels->target);
  }
  return names;
}

PackedModel pack(const TissueModel& model, std::string_view target, PackedOrder order) {
  validate(model);
  if (!model.elastic.corners.empty()) {
    refuse("elastic", write_text(model.elastic.corners.size(), " rows"),
           "none: linear solids have no packed form");
  }
  if (!has_packed_form(model)) {
    refuse("pack: model", "tetrahedra at finite strain",
           "none: corotated and neo-Hookean solids have no packed form");
  }
  PackedModel packed;
  packed.kernels = &find_kernels(target);
  packed.width = packed.kernels->width;
  packed.drag = static_cast<float>(model.drag);
  packed.damping_law = model.damping_law;
  packed.angle_law = model.angle_law;
  laws::for_each_law([&]<class Law>(const Law& law) {
    if constexpr (laws::is_numbers<Law>) packed.numbers.*law.of = model.*law.of;
  });
  pack_particles(model, order, packed);
  const BondShares shares = share_bonds(model);
  const std::vector<bool> all(model.springs.ends.size(), true);
  const ChosenLinks tables[] = {{&model.springs, all}, {&model.bonds, shares.left}};
  pack_links(tables, packed);
  pack_triangles(model, shares, packed);
  pack_prisms(model, packed);
  pack_solid(model, packed);
  drop_zeros(packed.triangles.bond_damping);
  // where triangles or prisms are damped there are velocities, and links are asked for theirs
  if (packed.triangles.bond_damping.values.empty() && packed.prisms.damping.empty()) {
    drop_zeros(packed.links.damping);
  }
  return packed;
}

}  // namespace palpate
