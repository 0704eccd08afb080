// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unordered_map>
#include <unordered_set>

/// What every call from Python passes through, once all is bound.
///
/// pybind11 gives all its functions the same entry. Here it is wrapped, so that for every function,
/// method and property alike
/// - an argument that no overload takes is refused in one sentence (palpate/refused_call.py);
/// - what belongs to a running World, or to the tissue of a SoftBody, is shown read-only, as a tick
///   has copies of its own of much of it and would not heed what is written there; a function that
///   would write to it is refused.
/// An object whose __init__ was never called is refused wherever it is used. The words of every
/// function gain what its arguments are.
namespace palpate::bindings {

namespace py = pybind11;

namespace {

static_assert(PYBIND11_VERSION_HEX >= 0x03010000, "the entry below is that of pybind11 3.1");
using EntryPoint = PyObject* (*)(PyObject*, PyObject* const*, Py_ssize_t, PyObject*);

constexpr const char* kUnmade = "got an object made by __new__ alone";

/// What functions write to, by the class of the argument. tests/bindings/test_arguments.py compares
/// them with the sources.
struct Write {
  const char *function, *type;
};
constexpr std::array kWrites = {
    Write{"AabbTree.refit", "AabbTree"},
    Write{"ImplicitStepper.step", "State"},
    Write{"Load.add", "Load"},
    Write{"Load.clear", "Load"},
    Write{"attach_tool", "ToolState"},
    Write{"balance_tool", "Candidates"},
    Write{"balance_tool", "Load"},
    Write{"balance_tool", "ToolState"},
    Write{"check", "Guard"},
    Write{"find_candidates", "Candidates"},
    Write{"place_tool", "ToolState"},
    Write{"release_tool", "ToolState"},
    Write{"step", "State"},
};

struct Bound {
  enum class Kind { function, getter, setter } kind = Kind::function;
  std::string name;          ///< "Material.density"
  bool shows_parts = false;  ///< a getter of what ticks have their own copies of
};

/// Both live as long as the process, as the functions do.
std::unordered_map<PyObject*, Bound>& bound() {
  static auto* all = new std::unordered_map<PyObject*, Bound>;
  return *all;
}
std::unordered_set<PyObject*>& parts() {
  static auto* all = new std::unordered_set<PyObject*>;
  return *all;
}
EntryPoint& pybind11_entry() {
  static EntryPoint entry = nullptr;
  return entry;
}

bool is_part(PyObject* object) { return parts().count(object) > 0; }

/// An array may not be written to; a struct shows what is in it likewise, while it lives.
void show_as_part(PyObject* result) {
  const py::handle value(result);
  if (py::isinstance<py::tuple>(value)) {
    for (const py::handle element : value.cast<py::tuple>()) show_as_part(element.ptr());
  } else if (py::hasattr(value, "flags") && py::hasattr(value, "dtype")) {
    value.attr("flags").attr("writeable") = false;
  } else if (py::detail::get_type_info(Py_TYPE(result)) != nullptr &&
             parts().insert(result).second) {
    py::weakref(value, py::cpp_function([result](py::handle reference) {
                  parts().erase(result);
                  reference.dec_ref();
                }))
        .release();
  }
}

/// The sentence in place of what pybind11 says, which lists every signature and argument.
void reword(const std::string& name, PyObject* const* args, Py_ssize_t count, PyObject* keywords) {
  py::error_already_set raised;
  const std::string text = py::str(raised.value());
  if (text.find("(): incompatible ") == std::string::npos && text.rfind(kUnmade, 0) != 0) {
    raised.restore();
    return;
  }
  py::list given;
  py::dict named;
  for (Py_ssize_t i = 0; i < count; ++i) given.append(py::handle(args[i]));
  const Py_ssize_t more = keywords == nullptr ? 0 : PyTuple_GET_SIZE(keywords);
  for (Py_ssize_t i = 0; i < more; ++i) {
    named[py::handle(PyTuple_GET_ITEM(keywords, i))] = py::handle(args[count + i]);
  }
  const py::object refusal = py::module_::import("palpate.refused_call")
                                 .attr("explain")(name, text, py::tuple(given), named);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(refusal.ptr())), refusal.ptr());
}

/// The class of a part of a World that a function would write to; none if there is none.
const char* find_written_part(const std::string& function, PyObject* const* args,
                              Py_ssize_t count) {
  for (Py_ssize_t i = 0; i < count; ++i) {
    if (!is_part(args[i])) continue;
    const std::string type = py::str(py::type::of(args[i]).attr("__name__"));
    const auto write = std::find_if(kWrites.begin(), kWrites.end(), [&](const Write& known) {
      return function == known.function && type == known.type;
    });
    if (write != kWrites.end()) return write->type;
  }
  return nullptr;
}

PyObject* refuse_part(const std::string& function, const char* type) {
  PyErr_Format(PyExc_ValueError,
               "%s: got a %s that is part of a World, expected one that belongs to nothing else: "
               "ticks alone move what is in a World; copy.copy() gives one to work with",
               function.c_str(), type);
  return nullptr;
}

