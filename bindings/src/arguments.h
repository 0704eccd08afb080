// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>

/// Arguments that are arrays. A caster takes whatever Python gives; what that is is checked where
/// the argument's name and shape are known, so that every refusal is one sentence: argument, what
/// was found, and dtype and shape that were expected. TypeError for a dtype, ValueError for a
/// shape.
namespace palpate::bindings {

namespace py = pybind11;

/// "float64 of shape (4, 3)" of an array, "str 'abc'" of anything else, in short.
std::string describe_given(py::handle given);
[[noreturn]] void refuse_type(const std::string& where, const std::string& found,
                              const std::string& expected);

/// Numbers that are only read, of any width.
class Numbers {
 public:
  using Table = py::array_t<double, py::array::c_style>;

  Numbers() = default;
  explicit Numbers(py::object given) : given_(std::move(given)) {}

  /// All of them, `shape` being what a refusal says was expected; the table lives as long as this.
  const Table& read(const char* name, const std::string& shape) const;
  [[noreturn]] void refuse_shape(const char* name, const std::string& shape) const;

 private:
  py::object given_;
  mutable Table table_;
};

/// Integers of any width, never rounded from floats; where it makes sense, a mask.
class Integers {
 public:
  using Table = py::array_t<std::int64_t, py::array::c_style>;

  Integers() = default;
  explicit Integers(py::object given) : given_(std::move(given)) {}

  const Table& read(const char* name, const std::string& shape) const;
  [[noreturn]] void refuse_shape(const char* name, const std::string& shape) const;

  /// The length of a mask of booleans, nothing for other arguments.
  std::optional<std::size_t> mask_size(const char* name) const;
  /// The rows of that mask that are true.
  Integers find_true() const;

 private:
  py::object given_;
  mutable Table table_;
};

/// Arrays that are written to: of exactly this dtype, in C order and writable, as a copy would
/// swallow the result.
template <class Scalar>
class Written {
 public:
  using Table = py::array_t<Scalar, py::array::c_style>;

  Written() = default;
  explicit Written(py::object given) : given_(std::move(given)) {}

  Table read(const char* name, const std::string& shape) const;
  [[noreturn]] void refuse_shape(const char* name, const std::string& shape) const;

 private:
  py::object given_;
};
using NumbersOut = Written<double>;
using IntegersOut = Written<int>;

}  // namespace palpate::bindings

namespace pybind11::detail {

/// Takes any object at all; its words are those of the signature.
template <class Argument>
struct array_argument_caster {
  bool load(handle source, bool) {
    value = Argument(reinterpret_borrow<object>(source));
    return true;
  }
  template <class T>
  using cast_op_type = movable_cast_op_type<T>;
  operator Argument*() { return &value; }
  operator Argument&() { return value; }
  operator Argument&&() && { return std::move(value); }
  Argument value;
};

template <>
struct type_caster<palpate::bindings::Numbers> : array_argument_caster<palpate::bindings::Numbers> {
  static constexpr auto name =
      const_name("typing.Annotated[numpy.typing.ArrayLike, numpy.float64]");
};
template <>
struct type_caster<palpate::bindings::Integers>
    : array_argument_caster<palpate::bindings::Integers> {
  static constexpr auto name = const_name("typing.Annotated[numpy.typing.ArrayLike, numpy.int64]");
};
template <>
struct type_caster<palpate::bindings::NumbersOut>
    : array_argument_caster<palpate::bindings::NumbersOut> {
  static constexpr auto name = const_name("numpy.typing.NDArray[numpy.float64]");
};
template <>
struct type_caster<palpate::bindings::IntegersOut>
    : array_argument_caster<palpate::bindings::IntegersOut> {
  static constexpr auto name = const_name("numpy.typing.NDArray[numpy.int32]");
};

}  // namespace pybind11::detail
