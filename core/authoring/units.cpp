// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/units.h"

#include <cstdio>
#include <stdexcept>
#include <utility>

namespace palpate::authoring {

std::optional<double> find_metres_per_unit(const std::string& unit) {
  const std::pair<const char*, double> table[] = {{"m", 1.0},   {"cm", 1e-2},   {"mm", 1e-3},
                                                  {"um", 1e-6}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& [name, metres] : table) {
    if (unit == name) return metres;
  }
  return std::nullopt;
}

std::optional<Mat3> find_turn_to_z_up(const std::string& axis) {
  // the columns tell where x, y and z of the file go
  const auto turn = [](const Vec3& x, const Vec3& y, const Vec3& z) {
    Mat3 m;
    m << x, y, z;
    return m;
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  if (axis == "z") return Mat3(Mat3::Identity());
  if (axis == "y") return turn(x, z, -y);
  if (axis == "x") return turn(z, y, -x);
  if (axis == "-z") return turn(x, -y, -z);
  if (axis == "-y") return turn(x, -z, y);
  if (axis == "-x") return turn(-z, y, x);
  return std::nullopt;
}

Choice choose_unit(const std::optional<std::string>& asked,
                   const std::optional<std::string>& stated, double diagonal) {
  if (asked) {
    if (!find_metres_per_unit(*asked)) {
      throw std::invalid_argument("unit must be m, cm, mm, um, in or ft, got '" + *asked + "'");
    }
    return {*asked, false, "as asked"};
  }
  if (stated) return {*stated, false, "stated by the file or its format"};

  char size[48];
  std::snprintf(size, sizeof size, "%.4g units from corner to corner", diagonal);
  if (diagonal < 1.0) return {"m", true, std::string(size) + ": below 1, so metres"};
  if (diagonal <= 60.0) return {"cm", true, std::string(size) + ": 1 to 60, so centimetres"};
  return {"mm", true, std::string(size) + ": above 60, so millimetres"};
}

Choice choose_up(const std::optional<std::string>& asked,
                 const std::optional<std::string>& stated) {
  if (asked) {
    if (!find_turn_to_z_up(*asked)) {
      throw std::invalid_argument("up must be x, y, z, -x, -y or -z, got '" + *asked + "'");
    }
    return {*asked, false, "as asked"};
  }
  if (stated) return {*stated, false, "stated by the file or its format"};
  return {"z", true, "the format states none; medical programs have z up"};
}

}  // namespace palpate::authoring
