// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/implicit/private/stretch_hessian.h"
#include "palpate/sim/implicit/private/xpbd.h"
#include "palpate/sim/implicit/private/xpbd_means.h"

namespace palpate::xpbd {
namespace {

using One = Eigen::Matrix<double, 1, 1>;

/// (1 - s) B V e(J) of every tetrahedron, e of volume_law.h.
class VolumeConstraints final : public Constraints {
 public:
  explicit VolumeConstraints(const Volumes& volumes)
      : volumes_(volumes), multiplier_(volumes.corners.size()) {}

  void reset() override { std::fill(multiplier_.begin(), multiplier_.end(), One::Zero()); }

  void sweep(Particles& particles) override {
    for (std::size_t t = 0; t < multiplier_.size(); ++t) {
      const auto& [a, b, c, d] = volumes_.corners[t];
      const auto& x = particles.position;
      const double rest = volumes_.rest_volume[t];
      const double stiffness = (1.0 - volumes_.nodal_share) * volumes_.bulk[t] * rest;
      const Mat34 slopes = compute_volume_slopes(x[a], x[b], x[c], x[d]);
      const VolumeLaw law = compute_volume_law(measure_volume(volumes_, t, x) / rest);
      Block<1, 4> block;
      block.corners = volumes_.corners[t];
      for (int k = 0; k < 4; ++k) block.gradient[k] = slopes.col(k).transpose() / rest;
      block.slope[0] = stiffness * law.slope;
      block.curvature(0, 0) = stiffness * std::max(law.curvature, 0.0);
      project(block, particles, multiplier_[t]);
    }
  }

 private:
  const Volumes& volumes_;
  std::vector<One> multiplier_;
};

class MeanVolumes final : public MeanConstraints {
 public:
  explicit MeanVolumes(const Volumes& volumes)
      : MeanConstraints(volumes, volumes.bulk, volumes.rest_volume, volumes.nodal_share) {}

 private:
  Response respond(double swell) const noexcept override {
    const VolumeLaw law = compute_volume_law(1.0 + swell);
    return {law.slope, std::max(law.curvature, 0.0)};
  }
};

/// lambda (J - 1)²/2 of solids at finite strain, lambda theta²/2 of linear ones.
class MeanPressures final : public MeanConstraints {
 public:
  MeanPressures(const Hyperelastic& table, const std::vector<double>& volume)
      : MeanConstraints(table, table.lame, volume, table.nodal_share) {}
  MeanPressures(const Elastic& table, const std::vector<double>& volume, std::span<const Vec3> rest)
      : MeanConstraints(table, table.lame, volume, table.nodal_share),
        rest_(rest),
        damping_time_(table.damping_time) {}

 private:
  Response respond(double swell) const noexcept override { return {swell, 1.0}; }
  double damping_time() const noexcept override { return damping_time_; }
  std::span<const Vec3> rest() const noexcept override { return rest_; }

  std::span<const Vec3> rest_;
  double damping_time_ = 0.0;
};

std::vector<RestTetrahedron> list_rest(const auto& table, std::span<const Vec3> rest) {
  std::vector<RestTetrahedron> tetrahedra;
  for (std::size_t t = 0; t < table.corners.size(); ++t) tetrahedra.emplace_back(table, t, rest);
  return tetrahedra;
}

std::vector<double> list_volumes(const std::vector<RestTetrahedron>& tetrahedra) {
  std::vector<double> volumes;
  for (const RestTetrahedron& each : tetrahedra) volumes.push_back(each.volume);
  return volumes;
}

/// dS/dx of the corners of a tetrahedron, S the symmetric part of AᵀF.
Block<6, 4> measure_strain(const RestTetrahedron& tetrahedron, const Mat3& a) noexcept {
  Block<6, 4> block;
  block.corners = tetrahedron.corners;
  for (int k = 0; k < 4; ++k) {
    block.gradient[k] =
        differentiate_strain(a, Vec3(tetrahedron.slopes.col(k) / tetrahedron.volume));
  }
  return block;
}

/// W V of every tetrahedron at finite strain as a function of the six numbers of its right stretch
/// S = RᵀF, whose slope is RᵀP, and its viscosity as one of Green's strain. What turns with S adds
/// nothing to the slope, and is left out of dS/dx [laws: xpbd].
template <class Density>
class StretchConstraints final : public Constraints {
 public:
  StretchConstraints(const Hyperelastic& table, std::span<const Vec3> rest)
      : table_(table),
        rest_(rest),
        tetrahedra_(list_rest(table, rest)),
        elastic_(table.corners.size()),
        viscous_(table.corners.size()) {}

