// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace palpate::authoring {

/// read_mesh, join_parts and what they return.
void bind_read(pybind11::module_& m);

/// inspect_mesh, repair_mesh, find_self_intersecting_faces.
void bind_inspect(pybind11::module_& m);

/// import_mesh; after bind_read and bind_inspect, whose classes it returns.
void bind_import(pybind11::module_& m);

void bind_decimate(pybind11::module_& m);

/// fill_interior.
void bind_fill(pybind11::module_& m);

/// remove_crossings, stitch_borders, smooth_surface, wrap_surface, remesh_surface.
void bind_repair(pybind11::module_& m);

void bind_write(pybind11::module_& m);

}  // namespace palpate::authoring
