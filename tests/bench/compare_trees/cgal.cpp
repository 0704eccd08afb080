// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "peer.h"

namespace palpate::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;

Kernel::Point_3 point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// CGAL's own test of a sphere against a triangle is of its shell; this one is of the ball.
class CountInBall {
 public:
  explicit CountInBall(const Traits& traits) : traits_(traits) {}
  bool go_further() const { return true; }
  void intersection(const Kernel::Sphere_3& ball, const Primitive& primitive) {
    const auto triangle = CGAL::internal::Primitive_helper<Traits>::get_datum(primitive, traits_);
    found_ += CGAL::squared_distance(ball.center(), triangle) <= ball.squared_radius();
  }
  bool do_intersect(const Kernel::Sphere_3& ball, const CGAL::AABB_node<Traits>& node) const {
    return CGAL::do_intersect(ball, node.bbox());
  }
  int found() const { return found_; }

 private:
  const Traits& traits_;
  int found_ = 0;
};

class Cgal : public Peer {
 public:
  explicit Cgal(const Workload& work) : corners_(work.triangles) {
    prepare(work.x);
    refit();
  }

  std::string name() const override { return "CGAL"; }
  std::string note(const std::string& work) const override {
    if (work == "refit") return "has none: a rebuild, with its hint tree for closest points";
    return work == "sphere" ? "our traversal: its own test is of the shell" : "";
  }
  double tolerance() const override { return 1e-9; }

  void prepare(const Vec3Array& x) override {
    triangles_.clear();
    for (const Triangle& t : corners_) {
      triangles_.emplace_back(point_of(x[static_cast<std::size_t>(t[0])]),
                              point_of(x[static_cast<std::size_t>(t[1])]),
                              point_of(x[static_cast<std::size_t>(t[2])]));
    }
  }
  void refit() override {
    tree_.clear();
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  void segment(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      const auto from = point_of(work.from[q]), to = point_of(work.to[q]);
      std::vector<Tree::Intersection_and_primitive_id<Kernel::Segment_3>::Type> hits;
      tree_.all_intersections(Kernel::Segment_3(from, to), std::back_inserter(hits));
      double first = -1.0;
      for (const auto& hit : hits) {
        const auto* at = boost::get<Kernel::Point_3>(&hit.first);
        if (at == nullptr) continue;
        const double distance = std::sqrt(CGAL::squared_distance(from, *at));
        if (first < 0.0 || distance < first) first = distance;
      }
      answers[q] = first;
    }
  }
  void closest(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      answers[q] = std::sqrt(tree_.squared_distance(point_of(work.beside[q])));
    }
  }
  void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      CountInBall counter(tree_.traits());
      const Kernel::Sphere_3 ball(point_of(work.beside[q]), work.radius * work.radius);
      tree_.traversal(ball, counter);
      answers[q] = counter.found();
    }
  }

 private:
  std::vector<Triangle> corners_;
  std::vector<Kernel::Triangle_3> triangles_;
  Tree tree_;
};

}  // namespace

std::unique_ptr<Peer> make_cgal(const Workload& work) { return std::make_unique<Cgal>(work); }

}  // namespace palpate::bench
