// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/response/private/free_stiffness.h"

namespace palpate {

// What forces on particles do to each other's work: compliances fᵀ K⁻¹ g, each particle solved for
// once, however many forces it has a part in.

/// Forces [N], each the sum of parts on free particles.
struct ParticleForces {
  std::size_t count() const { return first.size() - 1; }
  /// Begins the next one.
  void end() { first.push_back(static_cast<int>(particle.size())); }

  // parts of force f: from first[f] up to first[f + 1]
  std::vector<int> first = {0};
  std::vector<int> particle;  ///< among the free
  Vec3Array part;             ///< [N]
};

/// Of each force the others it is wanted with: from first[f] up to first[f + 1].
struct ForcePairs {
  std::vector<int> first = {0};
  std::vector<int> other;
};

/// [m N] fᵀ K⁻¹ g of each pair, in their order.
std::vector<double> solve_compliances(const FreeStiffness& stiffness, const Factors& factors,
                                      const ParticleForces& forces, const ForcePairs& pairs);

}  // namespace palpate
