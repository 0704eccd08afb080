// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "palpate/sim/dynamics/private/volume_law.h"
#include "palpate/sim/implicit/private/xpbd.h"

namespace palpate::xpbd {

/// U(J - 1) of the mean J of the tetrahedra around each particle, by rest volume.
class MeanConstraints : public Constraints {
 public:
  /// A table whose tetrahedra have `stiffness` [Pa], of which `share` acts on means; `volume` [m³]
  /// at rest.
  template <class Table>
  MeanConstraints(const Table& table, std::span<const double> stiffness,
                  const std::vector<double>& volume, double share)
      : corners_(table.corners) {
    const std::size_t count = table.first_around.size() - 1;
    means_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      Mean& mean = means_[i];
      for (const int row : list_around(table, i)) {
        const auto t = static_cast<std::size_t>(row);
        mean.rows.push_back(t);
        mean.volume += volume[t];
        mean.stiffness += 0.25 * share * stiffness[t] * volume[t];
        mean.particles.insert(mean.particles.end(), corners_[t].begin(), corners_[t].end());
      }
      std::sort(mean.particles.begin(), mean.particles.end());
      mean.particles.erase(std::unique(mean.particles.begin(), mean.particles.end()),
                           mean.particles.end());
      gradient_.resize(std::max<std::size_t>(count, gradient_.size()));
    }
  }

  void reset() override {
    for (Mean& mean : means_) mean.multiplier = 0.0;
  }

  void sweep(Particles& particles) override {
    for (Mean& mean : means_) {
      if (mean.stiffness > 0.0) pull(mean, particles);
    }
  }

 protected:
  /// dU/dq and d²U/dq² of a mean that has swollen by q, over its stiffness.
  struct Response {
    double slope, curvature;
  };
  virtual Response respond(double swell) const noexcept = 0;
  /// [s] C over the stiffness.
  virtual double damping_time() const noexcept { return 0.0; }
  /// Where the slopes of volumes are taken: at the particles, or at rest for a linear law.
  virtual std::span<const Vec3> rest() const noexcept { return {}; }

 private:
  struct Mean {
    std::vector<std::size_t> rows;
    std::vector<int> particles;
    double volume = 0.0;     ///< [m³]
    double stiffness = 0.0;  ///< [J]
    double multiplier = 0.0;
  };

  /// Sets dq/dx of the particles of a mean, and returns q.
  double measure(const Mean& mean, const Particles& particles) noexcept {
    for (const int i : mean.particles) gradient_[static_cast<std::size_t>(i)].setZero();
    const std::span<const Vec3> at =
        rest().empty() ? std::span<const Vec3>(particles.position) : rest();
    double now = 0.0;
    for (const std::size_t t : mean.rows) {
      const auto& [a, b, c, d] = corners_[t];
      const Mat34 slopes =
          compute_volume_slopes(at[static_cast<std::size_t>(a)], at[static_cast<std::size_t>(b)],
                                at[static_cast<std::size_t>(c)], at[static_cast<std::size_t>(d)]);
      for (int k = 0; k < 4; ++k) {
        const auto i = static_cast<std::size_t>(corners_[t][static_cast<std::size_t>(k)]);
        gradient_[i] += slopes.col(k) / mean.volume;
        now += slopes.col(k).dot(particles.position[i]);
      }
    }
    return (rest().empty() ? now / 3.0 : now - 2.0 * mean.volume) / mean.volume - 1.0;
  }

  void pull(Mean& mean, Particles& particles) noexcept {
    const Response response = respond(measure(mean, particles));
    double rate = 0.0, mobility = 0.0;
    for (const int index : mean.particles) {
      const auto i = static_cast<std::size_t>(index);
      rate += gradient_[i].dot(particles.position[i] - particles.start[i]);
      mobility += particles.inverse_weight[i] * gradient_[i].squaredNorm();
    }
    const double dt = particles.dt, tau = damping_time();
    const double slope = dt * mean.stiffness * (dt * response.slope + tau * rate);
    const double stiffness = dt * mean.stiffness * (dt * response.curvature + tau);
    const double change = -(mean.multiplier + slope) / (1.0 + stiffness * mobility);
    mean.multiplier += change;
    for (const int index : mean.particles) {
      const auto i = static_cast<std::size_t>(index);
      particles.position[i] += (particles.inverse_weight[i] * change) * gradient_[i];
    }
  }

  const std::vector<std::array<int, 4>>& corners_;
  std::vector<Mean> means_;
  Vec3Array gradient_;  ///< [1/m] of all particles; of those of one mean in use
};

}  // namespace palpate::xpbd
