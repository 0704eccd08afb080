// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/collapse_edges.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

/// What a vertex stands for may spread over the surface this much more cheaply than it may leave
/// it, squared: some hundred vertices on an organ are spread evenly and still keep its ridges.
constexpr double kSpreadWeight = 1e-2;

/// How much more it costs to leave the border than the surface.
constexpr double kBorderWeight = 1.0;

/// The same of a line on the surface. A ridge keeps itself; the border of a region follows the
/// edges of the source to and fro, which no vertex is wanted for.
constexpr double kLineWeight = 1e-2;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;

Vec3 to_vec3(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }

/// The squared distances to planes and points, each times an area [m⁴]: x'A x + 2 b'x + c.
struct Quadric {
  Mat3 A = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0.0;

  void add_plane(const Vec3& normal, const Vec3& through, double area) {
    const double d = -normal.dot(through);
    A += area * normal * normal.transpose();
    b += area * d * normal;
    c += area * d * d;
  }

  void add_point(const Vec3& p, double area) {
    A += area * Mat3::Identity();
    b -= area * p;
    c += area * p.squaredNorm();
  }

  void add(const Quadric& other) {
    A += other.A;
    b += other.b;
    c += other.c;
  }

  double operator()(const Vec3& x) const { return x.dot(A * x) + 2.0 * b.dot(x) + c; }
};

/// The price of a collapse [m⁴], or that it is not allowed.
template <class MeshT>
class ModPrice : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModPrice, MeshT, Price)

  explicit ModPrice(MeshT& mesh) : Base(mesh, false) {}

  /// Before initialize(); what is given must stay.
  void keep(const FeatureLines& lines, std::span<const double> weights) {
    lines_ = lines.empty() ? nullptr : &lines;
    weights_ = weights;
    links_ = lines.links;
    for (const Line& line : lines.lines) left_.push_back(static_cast<int>(line.points.size()));
  }

  const std::vector<std::vector<int>>& links() const { return links_; }

  void initialize() override {
    Mesh& mesh = Base::mesh();
    // about the centre, where differences of squares lose the least
    centre_ = Vec3::Zero();
    for (const auto v : mesh.vertices()) centre_ += to_vec3(mesh.point(v));
    centre_ /= static_cast<double>(mesh.n_vertices());
    quadrics_.assign(mesh.n_vertices(), Quadric());
    for (const auto f : mesh.faces()) add_face(f);
    for (const auto h : mesh.halfedges()) {
      if (mesh.is_boundary(h)) add_border(mesh.opposite_halfedge_handle(h));
      if (is_on_line(h)) add_upright(h, kLineWeight);
    }
    for (const auto v : mesh.vertices()) {
      if (mesh.is_boundary(v)) keep_small_loop(v);
    }
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    if (!is_border_kept(collapse) || !is_line_kept(collapse.v0.idx(), collapse.v1.idx())) {
      return float(Base::ILLEGAL_COLLAPSE);
    }
    Quadric quadric = quadrics_[collapse.v0.idx()];
    quadric.add(quadrics_[collapse.v1.idx()]);
    return static_cast<float>(std::max(0.0, quadric(to_vec3(collapse.p1) - centre_)));
  }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    quadrics_[collapse.v1.idx()].add(quadrics_[collapse.v0.idx()]);
    if (Base::mesh().is_boundary(collapse.v1)) keep_small_loop(collapse.v1);
    shorten_line(collapse.v0.idx(), collapse.v1.idx());
  }

 private:
  Vec3 at(typename Mesh::VertexHandle v) { return to_vec3(Base::mesh().point(v)) - centre_; }

  void add_face(typename Mesh::FaceHandle f) {
    std::array<int, 3> corners;
    Vec3Array x;
    for (const auto v : Base::mesh().fv_range(f)) {
      corners[x.size()] = v.idx();
      x.push_back(at(v));
    }
    const Vec3 across = (x[1] - x[0]).cross(x[2] - x[0]);
    const double area = 0.5 * across.norm();
    const double weight = weights_.empty() ? 1.0 : weights_[static_cast<std::size_t>(f.idx())];
    for (std::size_t c = 0; c < corners.size(); ++c) {
      quadrics_[corners[c]].add_plane(across.normalized(), x[0], weight * area);
      quadrics_[corners[c]].add_point(x[c], kSpreadWeight * area / 3.0);
    }
  }

  bool is_on_line(typename Mesh::HalfedgeHandle h) {
    if (lines_ == nullptr) return false;
    const auto& links = links_[Base::mesh().from_vertex_handle(h).idx()];
    return std::ranges::find(links, Base::mesh().to_vertex_handle(h).idx()) != links.end();
  }

  /// A vertex of a line meets one of its neighbours on it, in a ring of three none.
  bool is_line_kept(int from, int to) const {
    if (lines_ == nullptr || lines_->line[from] == FeatureLines::kNone) return true;
    if (lines_->line[from] == FeatureLines::kCorner) return false;
    const auto& links = links_[from];
    if (std::ranges::find(links, to) == links.end()) return false;
    const int other = links[0] == to ? links[1] : links[0];
    return other != to && std::ranges::find(links_[other], to) == links_[other].end();
  }

  void shorten_line(int from, int to) {
    if (lines_ == nullptr || lines_->line[from] < 0) return;
    const int line = lines_->line[from];
    const int other = links_[from][0] == to ? links_[from][1] : links_[from][0];
    std::ranges::replace(links_[other], from, to);
    std::ranges::replace(links_[to], from, other);
    links_[from].clear();
    if (!lines_->lines[line].closed || --left_[line] > kSmallestLoop) return;
    int before = to, here = other;
    while (here != to) {
      Base::mesh().status(typename Mesh::VertexHandle(here)).set_locked(true);
      const int next = links_[here][0] == before ? links_[here][1] : links_[here][0];
      before = here;
      here = next;
    }
    Base::mesh().status(typename Mesh::VertexHandle(to)).set_locked(true);
  }

  void add_border(typename Mesh::HalfedgeHandle inner) {
    Mesh& mesh = Base::mesh();
    add_upright(inner, kBorderWeight);
    const auto from = mesh.from_vertex_handle(inner), to = mesh.to_vertex_handle(inner);
    // a border vertex has triangles on one side only; this makes up for the other
    const double missing = 0.25 * kSpreadWeight * (at(to) - at(from)).squaredNorm();
    for (const auto end : {from, to}) quadrics_[end.idx()].add_point(at(end), missing);
  }

  /// The plane through an edge of the border or of a line, upright on a triangle at it.
  void add_upright(typename Mesh::HalfedgeHandle inner, double weight) {
    Mesh& mesh = Base::mesh();
    const auto from = mesh.from_vertex_handle(inner), to = mesh.to_vertex_handle(inner);
    const auto apex = mesh.to_vertex_handle(mesh.next_halfedge_handle(inner));
    const Vec3 edge = at(to) - at(from);
    const Vec3 upright = edge.cross(edge.cross(at(apex) - at(from))).normalized();
    const double area = weight * edge.squaredNorm();
    for (const auto end : {from, to}) quadrics_[end.idx()].add_plane(upright, at(from), area);
  }

  bool is_border_kept(const CollapseInfo& collapse) {
    Mesh& mesh = Base::mesh();
    return !mesh.is_boundary(collapse.v0) || mesh.is_boundary(mesh.edge_handle(collapse.v0v1));
  }

  /// Prices of far edges are not asked for again when a loop has become small; locks are.
  void keep_small_loop(typename Mesh::VertexHandle v) {
    Mesh& mesh = Base::mesh();
    const auto first = mesh.halfedge_handle(v);  // of a border vertex: along the border
    std::vector<typename Mesh::VertexHandle> loop;
    auto h = first;
    do {
      loop.push_back(mesh.to_vertex_handle(h));
      h = mesh.next_halfedge_handle(h);
    } while (h != first && static_cast<int>(loop.size()) <= kSmallestLoop);
    if (static_cast<int>(loop.size()) > kSmallestLoop) return;
    for (const auto u : loop) mesh.status(u).set_locked(true);
  }

  Vec3 centre_ = Vec3::Zero();
  std::vector<Quadric> quadrics_;
  const FeatureLines* lines_ = nullptr;
  std::span<const double> weights_;
  std::vector<std::vector<int>> links_;
  std::vector<int> left_;  // vertices of each line
};

