// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/tissue_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <numeric>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/definiteness.h"
#include "palpate/sim/model/private/check_law.h"
#include "palpate/sim/model/private/check_solid.h"

namespace palpate {
namespace {

std::string name_row(const char* table, std::size_t row) {
  return write_text("model: ", table, ": row ", row);
}

bool is_positive(double number) { return std::isfinite(number) && number > 0.0; }
bool is_not_negative(double number) { return std::isfinite(number) && number >= 0.0; }

void check_particles(const TissueModel& model) {
  const std::size_t n = model.rest_position.size();
  if (n == 0) refuse("model: rest_position", "no particles", "at least one");
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& x = model.rest_position[i];
    if (x.allFinite()) continue;
    refuse(name_row("rest_position", i), write_text("(", x.x(), ", ", x.y(), ", ", x.z(), ") m"),
           "finite numbers");
  }
  laws::check_size("model: mass", model.mass.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    if (is_positive(model.mass[i])) continue;
    refuse(name_row("mass", i), write_text(model.mass[i], " kg"), "a positive number");
  }
  if (!model.home.empty()) laws::check_size("model: home", model.home.size(), n);
  for (std::size_t i = 0; i < model.home.size(); ++i) {
    if (is_not_negative(model.home[i])) continue;
    refuse(name_row("home", i), write_text(model.home[i], " N/m"), "0 or a positive number");
  }
}

void check_fixed(const std::vector<int>& fixed, int n) {
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] < 0 || fixed[i] >= n) {
      refuse(name_row("fixed", i), write_text("particle ", fixed[i]), write_text("0 to ", n - 1));
    }
    if (i > 0 && fixed[i] <= fixed[i - 1]) {
      refuse(name_row("fixed", i), write_text(fixed[i], " after ", fixed[i - 1]),
             "ascending particles");
    }
  }
}

/// Two numbers that are not the same, with as many digits as it takes to see that.
std::array<std::string, 2> write_apart(double one, double other) {
  std::array<std::string, 2> texts;
  for (int digits = 6; digits <= 17 && texts[0] == texts[1]; ++digits) {
    texts = {write_text(std::setprecision(digits), one),
             write_text(std::setprecision(digits), other)};
  }
  return texts;
}

/// The cosines are those that the rest lengths give.
void check_shapes(const Angles& angles) {
  // the cosine of the law of cosines, less what rounding may have done to it
  constexpr double kCosineError = 1e-6;
  for (std::size_t a = 0; a < angles.corners.size(); ++a) {
    const auto& length = angles.rest_length[a];
    for (int c = 0; c < 3; ++c) {
      const double one = length[(c + 1) % 3], two = length[(c + 2) % 3];
      const double found = angles.rest_cosine[a][c];
      const double expected = (one * one + two * two - length[c] * length[c]) / (2.0 * one * two);
      if (std::abs(found - expected) <= kCosineError) continue;
      const auto [got, wanted] = write_apart(found, expected);
      refuse(laws::name_row("angles", "rest_cosine", a), got,
             wanted + ", which the rest lengths give");
    }
  }
}

void check_triangles(const std::vector<Triangle>& triangles, int n) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [i, j, k] = triangles[t];
    const bool in_range = std::min({i, j, k}) >= 0 && std::max({i, j, k}) < n;
    if (in_range && i != j && j != k && k != i) continue;
    refuse(name_row("triangles", t), write_text(i, ", ", j, ", ", k),
           write_text("three different ones, 0 to ", n - 1));
  }
}

/// A bond of the triangles is the sum of their shares, or the triangle test below would judge
/// other bonds than those that pull. A bond outside of all triangles must hold by itself.
void check_bond_shares(const Links& bonds, const Angles& angles) {
  constexpr double kSumError = 1e-9;
  struct Share {
    double sum = 0.0, size = 0.0;
    std::size_t row = 0;
    bool bond_found = false;
  };
  std::map<std::array<int, 2>, Share> shares;
  for (std::size_t a = 0; a < angles.corners.size(); ++a) {
    for (int c = 0; c < 3; ++c) {
      const int i = angles.corners[a][(c + 1) % 3], j = angles.corners[a][(c + 2) % 3];
      Share& share = shares[{std::min(i, j), std::max(i, j)}];
      share.sum += angles.bond_share[a][c];
      share.size += std::abs(angles.bond_share[a][c]);
      share.row = a;
    }
  }
  for (std::size_t l = 0; l < bonds.ends.size(); ++l) {
    const auto at = shares.find(bonds.ends[l]);
    const double k = bonds.stiffness[l];
    if (at == shares.end()) {
      if (k >= 0.0) continue;
      refuse(laws::name_row("bonds", "stiffness", l),
             write_text(k, " N/m outside of every triangle"), "0 or a positive number");
    }
    Share& share = at->second;
    if (share.bond_found || std::abs(k - share.sum) > kSumError * share.size) {
      const auto [got, wanted] = write_apart(k, share.sum);
      refuse(laws::name_row("bonds", "stiffness", l),
             share.bond_found ? "a second bond along the same side" : got + " N/m",
             wanted + " N/m, the sum of its triangles' shares, once");
    }
    share.bond_found = true;
  }
  for (const auto& [ends, share] : shares) {
    if (share.bond_found || share.size == 0.0) continue;
    refuse(laws::name_row("angles", "bond_share", share.row),
           write_text("shares of a bond ", ends[0], ", ", ends[1]), "that bond in the table");
  }
}

}  // namespace

double compute_total_mass(const TissueModel& model) {
  return std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
}

std::string describe(const TissueModel& model) {
  std::string text =
      write_text(particle_count(model), " particles, ", model.fixed.size(), " of them held; ");
  laws::for_each_table([&](const auto& table) { text += table.words(model.*table.of); });
  return text + write_text(model.home.empty() ? "no home springs" : "home springs", "; total mass ",
                           1e3 * compute_total_mass(model), " g");
}

void validate(const TissueModel& model) {
  const int n = particle_count(model);
  check_particles(model);
  check_fixed(model.fixed, n);
  laws::for_each_table([&](const auto& table) { laws::check_table(model, table); });
  check_shapes(model.angles);
  check_bond_shares(model.bonds, model.angles);
  check_definiteness(model.angles, model.angle_law);
  check_solid(model);
  check_triangles(model.triangles, surface_count(model));
  if (!std::isfinite(model.pressure)) {
    refuse("model: pressure", write_text(model.pressure, " Pa"), "a finite number");
  }
  if (!is_not_negative(model.drag)) {
    refuse("model: drag", write_text(model.drag, " 1/s"), "0 or a positive number");
  }
}

}  // namespace palpate
