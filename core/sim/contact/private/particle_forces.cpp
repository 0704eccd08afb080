// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/particle_forces.h"

#include <algorithm>

namespace palpate {
namespace {

/// Of each particle the parts that act on it.
struct PartsOfParticle {
  PartsOfParticle(const ParticleForces& forces, int particles)
      : first(static_cast<std::size_t>(particles) + 1, 0),
        force(forces.particle.size()),
        part(forces.particle.size()) {
    for (const int p : forces.particle) ++first[static_cast<std::size_t>(p) + 1];
    for (std::size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < forces.count(); ++f) {
      for (int k = forces.first[f]; k < forces.first[f + 1]; ++k) {
        const int p = forces.particle[static_cast<std::size_t>(k)];
        const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(p)]++);
        force[at] = static_cast<int>(f);
        part[at] = forces.part[static_cast<std::size_t>(k)];
      }
    }
  }

  std::vector<int> first;
  std::vector<int> force;
  Vec3Array part;
};

/// What force g has of the displacements under a force `a` on a particle, whose unit forces are the
/// three sides from `column` on.
double find_share(const ParticleForces& forces, std::size_t g, const Vec3& a, Eigen::Index column,
                  const Sides& u) {
  double sum = 0.0;
  for (int k = forces.first[g]; k < forces.first[g + 1]; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Eigen::Index row = 3 * Eigen::Index{forces.particle[at]};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      sum += forces.part[at][axis] * u.row(row + axis).segment<3>(column).dot(a);
    }
  }
  return sum;
}

/// Of a particle whose unit forces are the three sides from `column` on.
void accumulate_particle(const ParticleForces& forces, const PartsOfParticle& parts,
                         const ForcePairs& pairs, int particle, Eigen::Index column, const Sides& u,
                         std::vector<double>& compliance) {
  const auto p = static_cast<std::size_t>(particle);
  for (int k = parts.first[p]; k < parts.first[p + 1]; ++k) {
    const auto at = static_cast<std::size_t>(k), f = static_cast<std::size_t>(parts.force[at]);
    for (int pair = pairs.first[f]; pair < pairs.first[f + 1]; ++pair) {
      const auto g = static_cast<std::size_t>(pairs.other[static_cast<std::size_t>(pair)]);
      compliance[static_cast<std::size_t>(pair)] +=
          find_share(forces, g, parts.part[at], column, u);
    }
  }
}

/// The particles on which anything acts.
std::vector<int> list_loaded(const PartsOfParticle& parts) {
  std::vector<int> loaded;
  for (std::size_t p = 0; p + 1 < parts.first.size(); ++p) {
    if (parts.first[p] < parts.first[p + 1]) loaded.push_back(static_cast<int>(p));
  }
  return loaded;
}

}  // namespace

std::vector<double> solve_compliances(const FreeStiffness& stiffness, const Factors& factors,
                                      const ParticleForces& forces, const ForcePairs& pairs) {
  constexpr std::size_t kParticlesAtOnce = kAtOnce / 3;
  const PartsOfParticle parts(forces, stiffness.count);
  const std::vector<int> loaded = list_loaded(parts);
  std::vector<double> compliance(pairs.other.size(), 0.0);
  for (std::size_t begin = 0; begin < loaded.size(); begin += kParticlesAtOnce) {
    const std::size_t end = std::min(begin + kParticlesAtOnce, loaded.size());
    Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = 3 * static_cast<Eigen::Index>(i - begin);
      force.block<3, 3>(3 * Eigen::Index{loaded[i]}, column).setIdentity();
    }
    const Sides u = solve(factors, force);
    for (std::size_t i = begin; i < end; ++i) {
      accumulate_particle(forces, parts, pairs, loaded[i], 3 * static_cast<Eigen::Index>(i - begin),
                          u, compliance);
    }
  }
  return compliance;
}

}  // namespace palpate
