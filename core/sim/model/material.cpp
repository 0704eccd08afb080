// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/material.h"

#include <cmath>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {

void validate(const Material& material) {
  const auto require = [](bool holds, const char* field, double found, const char* unit,
                          const char* expected) {
    if (!holds) refuse(write_text("material: ", field), write_text(found, unit), expected);
  };
  const auto positive = [](double number) { return std::isfinite(number) && number > 0.0; };

  require(positive(material.density), "density", material.density, " kg/m³", "a positive number");
  require(positive(material.young_modulus), "young_modulus", material.young_modulus, " Pa",
          "a positive number");
  require(material.poisson_ratio >= 0.0 && material.poisson_ratio <= 0.5, "poisson_ratio",
          material.poisson_ratio, "", "0 to 0.5");
  require(std::isfinite(material.damping_ratio) && material.damping_ratio >= 0.0, "damping_ratio",
          material.damping_ratio, "", "0 or a positive number");
  if (material.wall_thickness) {
    require(positive(*material.wall_thickness), "wall_thickness", *material.wall_thickness, " m",
            "a positive number, or none for a solid");
  }
}

}  // namespace palpate
