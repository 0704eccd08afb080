// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <type_traits>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/elastic_energy.h"
#include "palpate/sim/dynamics/private/hyperelastic_law.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/dynamics/private/law_tangents.h"
#include "palpate/sim/dynamics/private/maxwell_law.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/private/law_tables.h"

// How each law of model/private/law_tables.h pulls: forces, energy, tangent and the bound on how
// stiff a strained tissue may get are sums over these.

namespace palpate::laws {

template <const auto& its_table, Links TissueModel::*links>
struct LinkLaw {
  static constexpr const auto& table = its_table;
  static constexpr double Energy::*kEnergy = &Energy::links;
  static constexpr Stiffens kStiffens = Stiffens::as_links;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    accumulate_link_forces(now.model.*links, now.model.damping_law, now.x, now.v, f);
  }
  static void accumulate_damping(const TissueModel& model, std::span<const Vec3> x,
                                 std::span<const Vec3> v, std::span<Vec3> f) noexcept {
    accumulate_link_damping(model.*links, model.damping_law, x, v, f);
  }
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return compute_link_energy(model.*links, at);
  }
};

// springs, bonds, angles and home springs share one tangent (tangent.cpp)
using SpringLaw = LinkLaw<kSprings, &TissueModel::springs>;
using BondLaw = LinkLaw<kBonds, &TissueModel::bonds>;

struct AnglesLaw {
  static constexpr const auto& table = kAngles;
  static constexpr double Energy::*kEnergy = &Energy::angles;
  static constexpr Stiffens kStiffens = Stiffens::as_sides;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    if (now.model.angle_law == AngleLaw::gradient) {
      accumulate_angle_forces(now.model.angles, now.x, f);
    } else {
      accumulate_eq10_forces(now.model.angles, now.x, f);
    }
  }
  /// Eq 10 has none.
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return model.angle_law == AngleLaw::gradient ? compute_angle_energy(model.angles, at) : 0.0;
  }
};

struct PrismLaw {
  static constexpr const auto& table = kPrisms;
  static constexpr double Energy::*kEnergy = &Energy::prisms;
  static constexpr Stiffens kStiffens = Stiffens::as_sides;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    accumulate_prism_forces(now.model.prisms, now.x, now.v, f);
  }
  static void accumulate_damping(const TissueModel& model, std::span<const Vec3> x,
                                 std::span<const Vec3> v, std::span<Vec3> f) noexcept {
    accumulate_prism_damping(model.prisms, x, v, f);
  }
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return compute_prism_energy(model.prisms, at);
  }
  static auto compute_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                Projection projection) {
    return compute_prism_stiffness(model, x, projection);
  }
  static auto compute_damping(const TissueModel& model, std::span<const Vec3> x) {
    return compute_prism_damping(model, x);
  }
};

struct VolumeLaw {
  static constexpr const auto& table = kVolumes;
  static constexpr double Energy::*kEnergy = &Energy::volumes;
  static constexpr Stiffens kStiffens = Stiffens::as_volumes;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    accumulate_volume_forces(now.model.volumes, now.x, f);
  }
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return compute_volume_energy(model.volumes, at);
  }
  static auto compute_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                Projection projection) {
    return compute_volume_stiffness(model, x, projection);
  }
};

struct ElasticLaw {
  static constexpr const auto& table = kElastic;
  static constexpr double Energy::*kEnergy = &Energy::strain;
  static constexpr Stiffens kStiffens = Stiffens::not_at_all;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    accumulate_elastic_forces(now.model.elastic, now.model.rest_position, now.x, now.v, f);
  }
  /// At rest nothing but what is damped pulls.
  static void accumulate_damping(const TissueModel& model, std::span<const Vec3>,
                                 std::span<const Vec3> v, std::span<Vec3> f) noexcept {
    if (model.elastic.damping_time == 0.0) return;
    accumulate_elastic_forces(model.elastic, model.rest_position, model.rest_position, v, f);
  }
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return compute_linear_energy(model, at);
  }
  static auto compute_stiffness(const TissueModel& model, std::span<const Vec3>, Projection) {
    return compute_elastic_stiffness(model);
  }
  static Eigen::SparseMatrix<double> compute_damping(const TissueModel& model,
                                                     std::span<const Vec3>) {
    return model.elastic.damping_time * compute_elastic_stiffness(model);
  }
};

/// The two laws of tetrahedra at finite strain.
template <const auto& its_table, Hyperelastic TissueModel::*of, class ItsDensity,
          auto accumulate_all, auto compute_tangent>
struct HyperelasticLaw {
  using Density = ItsDensity;
  static constexpr const auto& table = its_table;
  static constexpr double Energy::*kEnergy = &Energy::strain;
  static constexpr Stiffens kStiffens = Stiffens::as_strains;
  static void accumulate(const Configuration& now, std::span<Vec3> f) noexcept {
    accumulate_all(now.model.*of, now.model.rest_position, now.x, now.v, f);
  }
  static void accumulate_damping(const TissueModel& model, std::span<const Vec3> x,
                                 std::span<const Vec3> v, std::span<Vec3> f) noexcept {
    accumulate_viscous_damping(model.*of, model.rest_position, x, v, f);
  }
  template <class At>
  static double compute_energy(const TissueModel& model, At at, std::span<const double>) noexcept {
    return compute_hyperelastic_energy<Density>(model.*of, model.rest_position, at);
  }
  static auto compute_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                Projection projection) {
    return compute_tangent(model, x, projection);
  }
  static auto compute_damping(const TissueModel& model, std::span<const Vec3> x) {
    return compute_viscous_damping(model, model.*of, x);
  }
};

using CorotatedLaw = HyperelasticLaw<kCorotated, &TissueModel::corotated, Corotated,
                                     &accumulate_corotated_forces, &compute_corotated_stiffness>;
using NeoHookeanLaw =
    HyperelasticLaw<kNeoHookean, &TissueModel::neo_hookean, NeoHookean,
                    &accumulate_neo_hookean_forces, &compute_neo_hookean_stiffness>;

/// In the sequence of kLaws.
using All = std::tuple<SpringLaw, BondLaw, AnglesLaw, PrismLaw, VolumeLaw, ElasticLaw, CorotatedLaw,
                       NeoHookeanLaw, MaxwellLaw>;
static_assert(std::tuple_size_v<All> == std::tuple_size_v<decltype(kLaws)>);

/// visit(law) for every law, an object without members.
template <class Visit>
constexpr void for_each(Visit visit) {
  std::apply([&](auto... law) { (visit(law), ...); }, All());
}

template <class Law>
std::size_t count_internal(const TissueModel& model) noexcept {
  if constexpr (requires { Law::count_internal(model); }) {
    return Law::count_internal(model);
  } else {
    return 0;
  }
}

/// visit(law, its part of `internal`) for every law; empty parts where `internal` is.
template <class Number, class Visit>
void for_each_part(const TissueModel& model, std::span<Number> internal, Visit visit) noexcept {
  std::size_t first = 0;
  for_each([&]<class Law>(Law law) {
    const std::size_t count = internal.empty() ? 0 : count_internal<Law>(model);
    visit(law, internal.subspan(first, count));
    first += count;
  });
}

/// [J] of all laws and home springs; Eq 10 has no energy.
template <class At>
double compute_elastic_energy(const TissueModel& model, At at,
                              std::span<const double> internal = {}) noexcept {
  double sum = 0.0;
  for_each_part(model, internal, [&]<class Law>(Law, std::span<const double> part) {
    sum += Law::compute_energy(model, at, part);
  });
  return sum + compute_home_energy(model, at);
}

}  // namespace palpate::laws
