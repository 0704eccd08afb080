// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <pybind11/typing.h>

#include <algorithm>

#include "array.h"
#include "bindings.h"
#include "palpate/scenario/ranges.h"
#include "palpate/scenario/read.h"
#include "palpate/scenario/write.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

using scenario::Array;
using scenario::Arrays;
using scenario::Container;
using scenario::Dtype;
using scenario::Scenario;
using scenario::Words;
using Path = std::filesystem::path;
using Release = py::call_guard<py::gil_scoped_release>;

/// In the order of Dtype.
constexpr std::array<const char*, 5> kDtypeNames = {"|u1", "<i4", "<i8", "<f4", "<f8"};

Array copy_array(const py::handle& source, const std::string& name) {
  const auto numpy = py::module_::import("numpy");
  const py::array given = numpy.attr("asarray")(source);
  std::string dtype = py::str(given.dtype().attr("str")).cast<std::string>();
  if (dtype[0] == '>') dtype[0] = '<';
  const auto known = std::find(kDtypeNames.begin(), kDtypeNames.end(), dtype);
  if (known == kDtypeNames.end()) {
    refuse(name, "dtype " + dtype, "|u1, <i4, <i8, <f4 or <f8");
  }
  const py::array exact = numpy.attr("asarray")(given, "dtype"_a = *known, "order"_a = "C");
  Array array{static_cast<Dtype>(known - kDtypeNames.begin()), {}, {}};
  array.shape.assign(exact.shape(), exact.shape() + exact.ndim());
  const auto* bytes = static_cast<const std::uint8_t*>(exact.data());
  array.bytes.assign(bytes, bytes + exact.nbytes());
  return array;
}

using SomeArrays = py::typing::Dict<py::str, py::object>;  ///< array-likes, taken as arguments
using ViewArrays = py::typing::Dict<py::str, py::array>;

Arrays copy_arrays(const SomeArrays& sources) {
  Arrays arrays;
  for (const auto& [key, source] : sources) {
    const std::string name = py::str(key).cast<std::string>();
    arrays.emplace(name, copy_array(source, name));
  }
  return arrays;
}

/// A dict of arrays that share memory with `arrays` and keep `owner` alive.
ViewArrays view_arrays(const Arrays& arrays, const py::object& owner) {
  ViewArrays views;
  for (const auto& [name, array] : arrays) {
    const py::dtype dtype(kDtypeNames[static_cast<std::size_t>(array.dtype)]);
    views[py::str(name)] = read_only(py::array(dtype, array.shape, array.bytes.data(), owner));
  }
  return views;
}

/// A property that is such a dict.
template <class Class, class Of>
void def_arrays(Class& cls, const char* name, Arrays Of::*member, const char* doc) {
  cls.def_property_readonly(
      name,
      [member](const py::object& self) {
        return view_arrays(self.cast<typename Class::type&>().*member, self);
      },
      doc);
}

using Languages = py::typing::Dict<py::str, Words>;

std::map<std::string, Words, std::less<>> copy_languages(const Languages& given) {
  std::map<std::string, Words, std::less<>> languages;
  for (const auto& [code, words] : given) {
    languages.emplace(code.cast<std::string>(), words.cast<const Words&>());
  }
  return languages;
}

Languages list_languages(const Scenario& scenario) {
  Languages listed;
  for (const auto& [code, words] : scenario.languages) listed[py::str(code)] = words;
  return listed;
}

/// As pickle keeps them: name to (dtype, shape, bytes).
py::dict pack_arrays(const Arrays& arrays) {
  py::dict packed;
  for (const auto& [name, array] : arrays) {
    packed[py::str(name)] = py::make_tuple(
        static_cast<int>(array.dtype), array.shape,
        py::bytes(reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size()));
  }
  return packed;
}

Arrays unpack_arrays(const py::dict& packed) {
  Arrays arrays;
  for (const auto& [name, member] : packed) {
    const auto [dtype, shape, bytes] =
        member.cast<std::tuple<int, decltype(Array::shape), std::string>>();
    if (dtype < 0 || dtype >= static_cast<int>(kDtypeNames.size())) {
      refuse("pickle", "dtype " + std::to_string(dtype), "one of the format's");
    }
    arrays.emplace(py::str(name),
                   Array{static_cast<Dtype>(dtype), shape, {bytes.begin(), bytes.end()}});
  }
  return arrays;
}

