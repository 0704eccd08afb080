// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "palpate/sim/contact/private/near_contact.h"

/// A square of right triangles that gives nowhere: all of the dent is the near field's.
struct RigidSurface {
  static constexpr double kModulus = 6270.0;  ///< [Pa]

  /// Facing up, `size` [m] wide, domed by `shape` [1/m], and `curvature` [1/m] at each vertex.
  RigidSurface(double size, double edge, double shape, double curvature) {
    const int cells = static_cast<int>(std::lround(size / edge));
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        const double across = edge * i - 0.5 * size, along = edge * j - 0.5 * size;
        x.push_back({across, along, -0.5 * shape * (across * across + along * along)});
      }
    }
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const int a = i * (cells + 1) + j, b = a + cells + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
    }
    near.modulus = kModulus;
    near.far_compliance.assign(x.size(), 0.0);
    near.curvature.assign(x.size(), curvature);
    near.first.assign(x.size() + 1, 0);
    const int count = static_cast<int>(triangles.size());
    candidates = palpate::Candidates(count);
    candidates.near = palpate::NearContacts(count, static_cast<int>(x.size()));
  }

  /// [N] What a ball feels at p.
  palpate::Vec3 press_at(const palpate::Tool& tool, const palpate::Vec3& p) {
    palpate::NearContacts& contacts = candidates.near;
    contacts.count = 0;
    contacts.knows_compliance = false;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const auto at = static_cast<std::size_t>(contacts.count);
      if (!palpate::find_contact(tool, 1e-6, p, x[static_cast<std::size_t>(a)],
                                 x[static_cast<std::size_t>(b)], x[static_cast<std::size_t>(c)],
                                 contacts.closest[at])) {
        continue;
      }
      contacts.triangle[at] = static_cast<int>(t);
      ++contacts.count;
    }
    palpate::find_near_contacts({tool, {}}, {&candidates, triangles, x, nullptr, &near}, p);
    palpate::Vec3 sum = palpate::Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
      sum += contacts.contact[i].force * contacts.contact[i].direction;
    }
    return sum;
  }

  palpate::Vec3Array x;
  std::vector<palpate::Triangle> triangles;
  palpate::NearField near;
  palpate::Candidates candidates;
};
