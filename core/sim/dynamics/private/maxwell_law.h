// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "palpate/sim/dynamics/private/elastic_energy.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/dynamics/private/law_tangents.h"
#include "palpate/sim/model/private/law_tables.h"

namespace palpate::laws {

/// Linear viscoelasticity: one Maxwell branch beside every spring, bond, angle and stretch-bend
/// [laws: relaxation]. A branch is the same law r times as stiff in what its dashpots leave of each
/// length and each cosine,
///
///     W_v = r W(q - d),   f = -dW_v/dx at fixed d,   d' = (q - d)/tau
///
/// with q the change of a length or cosine from rest. At fixed q all that is left in a branch fades
/// as exp(-t/tau), so its energy only falls. Internal variables are the elongations d: of springs
/// and bonds [m], then of each triangle three sides [m] and three cosines.
struct MaxwellLaw {
  static constexpr const auto& table = kMaxwell;
  static constexpr double Energy::*kEnergy = &Energy::links;
  static constexpr Stiffens kStiffens = Stiffens::as_the_others;

  static std::size_t count_internal(const TissueModel& model) noexcept {
    if (!is_present(model, table)) return 0;
    return model.springs.ends.size() + model.bonds.ends.size() + 6 * model.angles.corners.size();
  }

  /// visit(links, row, elongation) and visit(angles, row, elongations) for all there is. Without
  /// variables, what they would be in a tissue that was strained at once: 0.
  template <class Number, class OfLink, class OfTriangle>
  static void visit(const TissueModel& model, std::span<Number> internal, OfLink of_link,
                    OfTriangle of_triangle) noexcept {
    std::array<std::remove_const_t<Number>, 6> zeros{};
    std::size_t next = 0;
    const auto take = [&](std::size_t count) -> std::span<Number> {
      if (internal.empty()) return std::span<Number>(zeros).first(count);
      next += count;
      return internal.subspan(next - count, count);
    };
    for (const Links* links : {&model.springs, &model.bonds}) {
      for (std::size_t l = 0; l < links->ends.size(); ++l) of_link(*links, l, take(1)[0]);
    }
    for (std::size_t t = 0; t < model.angles.corners.size(); ++t) of_triangle(t, take(6));
  }

  /// A triangle's sides as they lie, from the place of its corners.
  struct Shape {
    template <class At>
    Shape(const Angles& angles, std::size_t t, At at) noexcept {
      const auto [i, j, k] = angles.corners[t];
      const Vec3 a = at(i), b = at(j), c = at(k);
      side = {b - c, c - a, a - b};
      length = {side[0].norm(), side[1].norm(), side[2].norm()};
      by = invert_lengths(angles.rest_length[t], length);
      cosine = compute_cosines(length, by.inverse);
    }
    PerSide<Vec3> side;
    PerSide<double> length, cosine;
    Divisors<double> by;
  };

  /// The row of a branch: at rest where its dashpots have gone.
  static AngleRow shift(const Angles& angles, std::size_t t, std::span<const double> d) noexcept {
    AngleRow row(angles, t);
    for (std::size_t c = 0; c < 3; ++c) {
      row.rest_length[c] += d[c];
      row.rest_cosine[c] += d[3 + c];
    }
    return row;
  }

  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    const TissueModel& model = now.model;
    const double ratio = model.maxwell.ratio;
    if (ratio == 0.0) return;
    const auto at = [&](int i) -> const Vec3& { return now.x[static_cast<std::size_t>(i)]; };
    visit(
        model, now.internal,
        [&](const Links& links, std::size_t l, double d) noexcept {
          const auto [i, j] = links.ends[l];
          const Vec3 along = at(j) - at(i);
          const double length = along.norm(), rest = links.rest_length[l];
          if (length <= kNoDirection * rest) return;
          const Vec3 pull = (ratio * links.stiffness[l] * (length - rest - d) / length) * along;
          f[static_cast<std::size_t>(i)] += pull;
          f[static_cast<std::size_t>(j)] -= pull;
        },
        [&](std::size_t t, std::span<const double> d) noexcept {
          const Shape shape(model.angles, t, at);
          const AngleRow row = shift(model.angles, t, d);
          const PerSide<double> tension = model.angle_law == AngleLaw::gradient
                                              ? compute_angle_tensions(row, shape.length, shape.by)
                                              : compute_eq10_tensions(row, shape.length, shape.by);
          for (std::size_t c = 0; c < 3; ++c) {
            const Vec3 pull = (ratio * tension[c] * shape.by.direction[c]) * shape.side[c];
            // side c runs from corner c + 2 to corner c + 1
            f[static_cast<std::size_t>(model.angles.corners[t][(c + 1) % 3])] -= pull;
            f[static_cast<std::size_t>(model.angles.corners[t][(c + 2) % 3])] += pull;
          }
        });
  }

  template <class At>
  static double compute_energy(const TissueModel& model, At at,
                               std::span<const double> internal) noexcept {
    const double ratio = model.maxwell.ratio;
    if (ratio == 0.0) return 0.0;
    double sum = 0.0;
    visit(
        model, internal,
        [&](const Links& links, std::size_t l, double d) noexcept {
          const auto [i, j] = links.ends[l];
          const double stretch = Vec3(at(j) - at(i)).norm() - links.rest_length[l] - d;
          sum += 0.5 * links.stiffness[l] * stretch * stretch;
        },
        [&](std::size_t t, std::span<const double> d) noexcept {
          if (model.angle_law != AngleLaw::gradient) return;
          const Shape shape(model.angles, t, at);
          sum += compute_angle_energy(shift(model.angles, t, d), shape.length, shape.cosine);
        });
    return ratio * sum;
  }

  /// Of a tissue that was strained at once.
  static Eigen::SparseMatrix<double> compute_stiffness(const TissueModel& model,
                                                       std::span<const Vec3> x,
                                                       Projection projection) {
    return model.maxwell.ratio * compute_side_stiffness(model, x, projection, false);
  }

  static double scale_links(const TissueModel& model) noexcept { return 1.0 + model.maxwell.ratio; }

  /// Exact where the tissue holds still at x: d = q - (q - d) exp(-dt/tau). Where it moves, what is
  /// left in a branch is short by dt/(2 tau) of it.
  static void advance_internal(const TissueModel& model, std::span<const Vec3> x, double dt,
                               std::span<double> internal) noexcept {
    if (internal.empty()) return;
    const double kept = std::exp(-dt / model.maxwell.time);
    const auto at = [&](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; };
    const auto follow = [kept](double q, double& d) noexcept { d = q - (q - d) * kept; };
    visit(
        model, internal,
        [&](const Links& links, std::size_t l, double& d) noexcept {
          const auto [i, j] = links.ends[l];
          follow((at(j) - at(i)).norm() - links.rest_length[l], d);
        },
        [&](std::size_t t, std::span<double> d) noexcept {
          const Shape shape(model.angles, t, at);
          for (std::size_t c = 0; c < 3; ++c) {
            follow(shape.length[c] - model.angles.rest_length[t][c], d[c]);
            follow(shape.cosine[c] - model.angles.rest_cosine[t][c], d[3 + c]);
          }
        });
  }
};

}  // namespace palpate::laws
