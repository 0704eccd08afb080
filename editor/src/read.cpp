// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>

#include <cstring>

#include "bindings.h"
#include "palpate/authoring/combine_parts.h"
#include "palpate/authoring/import_mesh.h"
#include "palpate/authoring/inspect_mesh.h"
#include "palpate/authoring/nest_parts.h"

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
      .def_readonly("mesh", &ImportedPart::mesh)
      .def_readonly("groups", &ImportedPart::groups,
                    "Names of the groups it stands under, outermost first.")
      .def_readonly("colour", &ImportedPart::colour,
                    "sRGB, 0 to 1, of its material or the mean of its vertices', or None.")
      .def_property_readonly(
          "paint",
          [](const ImportedPart& part) {
            static_assert(sizeof(CornerPaint) == 5 * sizeof(float));
            py::array_t<float> rows({static_cast<py::ssize_t>(part.paint.size()), py::ssize_t{5}});
            if (!part.paint.empty()) {
              std::memcpy(rows.mutable_data(), part.paint.data(),
                          part.paint.size() * sizeof(CornerPaint));
            }
            return rows;
          },
          "(3 t, 5) of each corner u, v, 0 to 1 from the picture's lower left, and r, g, b, sRGB, "
          "which multiply the picture's; no rows where all are alike.")
      .def_property_readonly(
          "pictures",
          [](const ImportedPart& part) {
            return py::array_t<int>(static_cast<py::ssize_t>(part.pictures.size()),
                                    part.pictures.data());
          },
          "(t,) The picture of each triangle, beside `paint`; -1 for none.");
  py::class_<Picture>(m, "Picture", "What surfaces are painted with, as its file has it.")
      .def_readonly("name", &Picture::name)
      .def_property_readonly("bytes", [](const Picture& picture) {
        return py::bytes(picture.bytes.data(), picture.bytes.size());
      });
  py::class_<PartPlace>(m, "PartPlace", "How a part lies to the others of its file.")
      .def_readonly("inside", &PartPlace::inside,
                    "The smallest part it lies inside of; -1 for none.")
      .def_readonly("crosses", &PartPlace::crosses,
                    "Parts whose triangles cross its own, ascending.")
      .def_readonly("closed", &PartPlace::closed)
      .def_readonly("crossing_faces", &PartPlace::crossing_faces,
                    "Of its own triangles that cross each other; -1 where counting would take too "
                    "long.");
  py::class_<ImportedScene>(m, "ImportedScene",
                            "What a mesh file holds, before its unit and axes are chosen.")
      .def_readonly("file", &ImportedScene::file)
      .def_readonly("format", &ImportedScene::format)
      .def_readonly("parts", &ImportedScene::parts)
      .def_readonly("unit", &ImportedScene::unit, "Stated by the file or its format, or None.")
      .def_readonly("up", &ImportedScene::up, "Stated by the file or its format, or None.")
      .def_readonly("notes", &ImportedScene::notes,
                    "What was odd about the file but could be read all the same.")
      .def_readonly("pictures", &ImportedScene::pictures)
      .def_readonly("filling", &ImportedScene::filling,
                    "Tetrahedra whose outer faces the parts are; empty where the file has none.");
}

void bind_joined(py::module_& m) {
  py::class_<JoinedSurface>(m, "JoinedSurface",
                            "Chosen parts welded into one surface in metres, z up.")
      .def_readonly("mesh", &JoinedSurface::mesh)
      .def_readonly("parts", &JoinedSurface::parts, "The names of the parts it is made of.")
      .def_readonly("subtracted", &JoinedSurface::subtracted,
                    "The names of the parts that were taken away.")
      .def_readonly("unit", &JoinedSurface::unit, "Of the file.")
      .def_readonly("unit_guessed", &JoinedSurface::unit_guessed)
      .def_readonly("unit_reason", &JoinedSurface::unit_reason)
      .def_readonly("up", &JoinedSurface::up, "Of the file.")
      .def_readonly("up_guessed", &JoinedSurface::up_guessed)
      .def_readonly("up_reason", &JoinedSurface::up_reason)
      .def_readonly("welded_vertices", &JoinedSurface::welded_vertices,
                    "Vertices that became one with another, or that no triangle used.")
      .def_readonly("welded_across", &JoinedSurface::welded_across,
                    "Of those, by the stated tolerance.")
      .def_readonly("largest_move", &JoinedSurface::largest_move,
                    "[m] of a vertex by the stated tolerance.")
      .def_readonly("notes", &JoinedSurface::notes,
                    "What parts had to be changed in to be united, for people.");
}

