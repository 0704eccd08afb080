// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <functional>

#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/hyperelastic_solids.h"
#include "skip.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// [1/s²] The largest eigenvalue of M⁻¹K at x, by a dense solver.
double find_stiffness(const TissueModel& model, const Vec3Array& x) {
  Eigen::MatrixXd k = compute_stiffness(model, x, Projection::none);
  k = 0.5 * (k + Eigen::MatrixXd(k.transpose()));
  Eigen::VectorXd scale(k.rows());
  for (int i = 0; i < particle_count(model); ++i) {
    scale.segment<3>(3 * i).setConstant(1.0 / std::sqrt(model.mass[i]));
  }
  k = scale.asDiagonal() * k * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .tail<1>()[0];
}

using Shape = std::function<Vec3(const Vec3&)>;

/// Stretched, squeezed, sheared, wrung, and poked far in and far out.
std::vector<Shape> make_shapes() {
  const auto scaled = [](double x, double y, double z) -> Shape {
    return [=](const Vec3& p) { return Vec3(x * p.x(), y * p.y(), z * p.z()); };
  };
  const auto poked = [](double depth) -> Shape {
    return [=](const Vec3& p) {
      return Vec3(p + Vec3(0, 0, depth * std::exp(-(p - Vec3(0, 0, 0.03)).norm() / 0.015)));
    };
  };
  const Shape sheared = [](const Vec3& p) { return Vec3(p.x() + 0.6 * p.z(), p.y(), p.z()); };
  const Shape wrung = [](const Vec3& p) {
    return Vec3(Eigen::AngleAxisd(20.0 * p.x(), Vec3::UnitX()) * p);
  };
  return {scaled(1, 1, 1),
          scaled(1.3, 1.3, 1.3),
          scaled(1.8, 1.8, 1.8),
          scaled(2.0, 1, 1),
          scaled(1, 0.6, 1.5),
          scaled(0.7, 0.7, 0.7),
          scaled(1.4, 0.8, 0.8),
          poked(-0.03),
          poked(0.05),
          sheared,
          wrung};
}

Vec3Array shape(const TissueModel& model, const Shape& shape) {
  Vec3Array x = model.rest_position;
  for (Vec3& p : x) p = shape(p);
  return x;
}

}  // namespace

TEST_CASE("stretch is measured as the longest and the shortest part of a rest length") {
  const TissueModel model = scenes::make_chain_model(3, 1e-3, 100.0, 0.05, 2e-3);
  Vec3Array x = model.rest_position;
  x[2] += 0.5 * (x[2] - x[1]);

  const Stretch stretch = measure_stretch(model, x);

  CHECK(stretch.longest == Approx(1.5));
  CHECK(measure_stretch(model, model.rest_position).longest == Approx(1.0));
  CHECK(measure_stretch(model, model.rest_position).shortest == Approx(1.0));
}

TEST_CASE("a spring pulled to twice its length holds across with half of what it holds along") {
  TissueModel model = scenes::make_oscillator_model(1e-3, 200.0);
  const StretchSpectrum spectrum(model, 200.0 / 1e-3);

  // k (n n^T + (1 - L/l)(1 - n n^T)): across 100 N/m, and no direction has more than k
  CHECK(bound_stiffness(spectrum, {}) == Approx(200.0 / 1e-3));
  CHECK(bound_stiffness(spectrum, {.longest = 2.0}) ==
        Approx(0.5 * (200.0 / 1e-3 + spectrum.taut)));
  CHECK(spectrum.taut >= 200.0 / 1e-3);
}

TEST_CASE("no tissue is stiffer in any shape than its stretch says, nor softer by much") {
  const std::vector<TissueModel> tissues = {
      scenes::make_spring_organ(2), scenes::make_molecular_organ(2), scenes::make_sheet_tissue(),
      scenes::make_molecular_organ(2, {}, AngleLaw::eq10)};
  for (std::size_t m = 0; m < tissues.size(); ++m) {
    const TissueModel& model = tissues[m];
    const StretchSpectrum spectrum(model, estimate_spectrum(model).stiffness);
    const std::vector<Shape> shapes = make_shapes();
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      CAPTURE(m);
      CAPTURE(s);
      const Vec3Array x = shape(model, shapes[s]);
      const double bound = bound_stiffness(spectrum, measure_stretch(model, x));
      const double exact = find_stiffness(model, x);
      // a spectrum is estimated to a thousandth
      CHECK(exact <= 1.001 * bound);
      CHECK(bound < 1.6 * exact);
    }
  }
}

TEST_CASE("no solid is stiffer in any shape than its stretch says") {
  for (const double share : {0.0, 0.9, 1.0}) {
    const TissueModel model = scenes::make_solid_organ(4, share);
    const StretchSpectrum spectrum(model, estimate_spectrum(model).stiffness);
    const std::vector<Shape> shapes = make_shapes();
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      CAPTURE(share);
      CAPTURE(s);
      const Vec3Array x = shape(model, shapes[s]);
      const double bound = bound_stiffness(spectrum, measure_stretch(model, x));
      const double exact = find_stiffness(model, x);
      CHECK(exact <= 1.001 * bound);
    }
  }
}

TEST_CASE("no solid at finite strain is stiffer in any shape than its stretch says") {
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    for (const double share : {0.0, 0.9}) {
      const TissueModel model = scenes::make_finite_organ(law, 4, share);
      const StretchSpectrum spectrum(model, estimate_spectrum(model).stiffness);
      const std::vector<Shape> shapes = make_shapes();
      for (std::size_t s = 0; s < shapes.size(); ++s) {
        CAPTURE(std::string(law.name));
        CAPTURE(share);
        CAPTURE(s);
        const Vec3Array x = shape(model, shapes[s]);
        const double bound = bound_stiffness(spectrum, measure_stretch(model, x));
        CHECK(find_stiffness(model, x) <= 1.001 * bound);
      }
      CHECK(bound_stiffness(spectrum, measure_stretch(model, model.rest_position)) ==
            doctest::Approx(spectrum.rest));
    }
  }
}

TEST_CASE("a step of the packed kernel measures the stretch that the reference measures") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const TissueModel& model :
       {scenes::make_spring_organ(2, {.damping_ratio = 0.2}), scenes::make_molecular_organ(2),
        scenes::make_solid_organ(8, 0.5)}) {
    State state(model);
    scenes::shake(model, 2e-3, 0.0, state);
    const Stretch expected = measure_stretch(model, state.position);
    REQUIRE(expected.longest > 1.1);
    REQUIRE(expected.shortest < 0.9);
    for (const std::string& target : simd_targets()) {
      const PackedModel packed = pack(model, target);
      PackedState running(packed, model, state);
      PackedMeasure measure;
      step(packed, Load(), 1e-6, running, &measure);
      CHECK(measure.stretch.longest == Approx(expected.longest).epsilon(1e-5));
      CHECK(measure.stretch.shortest == Approx(expected.shortest).epsilon(1e-5));
      CHECK(measure.stretch.smallest_volume == Approx(expected.smallest_volume).epsilon(1e-4));
      CHECK(measure.stretch.smallest_mean == Approx(expected.smallest_mean).epsilon(1e-5));
    }
  }
}
