// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "array.h"

namespace palpate::bindings {

/// Options of a builder as Python holds them: which vertices are fixed may be given by a mask,
/// whose length can only be compared with the mesh once there is one.
template <class Options>
struct Chosen : Options {
  std::optional<std::size_t> mask_size;  ///< of the mask that `fixed` was given by, if it was
};

template <class Options>
void set_fixed(Chosen<Options>& options, const Integers& fixed) {
  options.mask_size = fixed.mask_size("fixed");
  options.fixed = copy_indices(fixed, "fixed", options.mask_size);
}

/// The options for a mesh of so many vertices.
template <class Options>
const Options& fit_mask(const Chosen<Options>& options, std::size_t vertices) {
  if (options.mask_size && *options.mask_size != vertices) {
    refuse("options.fixed", "a mask of " + std::to_string(*options.mask_size) + " booleans",
           "indices, or a mask of " + std::to_string(vertices) + ", one per vertex");
  }
  return options;
}

}  // namespace palpate::bindings
