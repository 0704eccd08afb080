// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/import_mesh.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

using Text = std::optional<std::string>;

void bind_scene(py::module_& m) {
  py::class_<ImportedPart>(m, "ImportedPart",
                           "One named part of a scene, its node's transforms applied, in the "
                           "file's units and axes.")
      .def_readonly("name", &ImportedPart::name)
      .def_readonly("mesh", &ImportedPart::mesh);
  py::class_<ImportedScene>(m, "ImportedScene",
                            "What a mesh file holds, before its unit and axes are chosen.")
      .def_readonly("file", &ImportedScene::file)
      .def_readonly("format", &ImportedScene::format)
      .def_readonly("parts", &ImportedScene::parts)
      .def_readonly("unit", &ImportedScene::unit, "Stated by the file or its format, or None.")
      .def_readonly("up", &ImportedScene::up, "Stated by the file or its format, or None.")
      .def_readonly("notes", &ImportedScene::notes,
                    "What was odd about the file but could be read all the same.");
}

void bind_joined(py::module_& m) {
  py::class_<JoinedSurface>(m, "JoinedSurface",
                            "Chosen parts welded into one surface in metres, z up.")
      .def_readonly("mesh", &JoinedSurface::mesh)
      .def_readonly("parts", &JoinedSurface::parts, "The names of the parts it is made of.")
      .def_readonly("unit", &JoinedSurface::unit, "Of the file.")
      .def_readonly("unit_guessed", &JoinedSurface::unit_guessed)
      .def_readonly("unit_reason", &JoinedSurface::unit_reason)
      .def_readonly("up", &JoinedSurface::up, "Of the file.")
      .def_readonly("up_guessed", &JoinedSurface::up_guessed)
      .def_readonly("up_reason", &JoinedSurface::up_reason)
      .def_readonly("welded_vertices", &JoinedSurface::welded_vertices,
                    "Vertices that became one with another, or that no triangle used.");
}

void bind_imported(py::module_& m) {
  py::class_<ImportedMesh>(m, "ImportedMesh",
                           "An organ's surface as it can be shown, and how it came to be.")
      .def_readonly("mesh", &ImportedMesh::mesh)
      .def_readonly("joined", &ImportedMesh::joined)
      .def_readonly("repaired", &ImportedMesh::repaired)
      .def_readonly("report", &ImportedMesh::report, "Of the repaired mesh.");
}

using Words = std::vector<std::string>;

ReadOptions read_options(const std::filesystem::path& reader, const Words& words, double time_limit,
                         std::size_t memory_limit) {
  ReadOptions options;
  options.words = words;
  options.reader = reader;
  options.time_limit = time_limit;
  options.memory_limit = memory_limit;
  return options;
}

}  // namespace

void bind_read(py::module_& m) {
  bind_scene(m);
  bind_joined(m);
  m.def(
      "read_mesh",
      [](const std::filesystem::path& path, double time_limit, std::size_t memory_limit,
         const std::filesystem::path& reader, const Words& words) {
        return read_mesh(path, read_options(reader, words, time_limit, memory_limit));
      },
      "path"_a, py::kw_only(), "time_limit"_a = ReadOptions().time_limit,
      "memory_limit"_a = ReadOptions().memory_limit, "reader"_a, "words"_a = Words(),
      py::call_guard<py::gil_scoped_release>(),
      "Read a mesh file by the program `reader`, told `words` before the file's name, which gets "
      "time_limit [s] and memory_limit [bytes]. Raises FileError.");
  m.def(
      "join_parts",
      [](const ImportedScene& scene, const std::vector<std::string>& parts, const Text& unit,
         const Text& up) {
        return join_parts(scene, {parts, unit, up});
      },
      "scene"_a, py::kw_only(), "parts"_a = std::vector<std::string>(), "unit"_a = Text(),
      "up"_a = Text(), py::call_guard<py::gil_scoped_release>(),
      "Take the named parts (all when empty) together, weld them, turn them to metres and z up.");
}

void bind_import(py::module_& m) {
  bind_imported(m);
  m.def(
      "import_scene",
      [](const ImportedScene& scene, const std::vector<std::string>& parts, const Text& unit,
         const Text& up) {
        return import_scene(scene, {parts, unit, up});
      },
      "scene"_a, py::kw_only(), "parts"_a = std::vector<std::string>(), "unit"_a = Text(),
      "up"_a = Text(), py::call_guard<py::gil_scoped_release>(),
      "Join, repair, orient and measure what was read. Raises FileError where nothing is left "
      "that has an area.");
}

}  // namespace palpate::authoring
