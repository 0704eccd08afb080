// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/wall_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/model/private/prism_shear.h"

namespace palpate {
namespace {

/// Of the trapezoids over ln k: from waves of metres to those that a layer does not tell from a
/// half space.
constexpr double kLongest = 0.3, kShortest = 40.0;  // [1/m], [1/h]
constexpr int kPoints = 160;

/// [-] A layer over a half space under a wave of the wavenumber x/h: from the plate's 6/x³ to 1.
double compute_layer_factor(double x) {
  if (x > 15.0) return 1.0;
  if (x < 0.5) {
    const double y = x * x;
    const double above = 2.0 + y * (2.0 / 3.0 + y * (2.0 / 15.0 + y * 4.0 / 315.0));
    const double below = 1.0 / 3.0 + y * (2.0 / 45.0 + y * (1.0 / 315.0 + y * 2.0 / 14175.0));
    return above / (x * y * below);
  }
  const double s = std::sinh(x);
  return (s * std::cosh(x) + x) / (s * s - x * x);
}

/// One wave of pressure, k [1/m].
struct Wave {
  Wave(const WallLayer& wall, double wavenumber) : k(wavenumber), x(wavenumber * wall.thickness) {}

  /// [m³/N] how far a half space sinks under it, and a layer that is free below.
  double half_space(const WallLayer& wall) const { return 2.0 / (wall.modulus * k); }
  double tissue(const WallLayer& wall) const { return half_space(wall) * compute_layer_factor(x); }

  /// [m³/N] a plate that bends and shears, and the pillars between its faces.
  double prisms(const WallLayer& wall) const {
    const double h = wall.thickness, square = wall.modulus / wall.young;
    const double poisson = std::sqrt(std::max(0.0, 1.0 - 1.0 / square));
    const double shear = 0.5 * wall.young / (1.0 + poisson) * kShearShare * wall.unlocked;
    return 12.0 / (wall.modulus * h * h * h * std::pow(k, 4)) + 1.0 / (shear * h * k * k) +
           0.25 * h / wall.young;
  }

  /// With what holds the wall as a whole beside it, as of a shallow shell.
  static double hold(double compliance, double foundation) {
    return compliance / (1.0 + compliance * foundation);
  }

  double k, x;
};

/// [m/N] of what a wave of a unit pressure moves, over all waves: k dk/(2 pi), in ln k.
template <class Move>
double integrate_waves(const WallLayer& wall, Move move) {
  const double first = std::log(kLongest), last = std::log(kShortest / wall.thickness);
  const double step = (last - first) / (kPoints - 1);
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const Wave wave(wall, std::exp(first + i * step));
    sum += wave.k * wave.k * move(wave);
  }
  return sum * step / (2.0 * std::numbers::pi);
}

}  // namespace

/// A pressure over which points are `spread` apart is, to the second order of k, a bell:
/// |p|² = exp(-k² spread/4).
double compute_prism_compliance(const WallLayer& wall, double spread, double foundation) {
  return integrate_waves(wall, [&](const Wave& wave) {
    return Wave::hold(wave.prisms(wall), foundation) * std::exp(-0.25 * spread * wave.k * wave.k);
  });
}

double compute_point_excess(const WallLayer& wall, double foundation) {
  return integrate_waves(wall, [&](const Wave& wave) {
    return Wave::hold(wave.tissue(wall), foundation) - wave.half_space(wall);
  });
}

}  // namespace palpate
