// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

struct TissueModel;

// Two jaws that close on tissue: contact surfaces with a limited closing force, and friction by an
// anchor for each triangle [contact: jaws].

/// The surfaces of all bodies as each jaw may touch them: with candidates of its own, and one load.
using JawSurfaces = std::array<std::span<const TouchedSurface>, 2>;

/// [rad] No farther do jaws turn in one substep, and no farther in a tick.
inline constexpr double kMostTurn = 2.5e-3, kMostTurnInTick = 0.03;

/// [rad] Over which the closing force rises to its limit.
inline constexpr double kGripRise = 0.02;

/// [rad/s] At which a hinge resists as much as its jaws close with at most. Without mass and
/// resistance tissue throws them about, and is thrown about by them [contact: jaws].
inline constexpr double kHingeRate = 20.0;

/// Tissue between two jaws, as far as the mesh does not resist: a layer of that thickness [m] at
/// rest, and the pressure [Pa] by which it resists being pressed to half of it.
inline constexpr double kLayer = 2e-3, kLayerPressure = 2e4;

/// Part of its thickness to which a layer is pressed; there it resists as much as it can.
inline constexpr double kLayerFloor = 0.1;

/// Of a bristle's stiffness over that of the contact, 2 (1 - nu)/(2 - nu) of incompressible tissue
/// and a rigid tool, doubled: slip is to begin before the patch has changed [contact: jaws].
inline constexpr double kBristle = 3.0;

/// [-] Of smooth jaws on wet tissue, 0.11 [Heijnsdijk04]: of a jaw's back and sides, and of a pad
/// that nothing presses against from the other one.
inline constexpr double kSmoothFriction = 0.1;

/// Cosine of a contact's direction and that in which its jaw opens: below the first it is one of
/// the jaw's back, above the second of its pad.
inline constexpr double kPadEdge = -0.25, kPadFace = 0.25;

/// Jaws that are open by an angle, in the directions of the scene and about the tool's position.
class OpenJaws {
 public:
  OpenJaws(const Tool& tool, const Quaternion& orientation, double angle) noexcept;

  const Shape& shape(int jaw) const noexcept { return shapes_[static_cast<std::size_t>(jaw)]; }
  const Capsule& axis_of(int jaw) const noexcept { return shape(jaw).axes.capsules[0]; }
  double angle() const noexcept { return angle_; }

  /// [m/rad] How a point of a jaw, `at` [m] off the tool's position, moves as the jaws open.
  Vec3 move(int jaw, const Vec3& at) const noexcept {
    return (jaw == 0 ? 1.0 : -1.0) * axis_.cross(at - hinge_);
  }
  /// [m] Off the tool's position, of a point that is given in the tool's frame with closed jaws.
  Vec3 to_scene(int jaw, const Vec3& place) const noexcept;
  Vec3 to_jaw(int jaw, const Vec3& at) const noexcept;

  void open(double angle) noexcept;

 private:
  const Tool& tool_;
  Quaternion orientation_;
  std::array<Shape, 2> shapes_;
  std::array<Quaternion, 2> turns_;  // of each jaw from where it is closed, in the tool's frame
  Vec3 hinge_, axis_;
  double angle_ = 0.0;
};

/// [m] From the hinge to the middle of a jaw.
double measure_arm(const Tool& tool) noexcept;

/// What presses on one jaw.
struct Pressed {
  double force = 0.0;      ///< [N] sum over its contacts
  double at = 0.0;         ///< [N m] of the places along its capsule, from its first end
  double spread = 0.0;     ///< [N m²] of their squares
  double modulus = 0.0;    ///< [N Pa] of the layer that belongs to them
  double thickness = 0.0;  ///< [N m]
  double pad = 0.0;        ///< [N] of contacts on its pad
};

/// The layer between two jaws: how hard it is pressed, and how that grows.
struct Squeeze {
  double force = 0.0;   ///< [N] on each jaw
  double torque = 0.0;  ///< [N m] that opens them
  double slope = 0.0;   ///< [N m/rad] by which that falls as they open
};

Squeeze find_squeeze(const Tool& tool, const OpenJaws& jaws,
                     const std::array<Pressed, 2>& pressed) noexcept;

