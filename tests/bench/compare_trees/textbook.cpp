// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/naive_tree.h"
#include "peer.h"

namespace palpate::bench {
namespace {

class Textbook : public Peer {
 public:
  explicit Textbook(const Workload& work)
      : tree_(work.x, work.triangles), found_(work.triangles.size()) {
    prepare(work.x);
  }

  std::string name() const override { return "textbook"; }
  std::string note(const std::string&) const override { return "two boxes a node, plain double"; }
  double tolerance() const override { return 0.0; }

  void prepare(const Vec3Array& x) override { x_ = x; }
  void refit() override { tree_.refit(x_); }

  void segment(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      const auto hit = tree_.find_segment_hit(x_, work.from[q], work.to[q]);
      answers[q] = hit ? hit->distance : -1.0;
    }
  }
  void closest(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      answers[q] = tree_.find_closest_point(x_, work.beside[q])->distance;
    }
  }
  void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      answers[q] = tree_.find_in_sphere(x_, work.beside[q], work.radius, found_);
    }
  }

 private:
  NaiveTree tree_;
  Vec3Array x_;
  std::vector<int> found_;
};

}  // namespace

std::unique_ptr<Peer> make_textbook(const Workload& work) {
  return std::make_unique<Textbook>(work);
}

}  // namespace palpate::bench
