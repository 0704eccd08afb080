// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The contact law is a barrier: 1 - depth/radius, down to this. 0.1 lets nothing
/// through, 0.2 already leaks, and less only asks for more substeps [contact: law].
inline constexpr double kBarrierFloor = 0.1;

/// Part of the radius below which the arm from the closest point to the centre is rounding, and
/// its direction noise.
inline constexpr double kNoArm = 1e-9;

/// Cosine between arm and normal from which a contact counts in full.
inline constexpr double kFullFacing = 0.25;

/// sin² of the angle between a capsule's axis and an edge below which they count as parallel.
inline constexpr double kParallel = 1e-12;

/// sin² of the angle between a jaw's axis and an edge within which the point that is pressed goes
/// from end to end of the edge, on either side of parallel [contact: spread].
inline constexpr double kJawSpread = 0.1;

/// The contact of a tip at `centre` with the triangle a, b, c of `rest_area` [m²]; false where
/// there is none, or where the centre lies behind the triangle.
bool find_contact(const Tool& tool, double rest_area, const Vec3& centre, const Vec3& a,
                  const Vec3& b, const Vec3& c, Contact& contact) noexcept;

/// The same of a capsule of the tool whose axis goes from `from` to `to` [m].
bool find_capsule_contact(const Tool& tool, double rest_area, const Vec3& from, const Vec3& to,
                          const Vec3& a, const Vec3& b, const Vec3& c, Contact& contact) noexcept;

/// [m] The point of a triangle with these barycentric weights.
inline Vec3 compute_point(const Triangle& t, const Vec3& weights,
                          std::span<const Vec3> x) noexcept {
  return weights[0] * x[static_cast<std::size_t>(t[0])] +
         weights[1] * x[static_cast<std::size_t>(t[1])] +
         weights[2] * x[static_cast<std::size_t>(t[2])];
}

/// A symmetric tensor: xx, yy, zz, xy, yz, zx.
using Symmetric = std::array<double, 6>;

/// What a body's tissue does near a ball, and what its mesh does of that already: with it a ball is
/// felt as on tissue, however large the triangles are beside it [contact: near field].
struct NearField {
  double modulus = 0.0;  ///< [Pa] E* = E / (1 - nu²), positive

  // each (n,) per vertex of the surface
  std::vector<double> far_compliance;  ///< [m/N] of the body beyond that of a half space
  /// [m/N] the same in every direction, where it was given; else empty
  std::vector<Symmetric> far_tensor;
  std::vector<double> curvature;  ///< [1/m] of the surface at rest, positive where it is convex
  /// [m] at rest, where a ball is to feel how curved the facets under it are [contact: facets], and
  /// not `curvature`; else empty
  Vec3Array rest_position;

  // the compliance of the mesh, along normals: of vertex v under a force on neighbour[k] it is
  // compliance[k] [m/N], k from first[v] up to first[v + 1]
  std::vector<int> first;         ///< (n + 1,)
  std::vector<int> neighbour;     ///< ascending
  std::vector<float> compliance;  ///< [m/N]

  double wall_thickness = 0.0;  ///< [m] of prisms; 0 of a solid

  /// What a tool takes hold of gives way as a disc that is tied to such tissue [contact: hold], and
  /// not as the vertices it is fastened to.
  bool ties_holds = false;
};

/// The near field of a model touched by balls of up to `radius` [m]: solves for a unit force on
/// each vertex of the surface about the model at rest and keeps what that does where such a ball
/// may press as well. The far compliance is `far` [m/N], one tensor per vertex of a solid's
/// surface; where there is none, what a wide patch of this mesh is moved beyond a half space, along
/// the normal; of a wall of prisms, what it is moved at a point beyond that. With `facets` a ball
/// feels how curved those under it are. Throws std::invalid_argument for a modulus [Pa] or radius
/// that is not positive, another number of far compliances, and those, or `facets`, of a wall.
NearField build_near_field(const TissueModel& model, double modulus, double radius,
                           std::span<const Symmetric> far = {}, bool facets = false);

/// The hand's spring: what pulls the tool to where the device is.
struct Coupling {
  double stiffness = 500.0;  ///< [N/m] K of Eq 12
  double force_max = 5.0;    ///< [N]
};

/// Moves the massless tool to where the hand's spring and the tissue's pushes cancel, and writes
/// those pushes into `load` (its pushes are replaced).
///
/// Contact t pushes with f = k_A A_t depth / max(0.1, 1 - depth/radius) along the line from its
/// closest point to the tool's centre; contacts whose centre lies behind their triangle are
/// dropped. Three Newton steps of a 3x3 system, each going at most half the way to any surface it
/// nears, so that the tool's own motion never takes it through. Returns the force on the hand, K
/// (tool - hand), limited to force_max: f = -K x, Eq 12. With tool.friction the tool is carried
/// with the tissue it touches, and slides on it where the hand pulls along the surface with more
/// than mu times the contact force [contact: friction]. state.residual is what the steps leave:
/// the pushes on the tissue sum to -(force + residual). Where nothing touches the tool is at the
/// hand and the force is exactly zero.
Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  Candidates& candidates, std::span<const Triangle> triangles,
                  std::span<const Vec3> x, ToolState& state, Load& load) noexcept;

/// Fastens the tool to the patch it touches, shares weighted by contact force; `stiffness` [N/m]
/// in all. Does nothing, and returns false, when it touches nothing. Offsets are chosen so that
/// the holds exert no force at the moment of attaching; under a near field that ties holds, the
/// force of the pressures, which they take over. A tool that is attached stays as it is.
bool attach_tool(const Load& contacts, std::span<const Triangle> triangles, std::span<const Vec3> x,
                 double stiffness, ToolState& state) noexcept;

void release_tool(ToolState& state) noexcept;

/// Largest extra eigenvalue [1/s²] that contacts and holds may add to M⁻¹K: the row-sum bound
/// max over particles of sum k_t w / m [contact: substeps]. For choosing this tick's substeps.
/// `body` tells which holds are on this surface, `near` under which law it is touched; `coupling`
/// [N/m] is the hand's spring, which friction passes on to the tissue.
double bound_contact_stiffness(const Tool& tool, const Candidates& candidates,
                               std::span<const Triangle> triangles, std::span<const Vec3> x,
                               std::span<const double> mass, const ToolState& state,
                               std::span<double> scratch, int body = 0,
                               const NearField* near = nullptr, double coupling = 0.0) noexcept;

}  // namespace palpate
