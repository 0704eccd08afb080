// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/hyperelastic_solids.h"

using namespace palpate;
using doctest::Approx;
using scenes::FiniteLaw;
using scenes::kFiniteLaws;

namespace {

constexpr double kShares[] = {0.0, 0.4, 1.0};
constexpr double kLame = 200.0, kShear = 50.0;

/// Of the one table of the model that has rows.
Vec3Array forces(const TissueModel& model, const Vec3Array& x, const Vec3Array& v) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_corotated_forces(model.corotated, model.rest_position, x, v, f);
  accumulate_neo_hookean_forces(model.neo_hookean, model.rest_position, x, v, f);
  return f;
}

Vec3Array forces(const TissueModel& model, const Vec3Array& x) {
  return forces(model, x, Vec3Array(x.size(), Vec3::Zero()));
}

double energy_at(const TissueModel& model, const Vec3Array& x) {
  State state(model);
  state.position = x;
  return compute_energy(model, Vec3::Zero(), state).strain;
}

/// The corner of a unit cube, 1/6 m³.
TissueModel one_tetrahedron(const FiniteLaw& law, double nodal_share) {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.mass.assign(4, 1.0);
  model.*law.table = build_hyperelastic(4, {{0, 1, 2, 3}}, {kLame}, {kShear}, {0.0}, nodal_share);
  return model;
}

Vec3Array deform(const TissueModel& model, const Mat3& f) {
  Vec3Array x = model.rest_position;
  for (Vec3& p : x) p = f * p;
  return x;
}

/// As far from rest as a press goes, and beyond: some of it is turned inside out at 20 mm.
Vec3Array tumble(const TissueModel& model, double offset) {
  const Mat3 turn = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Vec3Array x = scenes::strained(model, offset);
  for (Vec3& p : x) p = turn * p;
  return x;
}

void check_slopes(const TissueModel& model, Vec3Array x, double error) {
  const Vec3Array f = forces(model, x);
  for (const int i : {13, 20, 26}) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double kShift = 1e-7;
      const double middle = x[i][axis];
      x[i][axis] = middle + kShift;
      const double above = energy_at(model, x);
      x[i][axis] = middle - kShift;
      const double below = energy_at(model, x);
      x[i][axis] = middle;

      const double slope = (above - below) / (2.0 * kShift);
      CHECK(std::abs(f[i][axis] + slope) < error * scenes::max_norm(f));
    }
  }
}

}  // namespace

TEST_CASE("a corotated tetrahedron drawn out by a tenth pulls back with (lambda + 2 mu)/10") {
  // R = 1, S - 1 = 0.1 along z; a third of the face below is 1/6 m². Of the share, J - 1 is 0.1
  // too, and dJ/dF is 1 along z and 1.1 across
  for (const double share : kShares) {
    const TissueModel model = one_tetrahedron(kFiniteLaws[0], share);

    const Vec3Array f = forces(model, deform(model, Vec3(1, 1, 1.1).asDiagonal()));

    CHECK(f[3].z() == Approx(-(kLame + 2.0 * kShear) * 0.1 / 6.0));
    CHECK(f[1].x() == Approx(-kLame * 0.1 * (1.0 + 0.1 * share) / 6.0));
    CHECK(scenes::sum(f).norm() < 1e-13);
  }
}

TEST_CASE("a neo-Hookean tetrahedron drawn to twice its height pulls back as worked by hand") {
  // I = 6, J = 2, cof F = (2, 2, 1): P = 8/7 mu F + (k - mu) cof F with k = lambda + 5/6 mu
  for (const double share : kShares) {
    const TissueModel model = one_tetrahedron(kFiniteLaws[1], share);

    const Vec3Array f = forces(model, deform(model, Vec3(1, 1, 2).asDiagonal()));

    CHECK(f[3].z() == Approx(-(16.0 / 7.0 * kShear + kLame - kShear / 6.0) / 6.0));
    CHECK(f[1].x() == Approx(-(8.0 / 7.0 * kShear + 2.0 * (kLame - kShear / 6.0)) / 6.0));
  }
}

