// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <span>

#include "palpate/sim/base/types.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/state.h"

namespace palpate {

// The packed form of a tissue: the same laws as forces.h in float and in vector code, for the
// haptic tick. Particles are renumbered so that neighbours in the body are neighbours in memory;
// their new numbers are called rows. `width` rows, the lanes of one vector, are a slice.

namespace packed_kernels {
struct Kernels;
}

/// Numbers in blocks, one block per slot of links or pack of triangles. Where all numbers are the
/// same there is one block for all.
struct PackedColumn {
  CacheAligned<float> values;
  std::size_t stride = 0;  ///< floats from one block to the next, 0 for a single block

  const float* block(std::size_t index) const noexcept { return values.data() + index * stride; }
};

/// What pulls the particles of each slice towards their neighbours. A slot is one link of every
/// particle of a slice; each link is found at both of its ends. Slots that a particle does not
/// need lead back to itself, where no force comes from.
struct PackedLinks {
  std::vector<int> first_slot;  ///< of each slice, and the end
  std::vector<int> plain_end;   ///< of each slice: before it every lane has a link with a length
  CacheAligned<int> neighbour;  ///< row, `width` per slot
  PackedColumn stiffness;       ///< [N/m]
  PackedColumn rest_tension;    ///< [N] k L: the tension is k l less this
  PackedColumn damping;         ///< [N·s/m]; no values where nothing is damped
  float least_square = 0.0f;    ///< [m²] below, a link has lost its direction and fades
};

/// Triangles with the bonds, angles and stretch-bend terms in them, `width` of them in a pack.
/// Those of a pack share no corner, where that can be had near by. Columns hold three vectors per
/// block: as in Angles, column c belongs to corner c or to the side opposite it. Lanes without a
/// triangle have three times the same corner.
struct PackedTriangles {
  int pack_count = 0;
  CacheAligned<int> corner;       ///< row, 3 x `width` per pack
  PackedColumn rest_length;       ///< [m]
  PackedColumn rest_cosine;       ///< [-]
  PackedColumn bond_stiffness;    ///< [N/m] this triangle's share of the bond along the side
  PackedColumn bond_damping;      ///< [N·s/m] likewise; no values where nothing is damped
  PackedColumn bend_stiffness;    ///< [J], [N] under AngleLaw::eq10
  PackedColumn stretch_coupling;  ///< [N]
};

/// Tetrahedra, `width` of them in a pack. Lanes without one have four times the same corner. Bulks
/// [Pa] are divided by 6, for six times a volume and its slopes is what there is.
struct PackedVolumes {
  int pack_count = 0;
  CacheAligned<int> corner;                 ///< row, 4 x `width` per pack
  CacheAligned<float> inverse_rest;         ///< [1/m³] of six volumes at rest, per lane
  CacheAligned<float> stiffness;            ///< [Pa] of each by itself; empty where it has none
  CacheAligned<float> inverse_rest_around;  ///< [1/m³] of six volumes around each row; may be empty
  CacheAligned<float> stiffness_around;     ///< [Pa] of their mean, a quarter; empty likewise
};

/// Numbers of a tetrahedron in PackedState::faces.
inline constexpr std::size_t kFaceColumns = 10;

/// Prisms of a wall, `width` of them in a pack. Columns hold three vectors per pack, one for each
/// side, as in Prisms. Lanes without one have six times the same corner.
struct PackedPrisms {
  int pack_count = 0;
  CacheAligned<int> corner;             ///< row, 6 x `width` per pack
  CacheAligned<float> rest_difference;  ///< [m]
  CacheAligned<float> stiffness;        ///< [N/m] of the shear
  CacheAligned<float> damping;          ///< [N·s/m] likewise; empty where nothing is damped
  float least_square = 0.0f;            ///< [m²] below, a diagonal loses its direction
};

/// A tissue as the vector kernels read it; made once by pack().
struct PackedModel {
  const packed_kernels::Kernels* kernels = nullptr;  ///< those of one vector target
  int width = 0;                                     ///< lanes
  int slice_count = 0;
  std::vector<int> row;        ///< of each particle
  std::vector<int> particle;   ///< of each row; -1 where a row stands for none
  Vec3 origin = Vec3::Zero();  ///< [m] of the coordinates below: the middle of the organ at rest

