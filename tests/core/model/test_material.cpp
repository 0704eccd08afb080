// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <limits>

#include "core/model/refusal.h"
#include "palpate/sim/model/material.h"

using namespace palpate;

namespace {

/// The refusal of a material that is sound but for what `damage` does to it.
template <class Damage>
std::string find_refusal_after(Damage damage) {
  Material material;
  damage(material);
  return find_refusal([&] { validate(material); });
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("the default material and the ends of every range are accepted") {
  CHECK_NOTHROW(validate(Material{}));
  CHECK_NOTHROW(validate(Material{.poisson_ratio = 0.0, .damping_ratio = 0.0}));
  CHECK_NOTHROW(validate(Material{.poisson_ratio = 0.5, .wall_thickness = 2e-3}));
}

TEST_CASE("a material out of range is refused by field, number and range") {
  CHECK(find_refusal_after([](Material& m) { m.density = -1.0; }) ==
        "material: density: got -1 kg/m³, expected a positive number");
  CHECK(find_refusal_after([](Material& m) { m.young_modulus = 0.0; }) ==
        "material: young_modulus: got 0 Pa, expected a positive number");
  CHECK(find_refusal_after([](Material& m) { m.poisson_ratio = 0.51; }) ==
        "material: poisson_ratio: got 0.51, expected 0 to 0.5");
  CHECK(find_refusal_after([](Material& m) { m.poisson_ratio = -0.1; }) ==
        "material: poisson_ratio: got -0.1, expected 0 to 0.5");
  CHECK(find_refusal_after([](Material& m) { m.damping_ratio = -0.1; }) ==
        "material: damping_ratio: got -0.1, expected 0 or a positive number");
  CHECK(find_refusal_after([](Material& m) { m.wall_thickness = 0.0; }) ==
        "material: wall_thickness: got 0 m, expected a positive number, or none for a solid");
}

TEST_CASE("no field of a material may be infinite or not a number") {
  for (const double number : {kNan, kInfinity}) {
    CHECK(find_refusal_after([&](Material& m) { m.density = number; }) != "");
    CHECK(find_refusal_after([&](Material& m) { m.young_modulus = number; }) != "");
    CHECK(find_refusal_after([&](Material& m) { m.poisson_ratio = number; }) != "");
    CHECK(find_refusal_after([&](Material& m) { m.damping_ratio = number; }) != "");
    CHECK(find_refusal_after([&](Material& m) { m.wall_thickness = number; }) != "");
  }
}