void bind_limits(py::module_& m) {
  m.attr("MOST_FILE_BYTES") = scenario::kMostFileBytes;
  m.attr("MOST_ARRAY_BYTES") = scenario::kMostArrayBytes;
  m.attr("MOST_MANIFEST_BYTES") = scenario::kMostManifestBytes;
  m.attr("MOST_ARRAYS") = scenario::kMostArrays;
  m.attr("MOST_DIMENSIONS") = scenario::kMostDimensions;
  m.attr("MOST_NAME_BYTES") = scenario::kMostNameBytes;
  m.attr("MOST_DEPTH") = scenario::kMostDepth;
  m.attr("MOST_TITLE_BYTES") = scenario::kMostTitleBytes;
  m.attr("MOST_TASK_BYTES") = scenario::kMostTaskBytes;
  m.attr("MOST_LANGUAGES") = scenario::kMostLanguages;
  m.attr("MOST_BODIES") = scenario::kMostBodies;
  m.attr("MOST_BODY_PAIRS") = scenario::kMostBodyPairs;
  m.attr("MOST_INSTRUMENTS") = scenario::kMostInstruments;
  m.attr("MOST_RIGID") = scenario::kMostRigid;
  m.attr("MOST_SCENERY") = scenario::kMostScenery;
  m.attr("MOST_HARD_VERTICES") = scenario::kMostHardVertices;
  m.attr("MOST_HARD_TRIANGLES") = scenario::kMostHardTriangles;
  m.attr("MOST_PARTICLES") = scenario::kMostParticles;
  m.attr("MOST_TRIANGLES") = scenario::kMostTriangles;
  m.attr("MOST_LINKS") = scenario::kMostLinks;
  m.attr("MOST_TETRAHEDRA") = scenario::kMostTetrahedra;
  m.attr("MOST_ELASTIC") = scenario::kMostElastic;
}

void bind_container(py::module_& m) {
  py::class_<Container> container(m, "Container",
                                  "All that a .palpate or .organ file holds: a JSON document and "
                                  "arrays by name.");
  container.def(py::init([](const std::string& format, int version, const std::string& content,
                            const SomeArrays& arrays) {
                  return Container{format, version, content, copy_arrays(arrays), ""};
                }),
                py::kw_only(), "format"_a, "version"_a, "content"_a = "{}",
                "arrays"_a = SomeArrays(),
                "Copies its arrays, which are of bytes, 4 or 8 byte integers or floats.");
  container.def_readwrite("format", &Container::format, "\"palpate\" or \"organ\".")
      .def_readwrite("version", &Container::version, "Of the format.")
      .def_readwrite("content", &Container::content, "JSON: one object.")
      .def_readonly("written_by", &Container::written_by,
                    "Filled by the reader: which program and version wrote the file.");
  def_arrays(
      container, "arrays", &Container::arrays,
      "By name, of the shapes and units that content says, in a new dict; views, read-only.");
  def_copy(container);
  container.def(py::pickle(
      [](const Container& self) {
        return py::make_tuple(self.format, self.version, self.content, pack_arrays(self.arrays),
                              self.written_by);
      },
      [](const py::tuple& packed) {
        return Container{packed[0].cast<std::string>(), packed[1].cast<int>(),
                         packed[2].cast<std::string>(), unpack_arrays(packed[3]),
                         packed[4].cast<std::string>()};
      }));
  def_repr(container, {"format", "version", "written_by"});
}

void bind_container_files(py::module_& m) {
  m.def(
      "read_container",
      [](const Path& path, const std::string& format, int newest_version) {
        return scenario::read_container(path.string(), format, newest_version);
      },
      "path"_a, "format"_a, "newest_version"_a, Release(),
      "Reads a file of format whose version is newest_version or older; older ones come as they "
      "are. Raises FileError for everything else and for everything that is wrong.");
  m.def(
      "write_container",
      [](const Path& path, const Container& container) {
        scenario::write_container(path.string(), container);
      },
      "path"_a, "container"_a, Release(),
      "Writes to a temporary name beside path, syncs, renames: whatever happens, path is what it "
      "was or all of the new file. Raises ValueError for what a reader would refuse, FileError "
      "where the disk refuses.");
  m.def(
      "unpack_container",
      [](const py::bytes& bytes, const std::string& file, const std::string& format,
         int newest_version) {
        const std::string_view view = bytes;
        const std::span<const std::uint8_t> span(reinterpret_cast<const std::uint8_t*>(view.data()),
                                                 view.size());
        const py::gil_scoped_release released;
        return scenario::unpack_container(span, file, format, newest_version);
      },
      "bytes"_a, "file"_a, "format"_a, "newest_version"_a,
      "The same from bytes; file is what refusals call them.");
  m.def(
      "pack_container",
      [](const Container& container) {
        const scenario::Bytes packed = scenario::pack_container(container);
        return py::bytes(reinterpret_cast<const char*>(packed.data()), packed.size());
      },
      "container"_a, "The bytes of the file. Equal containers give equal bytes.");
}

void bind_words(py::module_& m) {
  py::class_<Words> words(m, "Words", "Title and task of a scenario in one language.");
  words
      .def(py::init([](const std::string& title, const std::string& task) {
             return Words{title, task};
           }),
           "title"_a = "", "task"_a = "")
      .def_readonly("title", &Words::title, "Empty where it is not translated.")
      .def_readonly("task", &Words::task, "Empty where it is not translated.");
  def_value(words, &Words::title, &Words::task);
  def_repr(words, {"title", "task"});
}

