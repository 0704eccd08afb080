// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

/// A contact and whose it is.
struct TriangleContact {
  int triangle = 0;
  Contact contact;
};

/// The contacts with force of a tool at `position` [m] with one of its surfaces as that is now, by
/// the law that balance_tool() has: its candidates must be those of the place. Writes into the
/// candidates' work space, so that they should not be those of a running scene. Allocates.
std::vector<TriangleContact> list_contacts(const Tool& tool, const TouchedSurface& surface,
                                           const Vec3& position,
                                           const Quaternion& orientation = Quaternion::Identity());

}  // namespace palpate
