// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/check_prisms.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

void check_size(const char* column, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  refuse(write_text("model: prisms.", column), write_text(found, " rows"), write_text(expected));
}

std::string name_row(const char* column, std::size_t row) {
  return write_text("model: prisms.", column, ": row ", row);
}

void check_row(const Prisms& prisms, std::size_t p, int particles) {
  std::array<int, 6> ids = prisms.corners[p];
  std::ranges::sort(ids);
  if (ids.front() < 0 || ids.back() >= particles || std::ranges::adjacent_find(ids) != ids.end()) {
    std::string found;
    for (const int id : prisms.corners[p]) found += write_text(found.empty() ? "" : ", ", id);
    refuse(name_row("corners", p), found,
           write_text("six different particles, 0 to ", particles - 1));
  }
  for (int c = 0; c < 3; ++c) {
    const double difference = prisms.rest_difference[p][c], k = prisms.shear_stiffness[p][c],
                 damping = prisms.shear_damping[p][c];
    if (!std::isfinite(difference)) {
      refuse(name_row("rest_difference", p), write_text(difference, " m"), "a finite number");
    }
    if (!(std::isfinite(k) && k >= 0.0)) {
      refuse(name_row("shear_stiffness", p), write_text(k, " N/m"), "0 or a positive number");
    }
    if (!(std::isfinite(damping) && damping >= 0.0)) {
      refuse(name_row("shear_damping", p), write_text(damping, " N·s/m"), "0 or a positive number");
    }
  }
}

}  // namespace

void check_prisms(const TissueModel& model) {
  const Prisms& prisms = model.prisms;
  const std::size_t count = prisms.corners.size();
  check_size("rest_difference", prisms.rest_difference.size(), count);
  check_size("shear_stiffness", prisms.shear_stiffness.size(), count);
  check_size("shear_damping", prisms.shear_damping.size(), count);
  for (std::size_t p = 0; p < count; ++p) check_row(prisms, p, particle_count(model));
}

}  // namespace palpate
