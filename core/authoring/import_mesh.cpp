// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/import_mesh.h"

namespace palpate::authoring {

ImportedMesh import_scene(const ImportedScene& scene, const JoinOptions& join) {
  ImportedMesh organ{};
  organ.joined = join_parts(scene, join);
  organ.repaired = repair_mesh(organ.joined.mesh);
  organ.mesh = organ.repaired.mesh;
  if (organ.mesh.triangles.empty()) {
    throw FileError(scene.file, "", "no triangle that has an area", "a surface");
  }
  return organ;
}

}  // namespace palpate::authoring
