// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/write_mesh.h"

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "palpate/authoring/file_signature.h"
#include "palpate/sim/base/private/whole_file.h"

namespace palpate::authoring {
namespace {

std::string format_obj(const SurfaceMesh& mesh) {
  std::string text = std::string("# ") + kFileSignature + "\n";
  char line[128];
  for (const Vec3& x : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x.x(), x.y(), x.z());
    text += line;
  }
  for (const Triangle& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

std::string format_stl(const SurfaceMesh& mesh) {
  std::string bytes(kFileSignature);
  bytes.resize(80, ' ');
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    for (const Vec3& v : {normal, a, b, c}) {
      for (int i = 0; i < 3; ++i) put(static_cast<float>(v[i]));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh) {
  const std::string extension = path.extension().string();
  if (extension != ".obj" && extension != ".stl") {
    throw std::invalid_argument(path.string() + ": extension must be .obj or .stl, got '" +
                                extension + "'");
  }
  validate(mesh);
  const std::string bytes = extension == ".obj" ? format_obj(mesh) : format_stl(mesh);
  WholeFile file(path.string());
  file.write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  file.commit();
}

}  // namespace palpate::authoring
