// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/fcl.h>

#include <limits>

#include "peer.h"

namespace palpate::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

class Fcl : public Peer {
 public:
  explicit Fcl(const Workload& work) : model_(std::make_shared<Model>()) {
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : work.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                             static_cast<std::size_t>(c));
    }
    x_.assign(work.x.begin(), work.x.end());
    model_->beginModel();
    model_->addSubModel(x_, triangles);
    model_->endModel();
    surface_ = std::make_unique<fcl::CollisionObjectd>(model_);
    constexpr double kSpeck = 1e-7;
    speck_->beginModel();
    speck_->addTriangle({kSpeck, 0.0, 0.0}, {0.0, kSpeck, 0.0}, {0.0, 0.0, kSpeck});
    speck_->endModel();
  }

  std::string name() const override { return "FCL"; }
  std::string note(const std::string& work) const override {
    if (work == "segment") return "has no rays: a capsule of 1 nm; tells only whether it touches";
    if (work == "closest") return "distance to a triangle of 0.1 um; wrong to a ball as well";
    return work == "refit" ? "" : "contacts of a ball";
  }
  double tolerance() const override { return 1e-5; }
  std::size_t questions(const Workload& work) const override { return work.from.size() / 20; }

  void prepare(const Vec3Array& x) override { x_.assign(x.begin(), x.end()); }
  void refit() override {
    model_->beginReplaceModel();
    model_->replaceSubModel(x_);
    model_->endReplaceModel(true, true);
    surface_->computeAABB();
  }

  void segment(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      const Vec3 along = work.to[q] - work.from[q];
      fcl::Transform3d pose = fcl::Transform3d::Identity();
      pose.linear() = Quaternion::FromTwoVectors(Vec3::UnitZ(), along).toRotationMatrix();
      pose.translation() = 0.5 * (work.from[q] + work.to[q]);
      const fcl::CollisionObjectd capsule(std::make_shared<fcl::Capsuled>(1e-9, along.norm()),
                                          pose);
      fcl::CollisionRequestd request;
      fcl::CollisionResultd result;
      answers[q] = fcl::collide(surface_.get(), &capsule, request, result) > 0 ? 0.0 : -1.0;
    }
  }
  void closest(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      const fcl::CollisionObjectd point(speck_, at(work.beside[q]));
      const fcl::DistanceRequestd request;
      fcl::DistanceResultd result;
      answers[q] = fcl::distance(surface_.get(), &point, request, result);
    }
  }
  void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    const auto shape = std::make_shared<fcl::Sphered>(work.radius);
    for (std::size_t q = 0; q < count; ++q) {
      const fcl::CollisionObjectd ball(shape, at(work.beside[q]));
      const fcl::CollisionRequestd request(work.triangles.size(), true);
      fcl::CollisionResultd result;
      fcl::collide(surface_.get(), &ball, request, result);
      answers[q] = static_cast<double>(result.numContacts());
    }
  }

 private:
  static fcl::Transform3d at(const Vec3& p) {
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation() = p;
    return pose;
  }

  std::shared_ptr<Model> model_;
  std::shared_ptr<Model> speck_ = std::make_shared<Model>();
  std::unique_ptr<fcl::CollisionObjectd> surface_;
  std::vector<fcl::Vector3d> x_;
};

}  // namespace

std::unique_ptr<Peer> make_fcl(const Workload& work) { return std::make_unique<Fcl>(work); }

}  // namespace palpate::bench
