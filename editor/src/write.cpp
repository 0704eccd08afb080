// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/write_mesh.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

void bind_write(py::module_& m) {
  m.def("write_mesh", &write_mesh, "path"_a, "mesh"_a, py::call_guard<py::gil_scoped_release>(),
        "Write .obj (17 digits) or .stl (binary) in metres with z up, whole or not at all.");
}

}  // namespace palpate::authoring