Mesh to_open_mesh(const SurfaceMesh& from) {
  Mesh mesh;
  mesh.request_face_normals();
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  std::vector<Mesh::VertexHandle> handles;
  for (const Vec3& x : from.vertices) handles.push_back(mesh.add_vertex({x.x(), x.y(), x.z()}));
  for (const Triangle& t : from.triangles) {
    if (!mesh.add_face(handles[t[0]], handles[t[1]], handles[t[2]]).is_valid()) {
      throw std::invalid_argument(
          "mesh: surfaces touch in vertices without an edge between them; expected them apart, as "
          "repair_mesh makes them");
    }
  }
  mesh.update_face_normals();
  return mesh;
}

SurfaceMesh to_surface_mesh(const Mesh& from) {
  SurfaceMesh mesh;
  for (const auto v : from.vertices()) mesh.vertices.push_back(to_vec3(from.point(v)));
  for (const auto f : from.faces()) {
    Triangle t;
    int c = 0;
    for (const auto v : from.fv_range(f)) t[c++] = v.idx();
    mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace

SurfaceMesh collapse_edges(const SurfaceMesh& mesh, int vertex_count) {
  return collapse_edges(mesh, vertex_count, FeatureLines{}, {}).mesh;
}

CollapsedMesh collapse_edges(const SurfaceMesh& mesh, int vertex_count, const FeatureLines& lines,
                             std::span<const double> weights) {
  Mesh working = to_open_mesh(mesh);
  OpenMesh::VPropHandleT<int> source;
  working.add_property(source);
  for (const auto v : working.vertices()) working.property(source, v) = v.idx();
  Decimater decimater(working);
  ModPrice<Mesh>::Handle price;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(price);
  decimater.add(flipping);
  decimater.module(flipping).set_max_normal_deviation(90.0);
  if (!lines.empty() || !weights.empty()) decimater.module(price).keep(lines, weights);
  if (!decimater.initialize()) throw std::logic_error("decimater: modules do not fit together");
  decimater.decimate_to(static_cast<std::size_t>(vertex_count));
  const auto links = decimater.module(price).links();
  working.garbage_collection();
  std::vector<int> left;
  for (const auto v : working.vertices()) left.push_back(working.property(source, v));
  return {to_surface_mesh(working), lines.empty() ? FeatureLines{} : renumber(lines, links, left)};
}

}  // namespace palpate::authoring
