// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "palpate/sim/base/private/whole_file.h"

namespace palpate::bindings {

namespace py = pybind11;

namespace {

/// FileError, NotDurable and DeviceError become their twins of bindings/palpate/error.py.
void translate(std::exception_ptr thrown) {
  const auto raise = [](const char* name, const auto&... arguments) {
    const py::object type = py::module_::import("palpate.error").attr(name);
    PyErr_SetObject(type.ptr(), type(arguments...).ptr());
  };
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const NotDurable& e) {
    raise("NotDurable", e.file, e.where, e.got, e.expected);
  } catch (const FileError& e) {
    raise("FileError", e.file, e.where, e.got, e.expected);
  } catch (const DeviceError& e) {
    raise("DeviceError", e.what());
  }
}

}  // namespace

void bind_base(py::module_&) { py::register_exception_translator(&translate); }

}  // namespace palpate::bindings
