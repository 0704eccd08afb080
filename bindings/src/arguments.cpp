// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"

#include "palpate/sim/base/private/refuse.h"

namespace palpate::bindings {

namespace {

py::module_ numpy() { return py::module_::import("numpy"); }

/// As NumPy sees it; what is ragged or no table at all is refused.
py::array to_array(const py::object& given, const char* name, const std::string& expected) {
  try {
    return numpy().attr("asarray")(given);
  } catch (const py::error_already_set& problem) {
    if (!problem.matches(PyExc_ValueError) && !problem.matches(PyExc_TypeError)) throw;
    refuse_type(name, describe_given(given), expected);
  }
}

/// As an array where it is one of numbers, else as what was given.
std::string describe_table(const py::array& array, const py::object& given) {
  const bool is_table = std::string("biufc").find(array.dtype().kind()) != std::string::npos;
  return describe_given(is_table ? py::object(array) : given);
}

/// Of a dtype among `kinds` (as of numpy.dtype.kind); an empty table may have any.
py::array read_kinds(const py::object& given, const char* name, const std::string& expected,
                     const char* kinds) {
  const py::array array = to_array(given, name, expected);
  const bool known = std::string(kinds).find(array.dtype().kind()) != std::string::npos;
  if (!known && !(array.size() == 0 && array.dtype().kind() == 'f')) {
    refuse_type(name, describe_table(array, given), expected);
  }
  return array;
}

std::string numbers_of(const std::string& shape) { return "numbers of shape " + shape; }
std::string integers_of(const std::string& shape) { return "integers of shape " + shape; }

template <class Scalar>
std::string written_of(const std::string& shape) {
  return "a writable C-ordered array of " +
         py::str(py::dtype::of<Scalar>().attr("name")).cast<std::string>() + ", shape " + shape;
}

}  // namespace

std::string describe_given(py::handle given) {
  if (py::isinstance<py::array>(given)) {
    return py::str(given.attr("dtype").attr("name")).cast<std::string>() + " of shape " +
           py::str(given.attr("shape")).cast<std::string>();
  }
  const py::object words = py::module_::import("palpate.refused_call").attr("describe")(given);
  return words.cast<std::string>();
}

void refuse_type(const std::string& where, const std::string& found, const std::string& expected) {
  throw py::type_error(where + ": got " + found + ", expected " + expected);
}

const Numbers::Table& Numbers::read(const char* name, const std::string& shape) const {
  const py::array array = read_kinds(given_, name, numbers_of(shape), "iuf");
  table_ = numpy().attr("ascontiguousarray")(array, py::dtype::of<double>()).cast<Table>();
  // NumPy gives a single number one dimension
  if (array.ndim() == 0) refuse_shape(name, shape);
  return table_;
}

void Numbers::refuse_shape(const char* name, const std::string& shape) const {
  refuse(name, describe_given(numpy().attr("asarray")(given_)), numbers_of(shape));
}

const Integers::Table& Integers::read(const char* name, const std::string& shape) const {
  const py::array array = read_kinds(given_, name, integers_of(shape), "iu");
  if (array.ndim() == 0) refuse_shape(name, shape);
  table_ = numpy().attr("ascontiguousarray")(array, py::dtype::of<std::int64_t>()).cast<Table>();
  return table_;
}

void Integers::refuse_shape(const char* name, const std::string& shape) const {
  refuse(name, describe_given(numpy().attr("asarray")(given_)), integers_of(shape));
}

std::optional<std::size_t> Integers::mask_size(const char* name) const {
  const py::array array = to_array(given_, name, integers_of("(n,)"));
  if (array.dtype().kind() != 'b') return {};
  if (array.ndim() != 1) refuse(name, describe_given(given_), "a mask of one dimension");
  return static_cast<std::size_t>(array.size());
}

Integers Integers::find_true() const { return Integers(numpy().attr("flatnonzero")(given_)); }

template <class Scalar>
typename Written<Scalar>::Table Written<Scalar>::read(const char* name,
                                                      const std::string& shape) const {
  if (!py::isinstance<Table>(given_) || !given_.attr("flags").attr("writeable").cast<bool>()) {
    std::string found = describe_given(given_);
    if (py::isinstance<py::array>(given_)) {
      if (!given_.attr("flags").attr("c_contiguous").cast<bool>()) found += ", not in C order";
      if (!given_.attr("flags").attr("writeable").cast<bool>()) found += ", read-only";
    }
    refuse_type(name, found, written_of<Scalar>(shape));
  }
  return py::reinterpret_borrow<Table>(given_);
}

template <class Scalar>
void Written<Scalar>::refuse_shape(const char* name, const std::string& shape) const {
  refuse(name, describe_given(given_), written_of<Scalar>(shape));
}

template class Written<double>;
template class Written<int>;

}  // namespace palpate::bindings
