// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/response/response.h"

#include "array.h"
#include "bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

/// A read-only view of a table of floats with as many columns.
py::array_t<float> view_floats(const CacheAligned<float>& table, int columns,
                               const py::object& owner) {
  const auto rows = columns == 0 ? 0 : static_cast<py::ssize_t>(table.size()) / columns;
  return read_only(
      py::array_t<float>({rows, static_cast<py::ssize_t>(columns)}, table.data(), owner));
}

void bind_size(py::module_& m) {
  py::class_<ResponseSize> size(
      m, "ResponseSize",
      "How much of a linear solid's response there is to keep; known before it is solved for.");
  size.def(py::init([](int moved, int pushed, std::size_t bytes) {
             return ResponseSize{moved, pushed, bytes};
           }),
           py::kw_only(), "moved"_a = 0, "pushed"_a = 0, "bytes"_a = 0);
  size.def_readwrite("moved", &ResponseSize::moved,
                     "Particles that carry the surface and are not held.")
      .def_readwrite("pushed", &ResponseSize::pushed, "Those of them within reach of pushes.")
      .def_readwrite("bytes", &ResponseSize::bytes,
                     "Of the table: 3 moved x 3 pushed numbers of 4 bytes.");
  def_value(size, &ResponseSize::moved, &ResponseSize::pushed, &ResponseSize::bytes);
  def_repr(size, {"moved", "pushed", "bytes"});
}

}  // namespace

void bind_response(py::module_& m) {
  bind_size(m);
  py::class_<Response, std::shared_ptr<Response>> response(
      m, "Response",
      "How a linear solid answers when nothing of it swings: displacements of the particles that "
      "carry its surface under forces on those that pushes reach. Made by build_response.");
  response.def_readonly("size", &Response::size, "How much there is of it.")
      .def_property_readonly(
          "compliance",
          [](const py::object& self) {
            const auto& its = self.cast<const Response&>();
            return view_floats(its.compliance, 3 * its.size.moved, self);
          },
          "[m/N] shape (3 pushed, 3 moved): row 3c + k is what all of the moved do under 1 N on c "
          "along axis k; a view, read-only.")
      .def_property_readonly(
          "sag",
          [](const py::object& self) {
            return view_floats(self.cast<const Response&>().sag, 3, self);
          },
          "[m] under gravity alone, shape (moved, 3); a view, read-only.")
      .def_readonly("damping_time", &Response::damping_time, "[s]");
  def_table(response, "particle", &Response::particle,
            "Of the moved, ascending, shape (moved,); a view.");
  def_table(response, "row", &Response::row,
            "Per particle of the model, shape (n,): among the moved, or -1; a view.");
  def_table(response, "column", &Response::column,
            "Per particle, shape (n,): among the pushed, or -1; a view.");
  def_table(response, "self_compliance", &Response::self_compliance,
            "[m/N] per vertex of the surface, shape (n,), of itself; 0 out of reach; a view.");
  m.attr("MOST_RESPONSE_BYTES") = kMostResponseBytes;
  m.attr("SHALLOW") = kShallow;
  m.def("measure_response", &measure_response, "model"_a,
        "How much of a linear solid's response there is to keep. Raises ValueError for another "
        "model.");
  m.def("build_response", &build_response, "model"_a, "gravity"_a = Vec3::Zero().eval(),
        "most"_a = kMostResponseBytes, py::call_guard<py::gil_scoped_release>(),
        "Solves for the response of a linear solid in gravity [m/s²]. Raises ValueError for "
        "another model, for a table of more than most bytes, before anything is solved, and for a "
        "body that is not held.");
}

}  // namespace palpate::bindings
