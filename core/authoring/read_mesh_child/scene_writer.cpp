// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/scene_writer.h"

#include <cstdlib>
#include <limits>

namespace palpate::authoring {
namespace {

// a reader that cannot write ends at once: the other side has gone
void put_bytes(const void* from, std::size_t size, std::FILE* out) {
  if (size > 0 && std::fwrite(from, 1, size, out) != size) std::_Exit(3);
}

template <class T>
void put(const T& value, std::FILE* out) {
  put_bytes(&value, sizeof value, out);
}

void put_count(std::size_t count, std::FILE* out) {
  if (count > std::numeric_limits<std::int32_t>::max()) std::_Exit(4);
  put(static_cast<std::uint32_t>(count), out);
}

template <class List>
void put_all(const List& list, std::FILE* out) {
  put_count(list.size(), out);
  put_bytes(list.data(), list.size() * sizeof(*list.data()), out);
}

void end(std::FILE* out) {
  put(kStreamMagic, out);
  if (std::fflush(out) != 0) std::_Exit(3);
}

}  // namespace

void write_scene(const ImportedScene& scene, std::FILE* out) {
  put(kStreamMagic, out);
  put(kStreamScene, out);
  put_all(scene.unit.value_or(""), out);
  put_all(scene.up.value_or(""), out);
  put_count(scene.notes.size(), out);
  for (const std::string& note : scene.notes) put_all(note, out);
  put_count(scene.parts.size(), out);
  for (const ImportedPart& part : scene.parts) {
    put_all(part.name, out);
    put_count(part.groups.size(), out);
    for (const std::string& group : part.groups) put_all(group, out);
    put_count(part.colour ? 3 : 0, out);
    if (part.colour) put(*part.colour, out);
    put_all(part.mesh.vertices, out);
    put_all(part.mesh.triangles, out);
    put_all(part.paint, out);
    put_all(part.pictures, out);
  }
  put_count(scene.pictures.size(), out);
  for (const Picture& picture : scene.pictures) {
    put_all(picture.name, out);
    put_all(picture.bytes, out);
  }
  put_all(scene.filling.vertices, out);
  put_all(scene.filling.tetrahedra, out);
  end(out);
}

void write_refusal(const FileError& refusal, std::FILE* out) {
  put(kStreamMagic, out);
  put(kStreamRefusal, out);
  put_all(refusal.where, out);
  put_all(refusal.got, out);
  put_all(refusal.expected, out);
  end(out);
}

}  // namespace palpate::authoring
