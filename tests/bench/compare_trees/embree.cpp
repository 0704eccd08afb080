// SPDX-License-Identifier: BSD-3-Clause
#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>
#include <utility>

#include "peer.h"

namespace palpate::bench {
namespace {

using Point = Eigen::Vector3f;

/// The closest point of a triangle as in most programs [Ericson04], in float like all of Embree.
Point find_closest(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return a;
  const Point bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0f && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return a + d1 / (d1 - d3) * ab;
  const Point cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0f && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const float share = 1.0f / (va + vb + vc);
  return a + vb * share * ab + vc * share * ac;
}

class Embree : public Peer {
 public:
  Embree(const Workload& work, std::string name, RTCBuildQuality quality)
      : name_(std::move(name)), triangles_(work.triangles), device_(rtcNewDevice("threads=1")) {
    if (device_ == nullptr) throw std::runtime_error("embree: no device");
    scene_ = rtcNewScene(device_);
    // only a scene of low quality refits: it keeps a tree per geometry, of the geometry's quality
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry_, quality);
    vertices_ = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Point), work.x.size()));
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), triangles_.size()));
    for (const Triangle& t : triangles_) {
      for (const int i : t) *corners++ = static_cast<unsigned>(i);
    }
    prepare(work.x);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
  }
  ~Embree() override {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  std::string name() const override { return name_; }
  std::string note(const std::string& work) const override {
    if (work == "refit") {
      return name_ == "Embree low" ? "a rebuild by Morton codes" : "positions already in float";
    }
    return work == "segment" ? "" : "our callback per triangle";
  }
  double tolerance() const override { return 1e-6; }

  void prepare(const Vec3Array& x) override {
    for (std::size_t i = 0; i < x.size(); ++i) corner(i) = x[i].cast<float>();
  }
  void refit() override {
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  void segment(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t q = 0; q < count; ++q) {
      const Point from = work.from[q].cast<float>();
      const Point along = work.to[q].cast<float>() - from;
      RTCRayHit ray{};
      ray.ray = {from.x(),  from.y(), from.z(), 0.0f, along.x(), along.y(),
                 along.z(), 0.0f,     1.0f,     ~0u,  0,         0};
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &ray);
      const bool hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      answers[q] = hit ? double(ray.ray.tfar) * double(along.norm()) : -1.0;
    }
  }
  void closest(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      asked_ = {this, work.beside[q].cast<float>(), std::numeric_limits<float>::infinity(), 0};
      ask(std::numeric_limits<float>::infinity(), &visit_closest);
      answers[q] = asked_.nearest;
    }
  }
  void sphere(const Workload& work, std::size_t count, std::vector<double>& answers) override {
    for (std::size_t q = 0; q < count; ++q) {
      asked_ = {this, work.beside[q].cast<float>(), static_cast<float>(work.radius), 0};
      ask(asked_.nearest, &visit_sphere);
      answers[q] = asked_.found;
    }
  }

 private:
  struct Asked {
    Embree* self;
    Point p;
    float nearest;
    int found;
  };

  Eigen::Map<Point> corner(std::size_t i) { return Eigen::Map<Point>(vertices_ + 3 * i); }

  void ask(float radius, RTCPointQueryFunction visit) {
    RTCPointQuery query{asked_.p.x(), asked_.p.y(), asked_.p.z(), 0.0f, radius};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, visit, &asked_);
  }

  static float measure(const Asked& asked, unsigned triangle) {
    const Triangle& t = asked.self->triangles_[triangle];
    const Point a = asked.self->corner(static_cast<std::size_t>(t[0])),
                b = asked.self->corner(static_cast<std::size_t>(t[1])),
                c = asked.self->corner(static_cast<std::size_t>(t[2]));
    return (find_closest(asked.p, a, b, c) - asked.p).norm();
  }
  static bool visit_closest(RTCPointQueryFunctionArguments* given) {
    auto& asked = *static_cast<Asked*>(given->userPtr);
    const float distance = measure(asked, given->primID);
    if (distance >= asked.nearest) return false;
    asked.nearest = distance;
    given->query->radius = distance;
    return true;
  }
  static bool visit_sphere(RTCPointQueryFunctionArguments* given) {
    auto& asked = *static_cast<Asked*>(given->userPtr);
    asked.found += measure(asked, given->primID) <= asked.nearest;
    return false;
  }

  std::string name_;
  std::vector<Triangle> triangles_;
  RTCDevice device_;
  RTCScene scene_;
  RTCGeometry geometry_;
  float* vertices_ = nullptr;
  Asked asked_{};
};

}  // namespace

std::unique_ptr<Peer> make_embree_refit(const Workload& work) {
  return std::make_unique<Embree>(work, "Embree refit", RTC_BUILD_QUALITY_REFIT);
}

std::unique_ptr<Peer> make_embree_low(const Workload& work) {
  return std::make_unique<Embree>(work, "Embree low", RTC_BUILD_QUALITY_LOW);
}

}  // namespace palpate::bench
