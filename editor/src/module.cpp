// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "calls.h"

PYBIND11_MODULE(_authoring, m) {
  m.doc() =
      "From foreign mesh files to clean surfaces, and tetrahedra inside them (assimp, OpenMesh, "
      "CGAL).";
  // SurfaceMesh and FileError are known to Python by the simulator's module
  pybind11::module_::import("palpate");
  palpate::authoring::bind_read(m);
  palpate::authoring::bind_inspect(m);
  palpate::authoring::bind_import(m);
  palpate::authoring::bind_decimate(m);
  palpate::authoring::bind_fill(m);
  palpate::authoring::bind_repair(m);
  palpate::authoring::bind_write(m);
  palpate::bindings::bind_calls(m);
}
