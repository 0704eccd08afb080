// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/dynamics/private/maxwell_law.h"
#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/side_hessian.h"
#include "palpate/sim/implicit/private/xpbd.h"

namespace palpate::xpbd {
namespace {

using One = Eigen::Matrix<double, 1, 1>;

/// Springs or bonds: U = k (l - L)²/2, with a Maxwell branch k (1 + r) (l - L)²/2 - r k d (l - L),
/// d its elongation; damping c of l', or of all of d' where it is isotropic.
class LinkConstraints final : public Constraints {
 public:
  /// `stiffness` [N/m] is what triangles leave of the links' own; `first` of their elongations.
  LinkConstraints(const TissueModel& model, const Links& links, std::vector<double> stiffness,
                  std::size_t first)
      : model_(model),
        links_(links),
        stiffness_(std::move(stiffness)),
        first_(first),
        along_(links.ends.size()),
        rate_(isotropic() ? links.ends.size() : 0) {}

  void reset() override {
    std::fill(along_.begin(), along_.end(), One::Zero());
    std::fill(rate_.begin(), rate_.end(), Vec3::Zero());
  }

  void sweep(Particles& particles) override {
    for (std::size_t l = 0; l < links_.ends.size(); ++l) {
      pull(l, particles);
      if (isotropic()) slow(l, particles);
    }
  }

 private:
  bool isotropic() const noexcept { return model_.damping_law == DampingLaw::isotropic; }

  void pull(std::size_t l, Particles& particles) noexcept {
    const auto [i, j] = links_.ends[l];
    const auto &a = particles.position[static_cast<std::size_t>(i)],
               &b = particles.position[static_cast<std::size_t>(j)];
    const double length = (b - a).norm(), rest = links_.rest_length[l];
    if (length <= kNoDirection * rest) return;
    const double ratio = model_.maxwell.ratio, stiffness = (1.0 + ratio) * stiffness_[l];
    const double elongation = particles.internal.empty() ? 0.0 : particles.internal[first_ + l];
    Block<1, 2> block;
    block.corners = links_.ends[l];
    block.gradient[1] = (b - a).transpose() / length;
    block.gradient[0] = -block.gradient[1];
    block.slope[0] = stiffness * (length - rest) - ratio * links_.stiffness[l] * elongation;
    block.curvature(0, 0) = std::max(stiffness, 0.0);
    if (!isotropic()) block.damping(0, 0) = links_.damping[l];
    project(block, particles, along_[l]);
  }

  void slow(std::size_t l, Particles& particles) noexcept {
    Block<3, 2> block;
    block.corners = links_.ends[l];
    block.gradient[1].setIdentity();
    block.gradient[0] = -block.gradient[1];
    block.damping = links_.damping[l] * Mat3::Identity();
    project(block, particles, rate_[l]);
  }

  const TissueModel& model_;
  const Links& links_;
  std::vector<double> stiffness_;
  std::size_t first_;
  std::vector<One> along_;
  std::vector<Vec3> rate_;
};

/// Angles and stretch-bend with what each triangle holds of its bonds, as one energy of its three
/// sides: alone an angle may be indefinite.
class AngleConstraints final : public Constraints {
 public:
  AngleConstraints(const TissueModel& model, std::vector<PerSide<double>> share, std::size_t first)
      : model_(model), share_(std::move(share)), first_(first), multiplier_(share_.size()) {}

  void reset() override { std::fill(multiplier_.begin(), multiplier_.end(), Vec3::Zero()); }

  void sweep(Particles& particles) override {
    for (std::size_t t = 0; t < share_.size(); ++t) pull(t, particles);
  }

 private:
  void pull(std::size_t t, Particles& particles) noexcept {
    const Angles& angles = model_.angles;
    Block<3, 3> block;
    block.corners = angles.corners[t];
    for (auto& gradient : block.gradient) gradient.setZero();
    PerSide<Dual> length;
    for (int c = 0; c < 3; ++c) {
      const int p = (c + 1) % 3, q = (c + 2) % 3;
      const Vec3 side = particles.position[static_cast<std::size_t>(block.corners[p])] -
                        particles.position[static_cast<std::size_t>(block.corners[q])];
      const double norm = side.norm();
      length[c] = Dual(norm, Vec3::Unit(c));
      if (norm <= kNoDirection * angles.rest_length[t][c]) continue;
      block.gradient[p].row(c) = side.transpose() / norm;
      block.gradient[q].row(c) = -side.transpose() / norm;
    }
    const Divisors<Dual> by = invert_lengths(angles.rest_length[t], length);
    const double ratio = model_.maxwell.ratio;
    add(AngleRow(angles, t), length, by, 1.0, block);
    if (ratio > 0.0) {
      std::array<double, 6> rest{};
      if (!particles.internal.empty()) {
        std::copy_n(particles.internal.begin() + static_cast<std::ptrdiff_t>(first_ + 6 * t), 6,
                    rest.begin());
      }
      add(laws::MaxwellLaw::shift(angles, t, rest), length, by, ratio, block);
    }
    for (int c = 0; c < 3; ++c) {
      const double share = (1.0 + ratio) * share_[t][c];
      block.slope[c] += share * (length[c].value - angles.rest_length[t][c]);
      block.curvature(c, c) += share;
    }
    block.curvature = clamp_eigenvalues(0.5 * (block.curvature + block.curvature.transpose()));
    project(block, particles, multiplier_[t]);
  }

