// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "palpate/authoring/run_reader.h"
#include "palpate/authoring/scene_stream.h"

namespace palpate::authoring {
namespace {

/// Of palpate-read-mesh; who has another reader tells the format.
constexpr std::array kFormats = {"OBJ", "STL", "PLY", "GLB", "GLTF", "3DS", "FBX", "DAE",
                                 "OFF", "X3D", "3MF", "AMF", "AC",   "X",   "LWO"};

/// Of volumes of voxels, of which a surface is yet to be cut.
constexpr std::array kVolumes = {"NII", "GZ", "NRRD", "NHDR", "MHA", "MHD", "DCM"};
constexpr std::uintmax_t kMostFileBytes = 1'000'000'000;

std::string find_format(const std::filesystem::path& path) {
  std::string format = path.extension().string();
  if (!format.empty()) format.erase(0, 1);
  for (char& c : format) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (format == "VTI" || std::find(kVolumes.begin(), kVolumes.end(), format) != kVolumes.end()) {
    throw FileError(path.string(), "", "a volume of voxels",
                    format == "VTI" ? "a surface: palpate segment cuts one out of the volume once "
                                      "it is saved as .nrrd, .mha or .vtk"
                                    : "a surface: palpate segment cuts one out of a volume");
  }
  if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end()) {
    throw FileError(
        path.string(), "name",
        format.empty() ? "no extension" : "the extension " + path.extension().string(),
        "a mesh file: .obj .stl .ply .off .glb .gltf .3ds .fbx .dae .x3d .3mf .amf .ac .x .lwo "
        ".vtk .vtp .vtu .vts .vtm .xdmf .xmf .neu .cas .msh .mesh .meshb .vol .veg .node .ele "
        ".face .smesh .poly .pts .elem .inp .unv .feb .bdf .nas .fem .k .key .dyn .gii .mz3 .wrl "
        ".wrz .iv .pial .white .inflated .orig .smoothwm");
  }
  return format;
}

void validate_file(const std::filesystem::path& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) {
    throw FileError(path.string(), "", "no such file", "a mesh file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw FileError(path.string(), "", "something that is not a regular file", "a mesh file");
  }
  const auto size = std::filesystem::file_size(path, problem);
  if (problem) throw FileError(path.string(), "", problem.message(), "a readable mesh file");
  if (size == 0) throw FileError(path.string(), "", "0 bytes", "a mesh file");
  if (size > kMostFileBytes) {
    throw FileError(path.string(), "", std::to_string(size) + " bytes", "at most 1 GB");
  }
}

bool is_finite(const Vec3& x) { return x.allFinite(); }

void validate_part(const std::string& file, const ImportedPart& part) {
  const auto& vertices = part.mesh.vertices;
  for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
    for (const int corner : part.mesh.triangles[t]) {
      if (corner >= 0 && static_cast<std::size_t>(corner) < vertices.size()) continue;
      throw FileError(file, "part '" + part.name + "', triangle " + std::to_string(t),
                      "vertex " + std::to_string(corner),
                      "an index below " + std::to_string(vertices.size()));
    }
  }
}

/// Refuses paint that is of other triangles or pictures than the file's.
void validate_paint(const ImportedScene& scene, const ImportedPart& part) {
  const std::size_t count = part.mesh.triangles.size();
  const bool fits = part.paint.empty()
                        ? part.pictures.empty()
                        : part.paint.size() == 3 * count && part.pictures.size() == count;
  const auto is_known = [&](int picture) {
    return picture >= -1 && picture < static_cast<int>(scene.pictures.size());
  };
  if (fits && std::all_of(part.pictures.begin(), part.pictures.end(), is_known)) return;
  throw FileError(scene.file, "part '" + part.name + "'", "colours of other triangles",
                  "three for each");
}

/// Takes paint off where a number of it is none.
void drop_wrong_paint(ImportedPart& part) {
  const auto is_wrong = [](const CornerPaint& p) {
    return !std::isfinite(p.place[0] + p.place[1] + p.colour[0] + p.colour[1] + p.colour[2]);
  };
  if (std::none_of(part.paint.begin(), part.paint.end(), is_wrong)) return;
  part.paint.clear();
  part.pictures.clear();
}

