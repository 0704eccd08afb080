// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace palpate {

/// What an organ is made of, as a designer states it.
struct Material {
  double density = 1060.0;      ///< [kg/m³]
  double young_modulus = 5e3;   ///< [Pa]
  double poisson_ratio = 0.45;  ///< [-]
  double damping_ratio = 0.2;   ///< [-] of a single link between its two end masses; 1 is critical
  std::optional<double> wall_thickness = {};  ///< [m] of a hollow organ or sheet, none for a solid
};

/// Throws std::invalid_argument naming the field, what it got and the admissible range.
void validate(const Material& material);

}  // namespace palpate