  CacheAligned<float> rest;          ///< [m] per slice: `width` x, as many y, as many z
  CacheAligned<float> inverse_mass;  ///< [1/kg] per row; 0 for what is held
  CacheAligned<float> mass;          ///< [kg] per row; 0 for what is held
  CacheAligned<float> home;          ///< [N/m] per row
  CacheAligned<int> self;            ///< each row's own number
  PackedLinks links;
  PackedTriangles triangles;  ///< with angles or bonds; may be empty
  PackedTriangles skin;       ///< under pressure; empty without one
  PackedPrisms prisms;        ///< of walls; may be empty
  PackedVolumes volumes;      ///< of solids; may be empty
  TissueModel numbers;        ///< the laws that are numbers alone; no rows
  Skin riding;                ///< TissueModel::skin, its corners as rows
  float pressure = 0.0f;      ///< [Pa]
  float drag = 0.0f;          ///< [1/s]
  DampingLaw damping_law = DampingLaw::axis;
  AngleLaw angle_law = AngleLaw::gradient;
  std::vector<Triangle> surface;  ///< TissueModel::triangles: of rows, or of vertices of the skin
};
static_assert(alignof(PackedModel) == 8);

/// What a step finds on its way for a check of the tissue: energies [J] where the step began, with
/// the velocities half way through its kick, how far links and sides are from their rest, and what
/// has moved since the last check.
struct PackedMeasure {
  double kinetic = 0.0, elastic = 0.0;
  Stretch stretch;
  double largest_move = 0.0;  ///< [m] of a particle; infinite where one is nowhere
  double gravity_work = 0.0;  ///< [J]
};

/// Numbers of slices or packs, ascending. There is always room for all of them.
struct PackedList {
  PackedList() = default;
  explicit PackedList(int size) : numbers(static_cast<std::size_t>(size)), count(size) {
    std::iota(numbers.begin(), numbers.end(), 0);
  }
  std::vector<int> numbers;
  int count = 0;
  std::span<const int> span() const noexcept {
    return std::span(numbers).first(static_cast<std::size_t>(count));
  }
};

/// Everything about a packed tissue that changes from step to step. A particle is where it rests
/// plus its displacement, which as a small number is exact far beyond the position.
struct PackedState {
  PackedState() = default;
  /// A tissue in the given state; what is held has no velocity. Allocates all a step needs.
  PackedState(const PackedModel& model, const TissueModel& tissue, const State& state);

  double time = 0.0;                 ///< [s]
  CacheAligned<float> displacement;  ///< [m] from rest, laid out as PackedModel::rest
  CacheAligned<float> velocity;      ///< [m/s] likewise
  int current = 0;                   ///< which of the two tables of rows below holds
  std::array<CacheAligned<float>, 2> position_rows;  ///< [m] x, y, z, 0 of each row
  std::array<CacheAligned<float>, 2> velocity_rows;  ///< [m/s] likewise; empty without damping
  CacheAligned<float> force_rows;         ///< [N] likewise; 0 between steps where it moves
  bool checked = true;                    ///< no step since the last check
  CacheAligned<float> last_displacement;  ///< [m] then, of what has moved since
  CacheAligned<float> last_rows;          ///< [m] position rows then; empty without pressure
  std::vector<unsigned char> pushed;      ///< per slice: force_rows holds something

  // what moves: all of it, but where an ActiveSet chooses. Rows of slices that do not may hold
  // forces that nobody asks for
  PackedList slices;
  PackedList packs;  ///< of triangles with a corner in one of them
  PackedList skin;   ///< likewise, under pressure
  CacheAligned<float>
      slice_energy;                 ///< [J] elastic, when last measured; empty without an ActiveSet
  CacheAligned<float> pack_energy;  ///< [J] likewise
  double asleep_energy = 0.0;       ///< [J] of what is not in the lists

  // work space of the law of volumes, empty without means around particles
  CacheAligned<float> faces;  ///< per pack: three faces [m²] and six volumes [m³] of each lane
  CacheAligned<float> volume_sums;  ///< [m³] of six volumes around each row; 0 between steps

  double last_dt = 0.0;                       ///< [s] of the step before
  std::vector<CacheAligned<float>> internal;  ///< of each law of the kernels, variables of its own
};

}  // namespace palpate
