// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/import_mesh.h"

#include <stdexcept>

namespace palpate::authoring {
namespace {

/// Refuses what no tissue can be built on. `advice` says what else to try.
void validate_surface(const std::string& file, const ImportedMesh& organ,
                      const std::string& advice) {
  const MeshReport& report = organ.report;
  if (report.triangles == 0) {
    throw FileError(file, "", "no triangle that has an area", "a surface");
  }
  if (report.non_manifold_edges > 0) {
    throw FileError(file, "edges",
                    std::to_string(report.non_manifold_edges) + " with more than two triangles",
                    "at most two triangles at every edge" + advice);
  }
  if (!organ.repaired.orientable) {
    throw FileError(file, "", "a surface with one side only, like a Moebius band",
                    "one with an inside and an outside" + advice);
  }
  if (!report.self_intersecting_faces) {
    throw FileError(file, "faces", "so many on top of each other that counting was given up",
                    "a surface that does not cross itself" + advice);
  }
  const int most = static_cast<int>(kMostSelfIntersecting * report.triangles);
  if (*report.self_intersecting_faces > most) {
    throw FileError(file, "faces",
                    std::to_string(*report.self_intersecting_faces) + " of " +
                        std::to_string(report.triangles) + " that cross others",
                    "at most " + std::to_string(most) + advice);
  }
}

}  // namespace

ImportedMesh import_mesh(const std::filesystem::path& path, const ReadOptions& read,
                         const JoinOptions& join) {
  return import_scene(read_mesh(path, read), join);
}

ImportedMesh import_scene(const ImportedScene& scene, const JoinOptions& join) {
  ImportedMesh organ{};
  organ.joined = join_parts(scene, join);
  organ.repaired = repair_mesh(organ.joined.mesh);
  organ.mesh = organ.repaired.mesh;
  organ.report = inspect_mesh(organ.mesh);
  const bool nested = organ.joined.parts.size() > 1;
  validate_surface(scene.file, organ, nested ? "; fewer parts may do (--part)" : "");
  try {
    validate(organ.mesh);
  } catch (const std::invalid_argument& problem) {
    throw FileError(scene.file, "", problem.what(), "a surface a tissue can be built on");
  }
  return organ;
}

}  // namespace palpate::authoring