/// [-] Coulomb's coefficient of the tool on one of the surfaces.
inline double find_friction(const Tool& tool, std::span<const TouchedSurface> surfaces,
                            int body) noexcept {
  return tool.friction * surfaces[static_cast<std::size_t>(body)].friction_part;
}

/// The part of a contact's force on a jaw that sticks by the coefficient mu. A profile holds what
/// lies between both pads, as hard as the one that is pressed less; all else slides on smooth
/// metal. `opens` is the cosine of its direction and that in which the jaw opens there.
double find_grip(double mu, const std::array<Pressed, 2>& pressed, double layer, int jaw,
                 double opens) noexcept;

/// The part of a contact that is on the pad.
inline double find_pad_part(double opens) noexcept {
  return std::clamp((opens - kPadEdge) / (kPadFace - kPadEdge), 0.0, 1.0);
}

/// [m²] The variance along a unit direction of the points of a triangle, whose pressure is alike.
double find_extent(const Triangle& t, std::span<const Vec3> x, const Vec3& along) noexcept;

/// [m²] Of a pad that is touched: `extent` [N m²] is that of the triangles, each times its force.
double find_covered(const Tool& tool, const Pressed& pressed, double extent = 0.0) noexcept;

/// The springs of all anchors, about where tool and jaws are as a substep begins: affine in both.
struct AnchorSprings {
  Vec3 force = Vec3::Zero();      ///< [N] on the tool
  double torque = 0.0;            ///< [N m] that opens the jaws
  Mat3 stiffness = Mat3::Zero();  ///< [N/m]
  Vec3 mixed = Vec3::Zero();      ///< [N/rad]
  double angular = 0.0;           ///< [N m/rad]
};

AnchorSprings find_anchor_springs(const Tool& tool, const OpenJaws& jaws,
                                  std::span<const TouchedSurface> surfaces,
                                  const ToolState& state) noexcept;

/// A contact of a jaw, in order of jaw, body and triangle.
struct JawContact {
  int jaw = 0, body = 0, triangle = 0;
  Vec3 weights = Vec3::Zero();
  double pressed = 0.0;  ///< [N] the layer's part included
};

/// Begins a substep's end: no anchor has been pressed yet.
void unpress_anchors(ToolState& state) noexcept;

/// Presses the anchor of a contact, which is made where there is none among the first `sorted`,
/// those of the substep before.
void press_anchor(const Tool& tool, const OpenJaws& jaws, std::span<const TouchedSurface> surfaces,
                  const JawContact& contact, int sorted, ToolState& state) noexcept;

/// Lets those go that nothing presses any more, and writes what the others do into the loads.
/// Returns the sum on the tool [N].
Vec3 pull_anchors(const Tool& tool, const OpenJaws& jaws, std::span<const TouchedSurface> surfaces,
                  int sorted, ToolState& state) noexcept;

/// Moves a massless tool with jaws to where hand, jaws and tissue balance in a substep of dt [s];
/// as balance_tool(). What is felt falls below ToolState::felt_before by no more than `most_fall`
/// [N], where that is not 0.
Vec3 balance_jaws(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  const JawSurfaces& surfaces, double dt, ToolState& state,
                  double most_fall = 0.0) noexcept;

/// add_shape_rows() of one jaw of an instrument; the anchors of both count with the first.
void add_jaw_rows(const Tool& tool, int jaw, const TouchableSurface& surface,
                  const ToolState& state, double coupling, ContactRows& rows) noexcept;

/// Row sums of M⁻¹K of the particles under a skin, whose vertices hang on few of them.
struct ParticleRows {
  const TissueModel& tissue;
  std::span<double> sums;  ///< [N/m] per particle, 0 where nothing was added
  double largest = 0.0;    ///< [1/s²]

  void add(int triangle, const Vec3& weights, double stiffness) noexcept;
};

/// add_jaw_rows() of both jaws on a body under a skin: by what is touched alone.
void add_jaws_on_skin(const Tool& tool, const JawSurfaces& surfaces, int body,
                      const ToolState& state, ParticleRows& rows) noexcept;

}  // namespace palpate