void bind_scenario_type(py::module_& m) {
  py::class_<Scenario> made(m, "Scenario",
                            "What a trainee opens: a scene that ticks, what to do with it, and "
                            "what it was made from.");
  made.def(py::init([](const Scene& scene, const std::string& title, const std::string& task,
                       const std::string& authored, const SomeArrays& authored_arrays,
                       const Languages& languages, const std::string& assessment,
                       const SomeArrays& assessment_arrays) {
             return Scenario{title,
                             task,
                             scene,
                             authored,
                             copy_arrays(authored_arrays),
                             assessment,
                             copy_arrays(assessment_arrays),
                             0,
                             "",
                             copy_languages(languages)};
           }),
           py::kw_only(), "scene"_a, "title"_a = "", "task"_a = "", "authored"_a = "{}",
           "authored_arrays"_a = SomeArrays(), "languages"_a = Languages(), "assessment"_a = "",
           "assessment_arrays"_a = SomeArrays(), "Copies the scene, which build_scene made.");
  made.def_readwrite("title", &Scenario::title, "What a trainee sees it called.")
      .def_readwrite("task", &Scenario::task, "What the trainee is asked to do, in words.")
      .def_readonly("scene", &Scenario::scene, "The scene, ready to tick.")
      .def_readwrite("authored", &Scenario::authored,
                     "JSON: the designer's document, which only the editor reads.")
      .def_readwrite("assessment", &Scenario::assessment,
                     "JSON: what is asked of a trainee and judged; empty where nothing is.")
      .def_readonly("version", &Scenario::version,
                    "Filled by the reader: of the format, as the file had it.")
      .def_readonly("written_by", &Scenario::written_by,
                    "Filled by the reader: which program and version wrote the file.");
  def_arrays(made, "authored_arrays", &Scenario::authored_arrays,
             "What belongs to the document, of the shapes and units it says, in a new dict; views, "
             "read-only.");
  def_arrays(
      made, "assessment_arrays", &Scenario::assessment_arrays,
      "Of the assessment: places/ID, the vertices of a region, of shape (n,), in a new dict; "
      "views, read-only.");
  made.def_property_readonly("languages", &list_languages,
                             "Title and task in further languages, by code such as \"tr\" or "
                             "\"pt-BR\", in a new dict.");
  def_copy(made);
  made.def(py::pickle(
      [](const Scenario& self) {
        return py::make_tuple(self.title, self.task, self.scene, self.authored,
                              pack_arrays(self.authored_arrays), self.version, self.written_by,
                              list_languages(self), self.assessment,
                              pack_arrays(self.assessment_arrays));
      },
      [](const py::tuple& packed) {
        return Scenario{packed[0].cast<std::string>(), packed[1].cast<std::string>(),
                        packed[2].cast<Scene>(),       packed[3].cast<std::string>(),
                        unpack_arrays(packed[4]),      packed[8].cast<std::string>(),
                        unpack_arrays(packed[9]),      packed[5].cast<int>(),
                        packed[6].cast<std::string>(), copy_languages(packed[7].cast<Languages>())};
      }));
  def_repr(made, {"title", "scene"});
  m.def("find_words", &scenario::find_words, "scenario"_a, "language"_a,
        "Title and task in a language: those of its code, else of the same language elsewhere "
        "(\"tr\" for \"tr-TR\"), else those of the scenario itself, each by itself.");
}

void bind_scenario_files(py::module_& m) {
  m.def(
      "read", [](const Path& path) { return scenario::read(path.string()); }, "path"_a, Release(),
      "Reads a .palpate file of this or an older version: a scene that ticks with the very forces "
      "of the one that was written. Raises FileError for whatever is wrong, in a sentence.");
  m.def(
      "write",
      [](const Path& path, const Scenario& written) { scenario::write(path.string(), written); },
      "path"_a, "scenario"_a, Release(),
      "Writes a .palpate file, whole or not at all. Raises ValueError for what read() would "
      "refuse, FileError where the disk refuses.");
  m.def("check_ranges", &scenario::check_ranges, "scene"_a, Release(),
        "Raises ValueError where a number of a scene is smaller or larger than one of a file may "
        "be.");
  m.def(
      "list_ranges",
      [] {
        std::vector<std::tuple<std::string, std::string, double, double>> rows;
        for (const auto& [name, unit, least, most] : scenario::list_ranges()) {
          rows.emplace_back(name, unit, least, most);
        }
        return rows;
      },
      "Of every number of a file: its name, i for the number of a body or an instrument, its unit, "
      "least and most.");
  m.def("unpack", &scenario::unpack, "container"_a, "file"_a, Release(),
        "The scenario in a container; file is what refusals call it.");
  m.def("pack", &scenario::pack, "scenario"_a, Release(), "What the file holds.");
}

}  // namespace

void bind_scenario(py::module_& parent) {
  // palpate.scenario is the Python module of that name, which offers what stands here
  py::module_ m = parent.def_submodule(
      "_scenario", "The published file, .palpate, and the container it and .organ are.");
  bind_limits(m);
  bind_container(m);
  bind_container_files(m);
  bind_words(m);
  bind_scenario_type(m);
  bind_scenario_files(m);
  bind_assessment(m);
}

}  // namespace palpate::bindings
