// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/remesh_surface.h"

#include <algorithm>
#include <cmath>

#include "palpate/authoring/cgal/remesh_faces.h"
#include "palpate/authoring/improve_triangles.h"
#include "palpate/authoring/source_surface.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::authoring {
namespace {

/// Of the edge lengths of neighbouring bands: triangles between them keep their shape.
constexpr double kBand = 1.4;

void check_lengths(const SurfaceMesh& mesh, std::span<const double> lengths) {
  if (lengths.size() != mesh.vertices.size()) {
    refuse("remesh: edge_lengths", write_text(lengths.size(), " of them"),
           write_text("one for each of ", mesh.vertices.size(), " vertices"));
  }
  for (const double length : lengths) {
    if (!(length > 0.0) || !std::isfinite(length)) {
      refuse("remesh: edge_lengths", write_text(length, " m"), "a positive length");
    }
  }
  double count = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double length = std::min({lengths[t[0]], lengths[t[1]], lengths[t[2]]});
    // an even triangle has an area of sqrt(3)/4 of its edge squared
    count += 0.5 * (b - a).cross(c - a).norm() / (std::sqrt(3.0) / 4.0 * length * length);
  }
  if (count > kMostRemeshed) {
    refuse("remesh: edge_lengths", write_text("about ", std::round(count), " triangles"),
           write_text("edges so long that at most ", kMostRemeshed, " come"));
  }
}

/// The edge length that is asked for at a point: that of the source's point next to it.
class Lengths {
 public:
  Lengths(const SurfaceMesh& mesh, std::span<const double> lengths)
      : mesh_(mesh), lengths_(lengths), source_(mesh) {}

  double operator()(const Vec3& p) const {
    const auto [point, triangle] = source_.find_closest(p);
    const Triangle& t = mesh_.triangles[triangle];
    double sum = 0.0, weights = 0.0;
    for (int c = 0; c < 3; ++c) {
      const Vec3 &a = mesh_.vertices[t[(c + 1) % 3]], &b = mesh_.vertices[t[(c + 2) % 3]];
      const double weight = (a - point).cross(b - point).norm();
      sum += weight * lengths_[t[c]];
      weights += weight;
    }
    return weights > 0.0 ? sum / weights : lengths_[t[0]];
  }

 private:
  const SurfaceMesh& mesh_;
  std::span<const double> lengths_;
  SourceSurface source_;
};

/// The triangles at whose middle edges of at most `length` are asked for.
std::vector<char> choose(const SurfaceMesh& mesh, const Lengths& asked, double length) {
  std::vector<char> chosen(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    chosen[i] = asked(middle) <= length;
  }
  return chosen;
}

}  // namespace

SurfaceMesh remesh_surface(const SurfaceMesh& mesh, std::span<const double> edge_lengths) {
  validate(mesh);
  check_lengths(mesh, edge_lengths);
  const auto [least, most] = std::minmax_element(edge_lengths.begin(), edge_lengths.end());
  SurfaceMesh made =
      remesh_faces(mesh, std::vector<char>(mesh.triangles.size(), 1), *most, kSharpEdge);
  const int bands = static_cast<int>(std::ceil(std::log(*most / *least) / std::log(kBand) - 1e-9));
  if (bands == 0) return made;
  const Lengths asked(mesh, edge_lengths);
  const double ratio = std::pow(*least / *most, 1.0 / bands);
  for (int band = 1; band <= bands; ++band) {
    const double length = *most * std::pow(ratio, band);
    // to the middle between this band and the one before
    made = remesh_faces(made, choose(made, asked, length / std::sqrt(ratio)), length, kSharpEdge);
  }
  // where bands meet there are slivers
  improve_triangles(mesh, SourceSurface(mesh), {}, made);
  return made;
}

}  // namespace palpate::authoring