/// Vertices that lie nowhere, and the triangles on them.
struct Nowhere {
  int vertices = 0, triangles = 0;
  std::string first;  ///< of them, with its part
};

void drop_nowhere(ImportedPart& part, Nowhere& dropped) {
  SurfaceMesh& mesh = part.mesh;
  const std::string& name = part.name;
  if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_finite)) return;
  std::vector<int> place;
  Vec3Array kept;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const bool keep = is_finite(mesh.vertices[i]);
    if (!keep && ++dropped.vertices == 1) {
      dropped.first = "part '" + name + "', vertex " + std::to_string(i);
    }
    place.push_back(keep ? static_cast<int>(kept.size()) : -1);
    if (keep) kept.push_back(mesh.vertices[i]);
  }
  mesh.vertices = std::move(kept);
  for (Triangle& t : mesh.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  const auto is_nowhere = [](const Triangle& t) { return t[0] < 0 || t[1] < 0 || t[2] < 0; };
  std::size_t left = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_nowhere(mesh.triangles[t])) continue;
    if (!part.paint.empty()) {
      for (std::size_t c = 0; c < 3; ++c) part.paint[3 * left + c] = part.paint[3 * t + c];
      part.pictures[left] = part.pictures[t];
    }
    mesh.triangles[left++] = mesh.triangles[t];
  }
  dropped.triangles += static_cast<int>(mesh.triangles.size() - left);
  mesh.triangles.resize(left);
  if (!part.paint.empty()) {
    part.paint.resize(3 * left);
    part.pictures.resize(left);
  }
}

/// Leaves out what lies nowhere, and says so. Refuses a file of which nothing is left.
void drop_nowhere(ImportedScene& scene) {
  Nowhere dropped;
  for (ImportedPart& part : scene.parts) drop_nowhere(part, dropped);
  std::erase_if(scene.parts, [](const ImportedPart& p) { return p.mesh.triangles.empty(); });
  if (scene.parts.empty()) {
    throw FileError(scene.file, dropped.first, "a coordinate that is not a finite number",
                    "finite coordinates");
  }
  if (dropped.vertices > 0) {
    scene.notes.push_back(std::to_string(dropped.vertices) +
                          " vertices without finite coordinates were left out, with " +
                          std::to_string(dropped.triangles) + " triangles on them; the first is " +
                          dropped.first);
  }
  const Vec3Array& filled = scene.filling.vertices;
  if (!std::all_of(filled.begin(), filled.end(), is_finite)) {
    scene.filling = {};
    scene.notes.emplace_back("its tetrahedra were left out: a coordinate is not a finite number");
  }
}

void validate_filling(const std::string& file, const SolidMesh& filling) {
  const auto count = static_cast<int>(filling.vertices.size());
  for (std::size_t t = 0; t < filling.tetrahedra.size(); ++t) {
    for (const int corner : filling.tetrahedra[t]) {
      if (corner >= 0 && corner < count) continue;
      throw FileError(file, "tetrahedron " + std::to_string(t), "vertex " + std::to_string(corner),
                      "an index below " + std::to_string(count));
    }
  }
}

}  // namespace

ImportedScene read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  if (!(options.time_limit > 0.0 && options.time_limit <= 3600.0)) {
    throw std::invalid_argument("read_mesh: time_limit must be above 0 and at most 3600 s, got " +
                                std::to_string(options.time_limit));
  }
  if (options.memory_limit == 0) {
    throw std::invalid_argument("read_mesh: memory_limit must be positive, got 0");
  }
  validate_file(path);
  const std::string format = options.format.empty() ? find_format(path) : options.format;

  ImportedScene scene = decode_scene(path.string(), run_reader(path, format, options));
  scene.format = format;
  std::erase_if(scene.parts, [](const ImportedPart& p) { return p.mesh.triangles.empty(); });
  if (scene.parts.empty()) {
    throw FileError(scene.file, "", "no triangles", "a surface made of triangles or polygons");
  }
  for (ImportedPart& part : scene.parts) {
    validate_part(scene.file, part);
    validate_paint(scene, part);
    drop_wrong_paint(part);
  }
  validate_filling(scene.file, scene.filling);
  drop_nowhere(scene);
  return scene;
}

}  // namespace palpate::authoring
