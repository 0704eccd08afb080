// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>

#include "array.h"

namespace palpate::bindings {

/// What every bound struct can do in Python: copy.copy, copy.deepcopy.
template <class Class>
void def_copy(Class& cls) {
  using T = typename Class::type;
  cls.def("__copy__", [](const T& self) { return T(self); });
  cls.def(
      "__deepcopy__", [](const T& self, const py::dict&) { return T(self); }, "memo"_a);
}

/// A repr that shows the named fields, as one would write the call that makes the value.
template <class Class>
void def_repr(Class& cls, std::initializer_list<const char*> fields) {
  const std::vector<const char*> names(fields);
  cls.def("__repr__", [names](const py::object& self) {
    std::string text = py::str(py::type::of(self).attr("__name__")).cast<std::string>() + "(";
    for (const char* name : names) {
      if (text.back() != '(') text += ", ";
      py::object value = self.attr(name);
      if (py::isinstance<py::array>(value)) value = value.attr("tolist")();
      text += std::string(name) + "=" + py::repr(value).cast<std::string>();
    }
    return text + ")";
  });
}

}  // namespace palpate::bindings
