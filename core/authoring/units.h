// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "palpate/sim/base/types.h"

namespace palpate::authoring {

/// How long one of a unit is [m]: m, cm, mm, um, in, ft. nullopt for another word.
std::optional<double> find_metres_per_unit(const std::string& unit);

/// The right-handed quarter turn that lifts an axis (x, y, z, -x, -y, -z) to +z. nullopt for
/// another word.
std::optional<Mat3> find_turn_to_z_up(const std::string& axis);

/// A word chosen for want of a better one, and why.
struct Choice {
  std::string value;
  bool guessed;
  std::string reason;
};

/// The unit of coordinates that span `diagonal`: what was asked for, else what the file states,
/// else a guess by size: below 1 metres, to 60 centimetres, above millimetres. Organs are 1 cm to
/// 1 m long. Throws std::invalid_argument for a word that is not a unit.
Choice choose_unit(const std::optional<std::string>& asked,
                   const std::optional<std::string>& stated, double diagonal);

/// The up axis: what was asked for, else what the file states, else z, the rule of medical
/// programs. Throws std::invalid_argument for a word that is not an axis.
Choice choose_up(const std::optional<std::string>& asked, const std::optional<std::string>& stated);

}  // namespace palpate::authoring