PyObject* enter(PyObject* self, PyObject* const* args, Py_ssize_t count, PyObject* keywords) {
  const auto found = bound().find(self);
  const Bound& function = found == bound().end() ? Bound{} : found->second;
  const bool of_part = count > 0 && !parts().empty() && is_part(args[0]);
  if (function.kind == Bound::Kind::setter && (of_part || function.shows_parts)) {
    PyErr_Format(PyExc_AttributeError,
                 "%s: this one is part of a Scene or a World, and a tick would not heed the "
                 "change, expected it to be made before the Scene is, or in a copy",
                 function.name.c_str());
    return nullptr;
  }
  if (function.kind == Bound::Kind::function && !parts().empty()) {
    const Py_ssize_t named = keywords == nullptr ? 0 : PyTuple_GET_SIZE(keywords);
    const char* part = find_written_part(function.name, args, count + named);
    if (part != nullptr) return refuse_part(function.name, part);
  }
  PyObject* result = pybind11_entry()(self, args, count, keywords);
  try {
    if (result == nullptr) {
      if (PyErr_ExceptionMatches(PyExc_TypeError)) reword(function.name, args, count, keywords);
    } else if (function.kind == Bound::Kind::getter && (of_part || function.shows_parts)) {
      show_as_part(result);
    }
  } catch (py::error_already_set& problem) {
    problem.restore();
    Py_CLEAR(result);
  }
  return result;
}

PyCFunctionObject* find_function(py::handle member) {
  if (!member || member.is_none()) return nullptr;
  if (PyObject_TypeCheck(member.ptr(), &PyStaticMethod_Type) != 0 ||
      PyObject_TypeCheck(member.ptr(), &PyClassMethod_Type) != 0) {
    return find_function(member.attr("__func__"));
  }
  const py::handle function = py::detail::get_function(member);
  if (PyCFunction_Check(function.ptr()) == 0) return nullptr;
  return reinterpret_cast<PyCFunctionObject*>(function.ptr());
}

/// Adds to the words of a function what its arguments are; `fields` are those of its class.
void document(PyMethodDef& function, const std::string& name, const py::list& fields) {
  const py::str doc(function.ml_doc == nullptr ? "" : function.ml_doc);
  const auto words = py::module_::import("palpate.argument_words")
                         .attr("document")(name, doc, fields)
                         .cast<std::string>();
  // freed by pybind11, as the words it replaces
  std::free(const_cast<char*>(function.ml_doc));
  function.ml_doc = strdup(words.c_str());
}

void wrap(py::handle member, const Bound& as, const py::list& fields = py::list()) {
  PyCFunctionObject* function = find_function(member);
  if (function == nullptr) return;
  PyCFunction& entry = function->m_ml->ml_meth;
  const auto wrapped = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&enter));
  const auto plain = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(pybind11_entry()));
  if (entry != plain && entry != wrapped) return;
  entry = wrapped;
  bound()[function->m_self] = as;
  if (as.kind == Bound::Kind::function) document(*function->m_ml, as.name, fields);
}

[[noreturn]] void* refuse_unmade(std::size_t) {
  throw py::type_error(std::string(kUnmade) + ", expected one made by calling its class");
}

/// Of a World everything, of a SoftBody its tissue.
bool shows_parts(const std::string& type, const std::string& member) {
  return type == "World" || (type == "SoftBody" && member == "tissue");
}

/// A sentence in place of what pickle says of a class that is no value.
void refuse_pickle(py::handle type, const std::string& name) {
  if (type.attr("__dict__").contains("__setstate__")) return;
  type.attr("__reduce_ex__") = py::cpp_function(
      [name](const py::object&, int) -> py::object {
        throw py::type_error(name +
                             ": got what runs, or holds what it cannot share, expected a value "
                             "to pickle: a Scene, a Record, a State, ...");
      },
      py::name("__reduce_ex__"), py::is_method(type), py::arg("protocol"),
      py::doc("Raises TypeError: not to be pickled."));
}

void visit(py::handle scope, const std::string& prefix) {
  const py::dict members(scope.attr("__dict__").attr("copy")());
  for (const auto& [key, member] : members) {
    const std::string name = py::str(key), full = prefix + name;
    if (PyModule_Check(member.ptr()) != 0) {
      visit(member, full + ".");
    } else if (PyType_Check(member.ptr()) != 0) {
      auto* type = reinterpret_cast<PyTypeObject*>(member.ptr());
      if (py::detail::type_info* info = py::detail::get_type_info(type)) {
        info->operator_new = &refuse_unmade;
        refuse_pickle(member, full);
        visit(member, full + ".");
      }
    } else if (PyObject_TypeCheck(member.ptr(), &PyProperty_Type) != 0) {
      const std::string type = prefix.substr(0, prefix.size() - 1);
      const bool part = shows_parts(type, name);
      wrap(member.attr("fget"), {Bound::Kind::getter, full, part});
      wrap(member.attr("fset"), {Bound::Kind::setter, full, part && type == "World"});
    } else {
      wrap(member, {Bound::Kind::function, full, false}, py::list(members));
    }
  }
}

}  // namespace

void refuse_overrides(const py::object& interface) {
  const py::cpp_function check(
      [](const py::object& subclass, const py::kwargs&) {
        py::module_::import("palpate.refused_call").attr("require_no_override")(subclass);
      },
      py::name("__init_subclass__"), py::doc("Refuses a class that overrides what C++ calls."));
  interface.attr("__init_subclass__") =
      py::reinterpret_steal<py::object>(PyClassMethod_New(check.ptr()));
}

void bind_calls(py::module_& m) {
  const py::cpp_function example([] {});
  auto* function = reinterpret_cast<PyCFunctionObject*>(example.ptr());
  if (function->m_ml->ml_flags != (METH_FASTCALL | METH_KEYWORDS)) {
    py::pybind11_fail("palpate: pybind11's functions are not entered as bind_calls expects");
  }
  pybind11_entry() =
      reinterpret_cast<EntryPoint>(reinterpret_cast<void (*)()>(function->m_ml->ml_meth));
  visit(m, "");
}

}  // namespace palpate::bindings
