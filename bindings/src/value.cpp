// SPDX-License-Identifier: BSD-3-Clause
#include "value.h"

namespace palpate::bindings {

namespace {

constexpr std::size_t kLongest = 190;   // [characters] of a repr
constexpr py::ssize_t kFewNumbers = 9;  // an array of so many is shown itself

std::string show(const py::object& value) {
  if (!py::isinstance<py::array>(value)) return py::repr(value).cast<std::string>();
  const py::array array = value;
  if (array.size() <= kFewNumbers) return py::repr(array.attr("tolist")()).cast<std::string>();
  return "<" + py::str(array.dtype().attr("name")).cast<std::string>() + " " + shape_of(array) +
         ">";
}

}  // namespace

std::string write_call(const py::object& self, const std::vector<const char*>& fields) {
  std::string text = py::str(py::type::of(self).attr("__name__")).cast<std::string>() + "(";
  for (const char* name : fields) {
    if (text.back() != '(') text += ", ";
    const std::string field = std::string(name) + "=" + show(self.attr(name));
    if (text.size() + field.size() > kLongest) return text + "...)";
    text += field;
  }
  return text + ")";
}

}  // namespace palpate::bindings