TEST_CASE("at rest, and however it is turned and moved, tissue of either law exerts no force") {
  for (const FiniteLaw& law : kFiniteLaws) {
    for (const double share : kShares) {
      const TissueModel model = scenes::make_finite_organ(law, 3, share);
      CHECK(scenes::max_norm(forces(model, model.rest_position)) < 1e-12);
      Vec3Array x = tumble(model, 0.0);
      for (Vec3& p : x) p += Vec3(0.1, 0.2, 0.3);
      CHECK(scenes::max_norm(forces(model, x)) < 1e-11);
      CHECK(std::abs(energy_at(model, x)) < 1e-15);
    }
  }
}

TEST_CASE("either law turns its forces with the body, and keeps momentum and angular momentum") {
  const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(-1, 1, 3).normalized()).toRotationMatrix();
  for (const FiniteLaw& law : kFiniteLaws) {
    for (const double share : kShares) {
      const TissueModel model = scenes::make_finite_organ(law, 3, share, {.damping_ratio = 0.3});
      Vec3Array x = tumble(model, 4e-3), v = scenes::scatter_vectors(x.size(), 0.1, 3);
      const Vec3Array f = forces(model, x, v);
      CHECK(scenes::sum(f).norm() < 1e-12 * scenes::max_norm(f));
      CHECK(scenes::compute_torque(x, f).norm() < 1e-12 * scenes::max_norm(f));

      for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = turn * x[i];
        v[i] = turn * v[i];
      }
      const Vec3Array turned = forces(model, x, v);
      for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK((turned[i] - turn * f[i]).norm() < 1e-11 * scenes::max_norm(f));
      }
    }
  }
}

TEST_CASE("the forces of either law are the negative slope of its energy, inside out too") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    for (const double share : kShares) {
      const TissueModel model = scenes::make_finite_organ(law, 2, share);
      check_slopes(model, tumble(model, 4e-3), 1e-6);
      check_slopes(model, tumble(model, 4e-2), 1e-6);
    }
  }
}

TEST_CASE("a tetrahedron that is flat, mirrored, a line or a point is pulled with finite forces") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    for (const double share : kShares) {
      const TissueModel model = one_tetrahedron(law, share);
      for (const Vec3& stretch : {Vec3(1, 1, 0), Vec3(1, 1, -1), Vec3(1, 0, 0), Vec3(0, 0, 0),
                                  Vec3(-1, -1, -1), Vec3(1, 1, -0.3)}) {
        const Vec3Array x = deform(model, stretch.asDiagonal());
        for (const Vec3& force : forces(model, x)) CHECK(force.allFinite());
        CHECK(std::isfinite(energy_at(model, x)));
      }
      // pressed through the face below, the tip is driven back up
      CHECK(forces(model, deform(model, Vec3(1, 1, -0.3).asDiagonal()))[3].z() > 0.0);
    }
  }
}

TEST_CASE("tissue of either law that was turned inside out comes back to rest") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    const TissueModel model =
        scenes::make_finite_organ(law, 2, 0.9, {.damping_ratio = 0.3, .drag = 50.0});
    State state(model);
    state.position = scenes::strained(model, 2e-2);
    const double dt = 0.2 * stable_step(model);

    for (int s = 0; s * dt < 1.0; ++s) step(model, Load(), dt, state);

    CHECK(scenes::max_difference(state.position, model.rest_position) < 1e-4);
  }
}

TEST_CASE("viscosity takes energy from every motion but that of a rigid body") {
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel damped = scenes::make_finite_organ(law, 2, 0.9, {.damping_ratio = 0.3});
    const TissueModel free = scenes::make_finite_organ(law, 2, 0.9);
    const Vec3Array x = tumble(damped, 4e-3);
    const Vec3Array still = forces(free, x), v = scenes::scatter_vectors(x.size(), 0.1, 3);
    const Vec3Array moving = forces(damped, x, v);
    double power = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) power += (moving[i] - still[i]).dot(v[i]);
    CHECK(power < 0.0);

    Vec3Array spin = x;
    for (Vec3& w : spin) w = Vec3(1, 2, 3) + Vec3(3, -1, 2).cross(w);
    const Vec3Array spinning = forces(damped, x, spin);
    for (std::size_t i = 0; i < x.size(); ++i) {
      CHECK((spinning[i] - still[i]).norm() < 1e-12 * scenes::max_norm(still));
    }
  }
}
