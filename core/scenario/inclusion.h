// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/scenario/assessment_parts.h"

// Not installed: inclusions, the stiff spots of which an attempt has one, as tables of constants.

namespace palpate::scenario {

/// The body with the constants that an assessment's arrays have for the inclusion of a place.
/// Throws FileError for arrays that are none of its constants, or of other rows.
SoftBody with_inclusion(const Arrays& arrays, const std::string& place, SoftBody body,
                        const std::string& file);

/// Every inclusion that an assessment names: that it has constants, and within their ranges.
void check_inclusions(const Scenario& scenario, const Names& names, const std::string& file);

}  // namespace palpate::scenario
