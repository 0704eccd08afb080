// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/write_mesh.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "palpate/authoring/house_mark.h"
#include "palpate/sim/base/error.h"

namespace palpate::authoring {
namespace {

std::string format_obj(const SurfaceMesh& mesh) {
  std::string text = std::string("# ") + kHouseMark + "\n";
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
  std::string bytes(kHouseMark);
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

[[noreturn]] void throw_refused(const std::filesystem::path& path) {
  throw FileError(path.string(), "", std::strerror(errno), "a place to write a mesh to");
}

/// A name no other writer uses at this moment.
std::string name_beside(const std::filesystem::path& path) {
  static std::atomic<int> count = 0;
  return path.string() + "." + std::to_string(getpid()) + "." + std::to_string(count++) + ".part";
}

/// A new file beside its final place; gone again unless it was renamed.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& path)
      : path_(path),
        name_(name_beside(path)),
        file_(open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw_refused(path_);
  }

  ~NewFile() {
    close(file_);
    if (!renamed_) unlink(name_.c_str());
  }

  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw_refused(path_);
      done += static_cast<std::size_t>(count);
    }
  }

  void finish() {
    if (fsync(file_) != 0) throw_refused(path_);
    if (std::rename(name_.c_str(), path_.c_str()) != 0) throw_refused(path_);
    renamed_ = true;
    sync_folder();
  }

 private:
  /// Makes the rename survive a power cut, where the file system can do that; the file is safe.
  void sync_folder() const {
    const std::filesystem::path folder = std::filesystem::absolute(path_).parent_path();
    const int handle = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return;
    fsync(handle);
    close(handle);
  }

  std::filesystem::path path_;
  std::string name_;
  int file_;
  bool renamed_ = false;
};

}  // namespace

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh) {
  const std::string extension = path.extension().string();
  if (extension != ".obj" && extension != ".stl") {
    throw std::invalid_argument(path.string() + ": extension must be .obj or .stl, got '" +
                                extension + "'");
  }
  validate(mesh);
  NewFile file(path);
  file.write(extension == ".obj" ? format_obj(mesh) : format_stl(mesh));
  file.finish();
}

}  // namespace palpate::authoring
