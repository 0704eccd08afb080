// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/load.h"
#include "palpate/sim/response/response.h"

namespace palpate::bench {

/// A linear solid as a first program would move it: its response in double, and in every substep
/// all that moves brought up to date.
class NaiveResponse {
 public:
  explicit NaiveResponse(const Response& response);

  /// The displacements [m] (moved, 3) as they are now.
  void follow(const ResponseState& state);

  /// u += s (G f + sag - u), s the share [-], f the pushes; then the places [m] of what moves.
  void step(const TissueModel& model, const Load& load, double share, std::span<Vec3> x) noexcept;

 private:
  const Response& response_;
  std::vector<double> compliance_;  ///< [m/N] (3 pushed, 3 moved)
  std::vector<double> sag_;
  std::vector<double> displacement_;
  std::vector<double> goal_;   ///< [m] (moved, 3): where the pushes hold it
  std::vector<double> force_;  ///< [N] (pushed, 3)
};

}  // namespace palpate::bench
