// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::authoring {

/// The folder of a mesh file, and what lies below it: all that a file may refer to.
class MeshFolder {
 public:
  explicit MeshFolder(const std::filesystem::path& mesh);

  /// Whether `path` is the mesh itself or a plain file beside or below it, links followed.
  bool holds(const std::filesystem::path& path) const;

  const std::filesystem::path& mesh() const { return mesh_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path mesh_, folder_;  // as they are once all links are followed
};

/// From here on the kernel lets this process open nothing but the mesh and what lies in its folder,
/// for reading, and connect to nobody [Landlock, landlock(7)]. Does nothing where the kernel has no
/// Landlock; ends the process where it has and does not obey.
void confine_to(const MeshFolder& folder);

}  // namespace palpate::authoring
