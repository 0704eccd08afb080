// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/surface_pointer.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/limit.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

constexpr double kWalkSpeed = 0.25;    // [m/s] faster, and the hand would knock on the tissue
constexpr double kSinkSpeed = 0.05;    // [m/s] a firm touch
constexpr double kGlideTime = 15e-3;   // [s] in which corners of the path are rounded off
constexpr double kFastestGlide = 1.0;  // [m/s]
constexpr double kFastestTurn = 3.0;   // [rad/s]

/// [s] Where ticks are missed the hand falls behind and does not hurry: a longer path in one tick
/// asks for more substeps, and those would cost the next ticks too. Into the tissue it goes so
/// slowly that it may make up more.
constexpr double kLongestWalk = 1.5e-3, kLongestSink = 5e-3;

/// [s] between two posts that count as one movement.
constexpr double kShortestInterval = 8e-3, kLongestInterval = 0.2;

constexpr double kStillTime = 0.05;  // [s] between the arrival of the tip and its grip
constexpr double kNear = 1e-3;       // [m] from its goal the hand has come
constexpr double kThere = 1e-5;      // [m]
/// [m] of the walk in which the goal should have come nearer by a share [-] of it; after a lap [m]
/// around the organ that led nowhere, the bypass takes another direction.
constexpr double kPatience = 0.01, kLeastGain = 0.2, kLap = 0.3;
constexpr std::size_t kGestures = 64;
constexpr double kStart = 0.01;  // [m] over the highest vertex, before anything was asked for

void require_unit(const char* where, const Quaternion& turn) {
  if (!(std::abs(turn.norm() - 1.0) < 1e-6)) {
    refuse(where, write_text("a quaternion of norm ", turn.norm()), "a unit one");
  }
}

double share_of(double dt) noexcept { return 1.0 - std::exp(-dt / kGlideTime); }

}  // namespace

