// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

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
};

/// A hand that a window moves over a surface: post() from the GUI thread, read() from the haptic
/// thread, which moves the hand. How often the window finds time to post, and how long it takes for
/// a picture, makes no difference to what is felt.
///
/// The hand goes over the surface at rest at 250 mm/s at most and into it at 50 mm/s, the middle of
/// its tip on the smooth normal there, and turns by 3 rad/s at most. Over the path between two
/// posts it takes the time that lay between them. A press that was over before the haptic thread
/// heard of it lasts as long as the window says that it did.
class SurfacePointer : public HapticDevice {
 public:
  /// The surface and the tool are those of a scene, which need not outlive the hand.
  /// Throws std::out_of_range for a body or an instrument that it does not have.
  explicit SurfacePointer(const Scene& scene, std::size_t body = 0, std::size_t instrument = 0);

  /// One calling thread. Throws std::invalid_argument for a number that is not finite.
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
  Vec3Array x_, normals_;
  AabbTree tree_;
  double radius_;  // [m] of the tip

  // the window's own
  Post posted_;

  // between the threads
  Latest<Post> newest_;
  Ring<Post> gestures_;

  // the haptic thread's own
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
