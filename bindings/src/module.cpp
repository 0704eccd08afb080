// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

PYBIND11_MODULE(_sim, m) {
  using namespace palpate::bindings;

  m.doc() =
      "Soft-tissue organ models that can be felt: palpate::sim under its own names.\n\n"
      "SI units throughout. Arrays are views of the library's own memory. Work that takes long "
      "releases Python's lock, and nothing here is locked against a second thread: one object, "
      "one thread at a time.";
  m.attr("__version__") = PALPATE_VERSION;

  bind_base(m);
  bind_mesh(m);
  bind_model(m);
  bind_dynamics(m);
  bind_contact(m);
  bind_tick(m);
  bind_session(m);
  bind_bench(m);
  bind_scenario(m);
  bind_calls(m);
}
