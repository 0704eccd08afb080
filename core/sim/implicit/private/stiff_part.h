// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <span>
#include <vector>

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/model/private/cut_out.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Steps in which implicit Euler moves the few particles that an explicit step is too long for, and
/// symplectic Euler all others [motion: ladder]. Allocates.
class StiffPart {
 public:
  /// Particles that it may have; a tissue that needs more has none.
  static constexpr std::size_t kMost = 256;

  /// Of steps of dt [s] from positions x [m]: the fewest without which the others, whose largest
  /// eigenvalue of dt² M⁻¹K + 2 dt M⁻¹C is then below that of a stable step, are. `contact` [1/s²]
  /// is what contacts add to a particle's w², one for each or none at all.
  StiffPart(const TissueModel& model, std::span<const Vec3> x, double dt,
            std::span<const double> contact);

  /// Whether steps of that length are stable: no more than kMost are needed.
  bool holds() const noexcept { return holds_; }
  /// In ascending order.
  std::span<const int> particles() const noexcept { return particles_; }

  /// Advances `state` by the dt that it was chosen for; false where no solution was found, with the
  /// state undefined. The model must be that of the constructor, of laws without a memory.
  bool step(const TissueModel& model, const Load& load, State& state);

 private:
  Eigen::SparseMatrix<double> compute_contact(const TissueModel& model, const Load& load);
  bool solve(const TissueModel& model, const Load& load, State& state);

  double dt_;
  bool holds_ = false;
  std::vector<int> particles_;
  std::vector<char> is_inside_;  // per particle of the model
  std::vector<double> contact_;  // [1/s²] per particle of it, or empty
  CutOut cut_;                   // of those inside
  std::vector<int> number_;      // of each of those, in the cut-out
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace palpate
