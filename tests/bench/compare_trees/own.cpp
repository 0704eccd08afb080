// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tree/queries.h"
#include "peer.h"

namespace palpate::bench {
namespace {

class Own : public Peer {
 public:
  explicit Own(const Workload& work)
      : tree_(work.x, work.triangles), found_(work.triangles.size()) {
    prepare(work.x);
  }

  std::string name() const override { return "Palpate"; }
  std::string note(const std::string&) const override { return ""; }
  double tolerance() const override { return 1e-12; }

  void prepare(const Vec3Array& x) override { x_ = x; }
  void refit() override { tree_.refit(x_); }

  void segment(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      const auto hit = find_segment_hit(tree_, x_, work.from[q], work.to[q]);
      answers[q] = hit ? hit->distance : -1.0;
    }
  }
  void closest(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      answers[q] = find_closest_point(tree_, x_, work.beside[q])->distance;
    }
  }
  void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      answers[q] = find_in_sphere(tree_, x_, work.beside[q], work.radius, found_);
    }
  }

 private:
  AabbTree tree_;
  Vec3Array x_;
  std::vector<int> found_;
};

}  // namespace

std::unique_ptr<Peer> make_own(const Workload& work) { return std::make_unique<Own>(work); }

}  // namespace palpate::bench