SurfacePointer::SurfacePointer(const Scene& scene, std::size_t body, std::size_t instrument)
    : radius_(scene.instruments.at(instrument).tool.radius),
      gestures_(kGestures),
      surfaces_(scene) {
  const TissueModel& tissue = scene.bodies.at(body).tissue;
  const Vec3Array x = compute_surface(tissue, tissue.rest_position);
  base_ = *std::max_element(x.begin(), x.end(),
                            [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  depth_ = -kStart;
  hand_.position = base_ + outward_ * (radius_ - depth_);
}

void SurfacePointer::post(const PointerTarget& target) {
  if (!std::isfinite(target.time) || !target.goal.allFinite() || !std::isfinite(target.depth)) {
    refuse("pointer: time, goal or depth", "a number that is not finite", "finite ones");
  }
  require_unit("pointer: orientation", target.orientation);
  const auto rigid_count = static_cast<int>(surfaces_.rigid_count());
  if (target.rigid < -1 || target.rigid >= rigid_count) {
    refuse("pointer: rigid", write_text(target.rigid), write_text("-1 to ", rigid_count - 1));
  }
  if (!target.rigid_position.allFinite()) {
    refuse("pointer: rigid_position", "a number that is not finite", "finite ones");
  }
  require_unit("pointer: rigid_orientation", target.rigid_orientation);
  const bool turns = posted_.number == 0 || target.pressing != posted_.target.pressing;
  posted_ = {target, posted_.number + 1, posted_.gesture + (turns ? 1 : 0)};
  // where there is no room for it, nobody reads, and the newest is all that will count
  if (turns) gestures_.push(posted_);
  newest_.back() = posted_;
  newest_.publish();
}

HapticSample SurfacePointer::read(double time) noexcept {
  const double dt = std::max(0.0, time - hand_.time);
  follow_posts(time);
  if (current_.number > 0) {
    walk(dt);
    sink(dt);
    hold(dt);
    turn(dt);
  }
  glide(time, dt);
  return hand_;
}

/// Every press and release in its turn, and of what lies between them the newest.
void SurfacePointer::follow_posts(double time) noexcept {
  newest_.take();  // first: then the gestures that came before it can be seen
  while (const Post* next = gestures_.front()) {
    const double lasted = next->target.time - touch_.time;
    if (current_.target.pressing && time - began_ < lasted) return;
    begin_gesture(*next, time);
    gestures_.pop();
  }
  const Post& newest = newest_.front();
  if (newest.number <= current_.number) return;
  if (newest.gesture > current_.gesture) {  // the ring had no room for it
    begin_gesture(newest, time);
  } else {
    follow(newest);
  }
}

/// The rigid body under the pointer, where the window saw it last.
void SurfacePointer::take(const Post& post) noexcept {
  current_ = post;
  const PointerTarget& target = post.target;
  if (target.rigid < 0) return;
  surfaces_.place_rigid(static_cast<std::size_t>(target.rigid), target.rigid_position,
                        target.rigid_orientation);
}

void SurfacePointer::begin_gesture(const Post& post, double time) noexcept {
  const bool is_first = current_.number == 0;
  take(post);
  if (is_first) {  // it is there at once
    foot_ = find_foot(post.target.goal);
    base_ = post.target.goal;
    outward_ = foot_.normal;
    depth_ = post.target.depth;
    hand_.position = base_ + outward_ * (radius_ - depth_);
  }
  touch_ = post.target;
  began_ = time;
  speed_ = kWalkSpeed;
  coming_ = true;
  attached_ = false;
  still_ = 0.0;
  bypassing_ = false;
  nearest_ = find_displacement().norm();
  walked_ = 0.0;
}

/// The window will post again after about the same time, and until then the hand is on its way:
/// it neither hurries and waits in turn nor falls behind.
void SurfacePointer::follow(const Post& post) noexcept {
  const double interval =
      std::clamp(post.target.time - current_.target.time, kShortestInterval, kLongestInterval);
  const double before = find_displacement().norm();
  take(post);
  const double length = find_displacement().norm();
  speed_ = coming_ ? kWalkSpeed : std::min(kWalkSpeed, length / interval);
  if (!bypassing_) nearest_ += length - before;
}

/// What shall be pulled is first taken hold of.
const PointerTarget& SurfacePointer::aim() const noexcept {
  return current_.target.buttons != 0 && !attached_ ? touch_ : current_.target;
}

Vec3 SurfacePointer::find_displacement() const noexcept { return aim().goal - base_; }

void SurfacePointer::walk(double dt) noexcept {
  const PointerTarget& target = aim();
  const Vec3 displacement = find_displacement();
  const double length = displacement.norm();
  const double step = std::min(length, speed_ * std::min(dt, kLongestWalk));
  if (target.path == PointerPath::straight) {
    base_ += limit(displacement, step);
  } else if (step > 0.0) {
    // a tip in the tissue stays as deep as it is; one in the air may cut across a hollow
    const bool keeps = target.path == PointerPath::along && !coming_ && target.depth > 0.0;
    if (!keeps && target.path == PointerPath::along) watch_progress(length, step);
    base_ = step_along(displacement, step, keeps || bypassing_);
  }
  if (find_displacement().norm() < kNear) coming_ = false;
  // beside the organ the tip keeps its side: the pointer stays on its middle
  const double reach = target.path == PointerPath::along ? 2.0 * radius_ : 0.0;
  if (target.path != PointerPath::straight && foot_.height <= reach) {
    const Vec3 turned = outward_ + (foot_.normal - outward_) * share_of(dt);
    if (turned.norm() > 0.1) outward_ = turned.normalized();
  }
}

/// Where the goal lies behind a hollow the straight path ends in it. Then the hand goes straight on
/// over the surface until the goal is nearer than it was there.
void SurfacePointer::watch_progress(double length, double step) noexcept {
  walked_ += step;
  if (bypassing_) {
    if (length < nearest_ - kNear) {
      bypassing_ = false;
      nearest_ = length;
      walked_ = 0.0;
    } else if (walked_ > kLap) {
      heading_ = foot_.normal.cross(heading_);
      walked_ = 0.0;
    }
    return;
  }
  if (walked_ < kPatience) return;
  if (nearest_ - length < kLeastGain * walked_ && foot_.height < kNear) {
    bypassing_ = true;
    heading_ = foot_.normal.unitOrthogonal();
  }
  nearest_ = length;
  walked_ = 0.0;
}

/// A step of the walk. Over the surface it goes where the straight path would be seen from above,
/// so that it gets around the organ; the surface then draws it back.
Vec3 SurfacePointer::step_along(const Vec3& displacement, double step, bool keeps) noexcept {
  Vec3 direction = bypassing_ ? heading_ : Vec3(displacement.normalized());
  const double dips = direction.dot(foot_.normal);
  const bool on_surface = foot_.height < step;
  if (bypassing_ || (on_surface && dips < 0.0 && step < displacement.norm())) {
    Vec3 flat = direction - dips * foot_.normal;
    if (flat.norm() < 1e-3) {  // straight through: to the far side any way leads
      if (aim().path == PointerPath::around) return base_;
      flat = foot_.normal.unitOrthogonal();
    }
    direction = flat.normalized();
    heading_ = direction;
  }
  const Vec3 next = base_ + direction * step;
  foot_ = find_foot(next);
  if (foot_.height > 0.0 && !keeps) return next;
  // two steps at most: what comes out of the air, or was pulled far inside, does not leap
  return base_ + limit(foot_.point - base_, 2.0 * step);
}

void SurfacePointer::sink(double dt) noexcept {
  const double wanted = coming_ ? std::min(depth_, aim().depth) : aim().depth;
  const double most = kSinkSpeed * std::min(dt, kLongestSink);
  depth_ += std::clamp(wanted - depth_, -most, most);
}

void SurfacePointer::hold(double dt) noexcept {
  const PointerTarget& target = current_.target;
  if (attached_ || target.buttons == 0) return;
  const Vec3 goal = touch_.goal + outward_ * (radius_ - touch_.depth);
  const bool there = !coming_ && (hand_.position - goal).norm() < 0.1 * radius_;
  still_ = there ? still_ + dt : 0.0;
  attached_ = still_ >= kStillTime;
}

void SurfacePointer::turn(double dt) noexcept {
  const Quaternion& wanted = current_.target.orientation;
  const Quaternion before = hand_.orientation;
  const double angle = before.angularDistance(wanted);
  const double most = kFastestTurn * std::min(dt, kLongestSink);
  hand_.orientation = wanted;
  if (angle > most) hand_.orientation = before.slerp(most / angle, wanted).normalized();
}

/// The corners of the path are rounded off, or the tissue would feel every one of them.
void SurfacePointer::glide(double time, double dt) noexcept {
  const Vec3 last = hand_.position;
  if (current_.number > 0) {
    const Vec3 displacement = base_ + outward_ * (radius_ - depth_) - last;
    const Vec3 part = limit(displacement * share_of(std::min(dt, kLongestSink)),
                            kFastestGlide * std::min(dt, kLongestWalk));
    // the last nanometre at once: a hand that rests must not creep for ever
    hand_.position = displacement.norm() < 1e-9 ? Vec3(last + displacement) : Vec3(last + part);
  }
  hand_.time = time;
  hand_.velocity = dt > 0.0 ? Vec3((hand_.position - last) / dt) : Vec3(Vec3::Zero());
  hand_.buttons = attached_ ? current_.target.buttons : std::uint8_t{0};
}

SurfacePointer::Foot SurfacePointer::find_foot(const Vec3& p) const noexcept {
  const auto found = surfaces_.find_closest_point(p, current_.target.rigid);
  if (!found) return foot_;
  const bool above = (p - found->point).dot(found->normal) > 0.0;
  return {found->point, found->normal, above ? found->distance : -found->distance};
}

}  // namespace palpate
