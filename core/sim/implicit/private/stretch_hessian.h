// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>

#include "palpate/sim/dynamics/private/hyperelastic_law.h"
#include "palpate/sim/implicit/private/strain.h"

namespace palpate {

/// [Pa] d²W/dS² of the laws of tetrahedra at S = I, which is Hooke's law.
inline Mat6 compute_rest_hessian(const Moduli& moduli) noexcept {
  const Six one = write_column(Mat3::Identity());
  return 2.0 * moduli.shear * Mat6::Identity() + moduli.lame * one * one.transpose();
}

inline Mat6 compute_stretch_hessian(const Corotated&, const Mat3&, const Moduli& moduli) noexcept {
  return compute_rest_hessian(moduli);
}

/// With W of NeoHookean and cof S = S² - tr(S) S + II I,
///
///     4/3 mu I/(I + 1) 1 + 8/3 mu/(I + 1)² S Sᵀ + k cof S cof Sᵀ + (k (J - 1) - mu) d cof S/dS
///
/// where that is definite, and the Hessian at rest elsewhere.
inline Mat6 compute_stretch_hessian(const NeoHookean&, const Mat3& s,
                                    const Moduli& moduli) noexcept {
  const double square = s.squaredNorm(), more = square + 1.0, mu = moduli.shear;
  const Mat3 cofactor = compute_cofactor(s);
  const double k = NeoHookean::find_bulk(moduli);
  const double pressure = k * (s.col(0).dot(cofactor.col(0)) - 1.0) - mu;
  const Six stretch = write_column(s), areas = write_column(cofactor);
  Mat6 hessian = (8.0 * mu / (3.0 * more * more)) * stretch * stretch.transpose() +
                 k * areas * areas.transpose();
  hessian.diagonal().array() += 4.0 * mu * square / (3.0 * more);
  for (int c = 0; c < 6; ++c) {
    const Mat3 d = write_unit(c);
    const Mat3 turned = s * d;
    const double grown = s.trace() * d.trace() - s.cwiseProduct(d).sum();
    hessian.col(c) += pressure * write_column(turned + turned.transpose() - d.trace() * s -
                                              s.trace() * d + grown * Mat3::Identity());
  }
  return hessian.llt().info() == Eigen::Success ? hessian : compute_rest_hessian(moduli);
}

}  // namespace palpate
