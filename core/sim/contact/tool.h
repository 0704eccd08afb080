// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "palpate/sim/base/types.h"

namespace palpate {

/// All points within the tool's radius of a segment, which is given in the tool's frame.
struct Capsule {
  Vec3 from = Vec3::Zero();  ///< [m]
  Vec3 to = Vec3::Zero();    ///< [m]
};

inline constexpr int kMostCapsules = 8;

/// Two jaws on one hinge, which close on what lies between them with a limited force: of a tool of
/// two capsules, each of them a jaw where it is closed. The first opens by turning about `axis`,
/// the second the other way [contact: jaws].
struct Jaws {
  Vec3 hinge = Vec3(0.0, 0.0, 0.0225);  ///< [m] a point of the axis, in the tool's frame
  Vec3 axis = Vec3::UnitX();            ///< unit
  double open = 0.52;                   ///< [rad] the farthest that each jaw turns
  double grip = 5.0;         ///< [N] that each closes with at most, at the middle of its capsule
  double pad_area = 5.1e-5;  ///< [m²] of the side of each that holds
};

/// What of the instrument touches, never a point: a ball, or a rigid list of capsules.
struct Tool {
  double radius = 0.003;   ///< [m] of the ball, or of every capsule
  double stiffness = 3e7;  ///< [N/m³] k_A: pressure per depth of the contact law
  double friction = 0.0;   ///< [-] Coulomb's coefficient mu between tip and tissue; 0: it slides
  std::vector<Capsule> capsules = {};  ///< at most kMostCapsules; none: a ball about the position
  std::optional<Jaws> jaws = {};       ///< of two capsules; none: what touches is rigid
};

/// Where the tool is (the paper's ideal tip, IUN) and what it is fastened to.
struct ToolState {
  /// A patch of tissue that the tool pulls on by a bilateral spring: click and hold.
  struct Hold {
    int triangle = 0;
    Vec3 weights = Vec3::Zero();  ///< barycentric
    double stiffness = 0.0;       ///< [N/m] of a tied one along its normal
    Vec3 offset = Vec3::Zero();   ///< [m] tool minus patch point where it has no force
    int body = 0;                 ///< whose triangle: which of the surfaces that may be touched

    // of one that gives way as the tissue under it does [contact: hold]
    Vec3 normal = Vec3::Zero();  ///< unit; zero of one that does not
    double sideways = 0.0;       ///< [N/m] across the normal, at most `stiffness`

    bool is_tied() const noexcept { return sideways > 0.0; }

    /// [N] on the tool where it is stretched by s [m]: patch point plus offset minus tool.
    Vec3 pull(const Vec3& s) const noexcept {
      if (!is_tied()) return stiffness * s;
      return sideways * s + (stiffness - sideways) * normal.dot(s) * normal;
    }

    /// [m] by which it is stretched under a pull f [N].
    Vec3 stretch(const Vec3& f) const noexcept {
      if (!is_tied()) return f / stiffness;
      return f / sideways + (1.0 / stiffness - 1.0 / sideways) * normal.dot(f) * normal;
    }
  };

  /// The surface nearest to the tool after the last substep; the tool rides on its motion.
  struct Carrier {
    int triangle = -1;              ///< -1 when nothing is touched
    Vec3 weights = Vec3::Zero();    ///< barycentric, of the closest point
    Vec3 point = Vec3::Zero();      ///< [m] where that was
    Vec3 direction = Vec3::Zero();  ///< unit, from there to the tool's centre
    int body = 0;                   ///< whose triangle
  };

  /// A point of the tissue that was touched in the last substep. Friction carries the tool with
  /// the mean of them.
  struct PatchPoint {
    int triangle = 0;
    int body = 0;                 ///< whose triangle
    Vec3 weights = Vec3::Zero();  ///< barycentric
    double share = 0.0;           ///< [-] of the contact force, sum 1
  };

  /// Where tissue sticks to a jaw: a point of a triangle and a point of the jaw, drawn together
  /// along the surface by a spring that slips at mu times what presses there [contact: jaws].
  struct Anchor {
    int triangle = 0;
    int body = 0;                 ///< whose triangle
    int jaw = 0;                  ///< 0 or 1: which capsule's
    Vec3 weights = Vec3::Zero();  ///< barycentric
    Vec3 place = Vec3::Zero();    ///< [m] of the jaw's point, in the tool's frame with jaws closed
    double pressed = 0.0;         ///< [N] there in the last substep
    double stiffness = 0.0;       ///< [N/m] of the spring
  };

  /// `patch_capacity` is for a tool with friction: how many triangles it may touch at once;
  /// `anchor_capacity` for one with friction and jaws, of both.
  explicit ToolState(int capacity = 0, int patch_capacity = 0, int anchor_capacity = 0)
      : holds(static_cast<std::size_t>(capacity)),
        patch(static_cast<std::size_t>(patch_capacity)),
        anchors(static_cast<std::size_t>(anchor_capacity)) {}

  Vec3 position = Vec3::Zero();                     ///< [m]
  Quaternion orientation = Quaternion::Identity();  ///< unit, of the tool's frame
  bool placed = false;      ///< false until the first sample has put it somewhere
  std::vector<Hold> holds;  ///< capacity
  int hold_count = 0;       ///< 0 when nothing is attached
  Carrier carrier;
  bool touching = false;         ///< any contact in force in the last substep
  Vec3 residual = Vec3::Zero();  ///< [N] left between hand and tissue after the last substep

  bool turn_limited = false;  ///< tissue keeps it from turning as its hand does, in this tick
  /// [N m] on the tool about its position, of the contacts and holds of the last substep; of a tool
  /// with capsules
  Vec3 torque = Vec3::Zero();

  // of a tool with friction, after the last substep
  std::vector<PatchPoint> patch;       ///< patch_capacity
  int patch_count = 0;                 ///< 0 when nothing is touched
  Vec3 patch_position = Vec3::Zero();  ///< [m] where the mean of its points was
  Vec3 patch_normal = Vec3::Zero();    ///< unit, in which the contacts together push the tool
  Vec3 friction = Vec3::Zero();        ///< [N] on the tool

  // of a tool with jaws, after the last substep
  double jaw_angle = 0.0;       ///< [rad] by which each jaw is open
  double jaw_wanted = 0.0;      ///< [rad] by which the hand would have it open
  double grip_limit = 0.0;      ///< [N] up to which it closes now: Jaws::grip, less as it lets go
  double pinch = 0.0;           ///< [N] that each jaw presses with, the mean of both
  double pad_pressure = 0.0;    ///< [Pa] of that on what is touched of a pad
  Vec3 carried = Vec3::Zero();  ///< [N] on the tool, of all anchors: what it holds up
  std::vector<Anchor> anchors;  ///< anchor_capacity
  int anchor_count = 0;         ///< 0 where nothing sticks
  double held_load = 0.0;       ///< [N] that they carry, each whatever its direction
  bool pinches = false;         ///< tissue sticks to both jaws
  double felt_change = 0.0;     ///< [N] no more does what is felt change in this tick; 0: any
  Vec3 felt_before = Vec3::Zero();  ///< [N] what was felt in the tick before, for that

  /// Something follows the tool: it is fastened, or pinched.
  bool has_hold() const noexcept { return hold_count > 0 || pinches; }
};
static_assert(alignof(ToolState) == 8);

}  // namespace palpate
