// SPDX-License-Identifier: GPL-3.0-or-later
//
// palpate-read-mesh FILE FORMAT MEMORY_BYTES CPU_SECONDS
//
// Reads one mesh file and writes what is in it to standard output, see scene_stream.h. Runs as a
// process of its own so that a hostile file can take down, hang or exhaust only this.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "palpate/authoring/read_mesh_child/confine.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/scene_writer.h"

namespace palpate::authoring {
namespace {

/// A tighter limit that the caller runs under stays.
void limit(int resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) std::_Exit(5);
  const rlim_t least = std::min(most, now.rlim_max);
  const rlimit both{least, least};
  if (setrlimit(resource, &both) != 0) std::_Exit(5);
}

/// From here on this process can only read the mesh and its folder, compute, and write to what is
/// open. Its libraries are loaded by now: the loader has done that before main().
void limit_myself(const std::string& path, rlim_t memory, rlim_t seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_AS, memory);
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NPROC, 0);
  confine_to(MeshFolder(path));
}

ImportedScene read_any(const std::string& path, const std::string& format) {
  if (format == "STL") {
    if (auto scene = read_binary_stl(path)) return *std::move(scene);
    return read_text_stl(path);
  }
  if (format == "OBJ") {
    if (auto scene = read_obj(path)) return *std::move(scene);
  }
  if (format == "OFF") return read_off(path);
  if (format == "PLY") return read_ply(path);
  return read_with_assimp(path, format);
}

int run(const std::string& path, const std::string& format, std::size_t memory) {
  try {
    write_scene(read_any(path, format), stdout);
  } catch (const FileError& refusal) {
    write_refusal(refusal, stdout);
  } catch (const std::bad_alloc&) {
    write_refusal(
        {path, "",
         "content that needs more than " + std::to_string(memory / 1'000'000) + " MB to read",
         "a mesh that fits"},
        stdout);
  } catch (const std::exception& problem) {
    write_refusal({path, "", std::string("content the reader fails on (") + problem.what() + ")",
                   "a readable " + format + " file"},
                  stdout);
  }
  return 0;
}

}  // namespace
}  // namespace palpate::authoring

int main(int count, char** words) {
  if (count != 5) {
    std::fputs("palpate-read-mesh FILE FORMAT MEMORY_BYTES CPU_SECONDS\n", stderr);
    return 2;
  }
  const std::size_t memory = std::strtoull(words[3], nullptr, 10);
  palpate::authoring::limit_myself(words[1], memory, std::strtoull(words[4], nullptr, 10));
  return palpate::authoring::run(words[1], words[2], memory);
}