  static void add(const AngleRow& row, const PerSide<Dual>& length, const Divisors<Dual>& by,
                  double part, Block<3, 3>& block) noexcept {
    const PerSide<Dual> tension = compute_angle_tensions(row, length, by);
    for (int c = 0; c < 3; ++c) {
      block.slope[c] += part * tension[c].value;
      block.curvature.row(c) += part * tension[c].slope.transpose();
    }
  }

  const TissueModel& model_;
  std::vector<PerSide<double>> share_;
  std::size_t first_;
  std::vector<Vec3> multiplier_;
};

/// The shear of the sides of prisms: U = k s²/2, s the difference of two diagonals.
class PrismConstraints final : public Constraints {
 public:
  explicit PrismConstraints(const Prisms& prisms)
      : prisms_(prisms), multiplier_(3 * prisms.corners.size()) {}

  void reset() override { std::fill(multiplier_.begin(), multiplier_.end(), One::Zero()); }

  void sweep(Particles& particles) override {
    const auto at = [&](int i) -> const Vec3& {
      return particles.position[static_cast<std::size_t>(i)];
    };
    for (std::size_t p = 0; p < prisms_.corners.size(); ++p) {
      for (int c = 0; c < 3; ++c) {
        const PrismSide side(prisms_.corners[p], c);
        const Diagonals now(side, at);
        Block<1, 4> block;
        block.corners = side.ends;
        block.gradient = {-now.unit[0].transpose(), now.unit[0].transpose(),
                          now.unit[1].transpose(), -now.unit[1].transpose()};
        const double shear = now.length[0] - now.length[1] - prisms_.rest_difference[p][c];
        block.slope[0] = prisms_.shear_stiffness[p][c] * shear;
        block.curvature(0, 0) = prisms_.shear_stiffness[p][c];
        block.damping(0, 0) = prisms_.shear_damping[p][c];
        project(block, particles, multiplier_[3 * p + static_cast<std::size_t>(c)]);
      }
    }
  }

 private:
  const Prisms& prisms_;
  std::vector<One> multiplier_;
};

/// U = h |x - X|²/2 of every particle.
class HomeConstraints final : public Constraints {
 public:
  explicit HomeConstraints(const TissueModel& model)
      : model_(model), multiplier_(model.home.size()) {}

  void reset() override { std::fill(multiplier_.begin(), multiplier_.end(), Vec3::Zero()); }

  void sweep(Particles& particles) override {
    const double dt = particles.dt;
    for (std::size_t i = 0; i < multiplier_.size(); ++i) {
      const double w = particles.inverse_weight[i], h = model_.home[i];
      const Vec3 pull = dt * dt * h * (particles.position[i] - model_.rest_position[i]);
      const Vec3 change = -(multiplier_[i] + pull) / (1.0 + dt * dt * h * w);
      multiplier_[i] += change;
      particles.position[i] += w * change;
    }
  }

 private:
  const TissueModel& model_;
  std::vector<Vec3> multiplier_;
};

}  // namespace

void add_length_constraints(const TissueModel& model, ConstraintList& list) {
  const SharedBonds shared(model.bonds, model.angles);
  std::size_t first = 0;
  if (!model.springs.ends.empty()) {
    list.push_back(
        std::make_unique<LinkConstraints>(model, model.springs, model.springs.stiffness, first));
  }
  first += model.springs.ends.size();
  if (!model.bonds.ends.empty()) {
    list.push_back(std::make_unique<LinkConstraints>(model, model.bonds, shared.remainder, first));
  }
  first += model.bonds.ends.size();
  if (!model.angles.corners.empty()) {
    list.push_back(std::make_unique<AngleConstraints>(model, shared.share, first));
  }
  if (!model.prisms.corners.empty()) {
    list.push_back(std::make_unique<PrismConstraints>(model.prisms));
  }
  if (!model.home.empty()) list.push_back(std::make_unique<HomeConstraints>(model));
}

}  // namespace palpate::xpbd
