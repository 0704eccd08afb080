// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

/// What of a scene a surface is of.
enum class ScenePart {
  body,     ///< of Scene::bodies
  scenery,  ///< of Scene::scenery
  rigid,    ///< of Scene::rigid
};

/// A point of a surface of a scene, found by a query.
struct ScenePoint {
  ScenePart part = ScenePart::body;
  int index = 0;                ///< of that kind
  int triangle = -1;            ///< row of its surface
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitZ();  ///< [-] unit, smooth, outward
  double distance = 0.0;        ///< [m] from where the query began
};

/// All that a hand may meet in a scene: bodies and scenery at rest, and rigid bodies where they
/// were placed last, at first where the scene has them. Where two are equally far, the first in the
/// order bodies, scenery, rigid bodies is found.
class SceneSurfaces {
 public:
  /// The scene need not outlive it.
  explicit SceneSurfaces(const Scene& scene);

  std::size_t rigid_count() const noexcept { return surfaces_.size() - first_rigid_; }

  /// Allocates nothing. The orientation is of norm 1.
  void place_rigid(std::size_t index, const Vec3& position, const Quaternion& orientation) noexcept;

  /// The first surface along a ray; none where the ray meets that from inside, as nothing behind it
  /// is in sight. `direction` of any length but zero.
  std::optional<ScenePoint> find_ray_hit(const Vec3& origin, const Vec3& direction) const noexcept;

  /// The nearest point of bodies, scenery and one rigid body, or none of them for -1.
  std::optional<ScenePoint> find_closest_point(const Vec3& p, int rigid = -1) const noexcept;

 private:
  struct Surface {
    ScenePart part;
    int index;
    Vec3Array x, normals;  // [m], [-] in its own frame
    AabbTree tree;
    Vec3 position = Vec3::Zero();
    Quaternion orientation = Quaternion::Identity();
  };

  void add(ScenePart part, std::size_t index, Vec3Array x, const std::vector<Triangle>& triangles);
  ScenePoint place(const Surface& surface, const SurfacePoint& found) const noexcept;

  std::vector<Surface> surfaces_;  // bodies, scenery, rigid bodies; those without triangles too
  std::size_t first_rigid_ = 0;
};

/// How a hand gets to its goal.
enum class PointerPath {
  along,     ///< over the surface at rest, at the depth that is asked for
  around,    ///< straight, but around the organ: where it would come below it, along the surface
  straight,  ///< straight, the tissue it holds with it
};

/// What a window wants of the hand.
struct PointerTarget {
  double time = 0.0;         ///< [s] of the event that led to it, by the window's clock
  Vec3 goal = Vec3::Zero();  ///< [m] a point of the surface at rest, or beside it
  double depth = 0.0;        ///< [m] of the tip below the goal; negative above it
  PointerPath path = PointerPath::along;
  bool pressing = false;     ///< a button is down: the hand presses for as long as it was
  std::uint8_t buttons = 0;  ///< of the sample, once the tip has been where it began for a moment
  Quaternion orientation = Quaternion::Identity();  ///< unit, of the sample, at 3 rad/s at most
  int rigid = -1;  ///< the rigid body that the goal is of, and where it is now; -1: of none
  Vec3 rigid_position = Vec3::Zero();                     ///< [m] of its frame
  Quaternion rigid_orientation = Quaternion::Identity();  ///< unit, of its frame
};

/// A hand that a window moves over a surface: post() from the GUI thread, read() from the haptic
/// thread, which moves the hand. How often the window finds time to post, and how long it takes for
/// a picture, makes no difference to what is felt.
///
/// The surface is that of all bodies and scenery at rest, and of the rigid body that the window
/// names, where it says that this is. The hand goes over it at 250 mm/s at most and into it at 50
/// mm/s, the middle of its tip on the smooth normal there, and turns by 3 rad/s at most. Over the
/// path between two posts it takes the time that lay between them. A press that was over before the
/// haptic thread heard of it lasts as long as the window says that it did.
class SurfacePointer : public HapticDevice {
 public:
  /// Surfaces and tool are those of a scene, which need not outlive the hand; it begins over a
  /// body. Throws std::out_of_range for a body or an instrument that it does not have.
  explicit SurfacePointer(const Scene& scene, std::size_t body = 0, std::size_t instrument = 0);

  /// One calling thread. Throws std::invalid_argument for a number that is not finite, an
  /// orientation not of norm 1 and a rigid body that the scene does not have.
  void post(const PointerTarget& target);
  HapticSample read(double time) noexcept override;
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "pointer"; }

 private:
  struct Post {
    PointerTarget target;
    long number = 0;   // of all posts
    long gesture = 0;  // of all presses and releases
  };
  struct Foot {
    Vec3 point = Vec3::Zero();    // [m] of the surface, nearest to where it was asked for
    Vec3 normal = Vec3::UnitZ();  // smooth, outward
    double height = 0.0;          // [m] above the surface of where it was asked for
  };

  void follow_posts(double time) noexcept;
  void begin_gesture(const Post& post, double time) noexcept;
  void take(const Post& post) noexcept;
  void follow(const Post& post) noexcept;
  const PointerTarget& aim() const noexcept;
  Vec3 find_displacement() const noexcept;
  void walk(double dt) noexcept;
  void watch_progress(double length, double step) noexcept;
  Vec3 step_along(const Vec3& displacement, double step, bool keeps) noexcept;
  void sink(double dt) noexcept;
  void hold(double dt) noexcept;
  void glide(double time, double dt) noexcept;
  void turn(double dt) noexcept;
  Foot find_foot(const Vec3& p) const noexcept;

  // constant
  double radius_;  // [m] of the tip

  // the window's own
  Post posted_;

  // between the threads
  Latest<Post> newest_;
  Ring<Post> gestures_;

  // the haptic thread's own, but for how many there are
  SceneSurfaces surfaces_;
  Post current_;
  PointerTarget touch_;           // where the gesture began
  double began_ = 0.0;            // [s] by the time of the run
  double speed_ = 0.0;            // [m/s] of the walk
  Foot foot_;                     // of base_
  Vec3 base_ = Vec3::Zero();      // [m] where the tip would touch the surface
  Vec3 outward_ = Vec3::UnitZ();  // unit, from there to the middle of the tip
  double depth_ = 0.0;            // [m]
  double still_ = 0.0;            // [s] for which the tip has been where it should
  bool coming_ = false, attached_ = false;
  bool bypassing_ = false;       // the straight path ended in a hollow
  double nearest_ = 0.0;         // [m] to the goal, when progress was measured last
  double walked_ = 0.0;          // [m] since
  Vec3 heading_ = Vec3::Zero();  // unit, of the bypass
  HapticSample hand_;            // as read last
};

}  // namespace palpate