  void reset() override {
    std::fill(elastic_.begin(), elastic_.end(), Six::Zero());
    std::fill(viscous_.begin(), viscous_.end(), Six::Zero());
  }

  void sweep(Particles& particles) override {
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      pull(t, particles);
      if (table_.viscosity[t] > 0.0) slow(t, particles);
    }
  }

 private:
  Mat3 deform(std::size_t t, const Particles& particles) const noexcept {
    const auto at = [&](int i) noexcept -> const Vec3& {
      return particles.position[static_cast<std::size_t>(i)];
    };
    return compute_deformation(tetrahedra_[t], rest_, at);
  }

  void pull(std::size_t t, Particles& particles) noexcept {
    const Mat3 f = deform(t, particles);
    const Mat3 rotation = compute_polar(f).rotation;
    const Moduli moduli = find_moduli(table_, t);
    const double volume = tetrahedra_[t].volume;
    Block<6, 4> block = measure_strain(tetrahedra_[t], rotation);
    block.slope = volume * write_column(rotation.transpose() * Density::compute_stress(f, moduli));
    block.curvature = volume * compute_stretch_hessian(Density(), rotation.transpose() * f, moduli);
    project(block, particles, elastic_[t]);
  }

  void slow(std::size_t t, Particles& particles) noexcept {
    Block<6, 4> block = measure_strain(tetrahedra_[t], deform(t, particles));
    block.damping.diagonal().setConstant(2.0 * table_.viscosity[t] * tetrahedra_[t].volume);
    project(block, particles, viscous_[t]);
  }

  const Hyperelastic& table_;
  std::span<const Vec3> rest_;
  std::vector<RestTetrahedron> tetrahedra_;
  std::vector<Six> elastic_, viscous_;
};

/// V (mu e:e + (1 - s) lambda theta²/2) of every tetrahedron of a linear solid.
class StrainConstraints final : public Constraints {
 public:
  StrainConstraints(const Elastic& table, std::span<const Vec3> rest)
      : table_(table),
        rest_(rest),
        tetrahedra_(list_rest(table, rest)),
        multiplier_(table.corners.size()) {}

  void reset() override { std::fill(multiplier_.begin(), multiplier_.end(), Six::Zero()); }

  void sweep(Particles& particles) override {
    const auto displacement = [&](int index) noexcept -> Vec3 {
      const auto i = static_cast<std::size_t>(index);
      return particles.position[i] - rest_[i];
    };
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      Block<6, 4> block = measure_strain(tetrahedra_[t], Mat3::Identity());
      const double lame = (1.0 - table_.nodal_share) * table_.lame[t];
      block.curvature = tetrahedra_[t].volume * compute_rest_hessian(Moduli{lame, table_.shear[t]});
      block.damping = table_.damping_time * block.curvature;
      block.slope = block.curvature * write_column(tetrahedra_[t].compute_gradient(displacement));
      project(block, particles, multiplier_[t]);
    }
  }

 private:
  const Elastic& table_;
  std::span<const Vec3> rest_;
  std::vector<RestTetrahedron> tetrahedra_;
  std::vector<Six> multiplier_;
};

template <class Density>
void add_hyperelastic(const Hyperelastic& table, std::span<const Vec3> rest, ConstraintList& list) {
  if (table.corners.empty()) return;
  list.push_back(std::make_unique<StretchConstraints<Density>>(table, rest));
  if (!(table.nodal_share > 0.0)) return;
  list.push_back(std::make_unique<MeanPressures>(table, list_volumes(list_rest(table, rest))));
}

}  // namespace

void add_solid_constraints(const TissueModel& model, ConstraintList& list) {
  const Vec3Array& rest = model.rest_position;
  const Volumes& volumes = model.volumes;
  if (!volumes.corners.empty()) {
    if (volumes.nodal_share < 1.0) list.push_back(std::make_unique<VolumeConstraints>(volumes));
    if (volumes.nodal_share > 0.0) list.push_back(std::make_unique<MeanVolumes>(volumes));
  }
  const Elastic& elastic = model.elastic;
  if (!elastic.corners.empty()) {
    list.push_back(std::make_unique<StrainConstraints>(elastic, rest));
    if (elastic.nodal_share > 0.0) {
      list.push_back(
          std::make_unique<MeanPressures>(elastic, list_volumes(list_rest(elastic, rest)), rest));
    }
  }
  add_hyperelastic<Corotated>(model.corotated, rest, list);
  add_hyperelastic<NeoHookean>(model.neo_hookean, rest, list);
}

}  // namespace palpate::xpbd
