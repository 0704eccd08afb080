// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "workload.h"

namespace palpate::bench {

/// A library's tree over the surface of a workload. Each question is asked of `count` places in a
/// row and answered into a list, so that no call can be left out.
class Peer {
 public:
  virtual ~Peer() = default;

  virtual std::string name() const = 0;
  /// How each kind of work is done where that is not the library's own call.
  virtual std::string note(const std::string& work) const = 0;

  /// The library's way to follow the surface to positions it has been given before.
  virtual void prepare(const Vec3Array& x) = 0;
  virtual void refit() = 0;
  /// [m] from where a segment begins to the first triangle on it, 0 where the library only tells
  /// that there is one; -1 where there is none.
  virtual void segment(const Workload& work, std::size_t count, std::vector<double>& answers) = 0;
  /// [m] to the closest point.
  virtual void closest(const Workload& work, std::size_t count, std::vector<double>& answers) = 0;
  /// Triangles with a point in the ball.
  virtual void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) = 0;

  /// Questions that are enough to time it by: less for those that take milliseconds each.
  virtual std::size_t questions(const Workload& work) const { return work.from.size(); }
  /// [m] How far its distances may lie from the textbook's.
  virtual double tolerance() const = 0;
};

std::unique_ptr<Peer> make_own(const Workload& work);
/// The textbook tree of palpate::bench: what the others' answers are held against.
std::unique_ptr<Peer> make_textbook(const Workload& work);
std::unique_ptr<Peer> make_embree_refit(const Workload& work);
std::unique_ptr<Peer> make_embree_low(const Workload& work);
std::unique_ptr<Peer> make_cgal(const Workload& work);
std::unique_ptr<Peer> make_fcl(const Workload& work);

}  // namespace palpate::bench