void bind_combined(py::module_& m) {
  py::class_<CombinedParts>(m, "CombinedParts", "One solid of many.")
      .def_readonly("mesh", &CombinedParts::mesh)
      .def_readonly("notes", &CombinedParts::notes,
                    "What had to be changed in them to be united, for people.");
}

void bind_imported(py::module_& m) {
  py::class_<ImportedMesh>(m, "ImportedMesh",
                           "An organ's surface as it can be shown, and how it came to be.")
      .def_readonly("mesh", &ImportedMesh::mesh)
      .def_readonly("joined", &ImportedMesh::joined)
      .def_readonly("repaired", &ImportedMesh::repaired)
      .def_property_readonly(
          "report", [](const ImportedMesh& organ) { return inspect_mesh(organ.mesh); },
          "Of the mesh, measured as it is asked for.");
}

using Words = std::vector<std::string>;

constexpr const char* kJoinArguments =
    " Args: parts, names of parts or groups (all when empty); unit and up, else stated or guessed; "
    "weld [m], across parts; unite, the parts as solids become one; subtract, parts whose inside "
    "is taken away.";

/// Binds a function of a scene and JoinOptions with its options by name.
template <class Function>
void def_join(py::module_& m, const char* name, Function function, const std::string& doc) {
  m.def(
      name,
      [function](const ImportedScene& scene, const Words& parts, const Text& unit, const Text& up,
                 std::optional<double> weld, bool unite, const Words& subtract) {
        return function(scene, {parts, unit, up, weld, unite, subtract});
      },
      "scene"_a, py::kw_only(), "parts"_a = Words(), "unit"_a = Text(), "up"_a = Text(),
      "weld"_a = std::optional<double>(), "unite"_a = false, "subtract"_a = Words(),
      py::call_guard<py::gil_scoped_release>(), (doc + kJoinArguments).c_str());
}

ReadOptions read_options(const std::filesystem::path& reader, const std::string& format,
                         const Words& words, double time_limit, std::size_t memory_limit) {
  ReadOptions options;
  options.format = format;
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
  bind_combined(m);
  m.def(
      "read_mesh",
      [](const std::filesystem::path& path, double time_limit, std::size_t memory_limit,
         const std::filesystem::path& reader, const std::string& format, const Words& words) {
        return read_mesh(path, read_options(reader, format, words, time_limit, memory_limit));
      },
      "path"_a, py::kw_only(), "time_limit"_a = ReadOptions().time_limit,
      "memory_limit"_a = ReadOptions().memory_limit, "reader"_a, "format"_a = std::string(),
      "words"_a = Words(), py::call_guard<py::gil_scoped_release>(),
      "Read a mesh file by the program `reader`, told `words` before the file's name and `format` "
      "behind it, in place of its extension where it is not empty; time_limit [s] and memory_limit "
      "[bytes] are the program's. Raises FileError.");
  def_join(m, "join_parts", join_parts,
           "Take parts together, welded or as solids, and turn them to metres and z up.");
  m.def("find_places", &find_places, "scene"_a, py::call_guard<py::gil_scoped_release>(),
        "How the parts of a scene lie to each other.");
  m.def("unite_shells", &unite_shells, "mesh"_a, py::call_guard<py::gil_scoped_release>(),
        "The pieces of a surface as one solid; those that face inwards are cavities. Raises "
        "ValueError where one is open or crosses itself.");
}

void bind_import(py::module_& m) {
  bind_imported(m);
  def_join(m, "import_scene", import_scene,
           "Join, repair and orient what was read. Raises FileError where nothing is left "
           "that has an area.");
}

}  // namespace palpate::authoring
